// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityStandIn;

namespace UnityEngine
{
    /// <summary>Holds what was drawn last, rows from the bottom.</summary>
    public class RenderTexture : Texture
    {
        public RenderTexture(int width, int height, int depth)
        {
            base.width = width;
            base.height = height;
            Content = new Color32[width * height];
            GraphicsCard.Textures++;
        }

        internal Color32[] Content { get; set; }

        public static RenderTexture GetTemporary(int width, int height, int depthBuffer, RenderTextureFormat format) => new RenderTexture(width, height, depthBuffer);

        public static void ReleaseTemporary(RenderTexture temp) => temp.Release();

        public void Release() => GraphicsCard.Textures--;
    }
}
