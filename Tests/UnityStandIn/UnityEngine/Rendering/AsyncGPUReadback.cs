// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;
using UnityStandIn;

namespace UnityEngine.Rendering
{
    public static class AsyncGPUReadback
    {
        public static AsyncGPUReadbackRequest Request(Texture src, int mipIndex, TextureFormat dstFormat, Action<AsyncGPUReadbackRequest> callback = null)
        {
            var request = new AsyncGPUReadbackRequest(src.width, src.height, (Color32[])((RenderTexture)src).Content.Clone());
            GraphicsCard.Queue(request, callback);
            return request;
        }
    }
}
