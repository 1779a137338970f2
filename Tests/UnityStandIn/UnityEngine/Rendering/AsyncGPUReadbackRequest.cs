// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;
using Unity.Collections;
using UnityStandIn;

namespace UnityEngine.Rendering
{
    public struct AsyncGPUReadbackRequest
    {
        private readonly Color32[] _pixels;

        internal AsyncGPUReadbackRequest(int width, int height, Color32[] pixels)
        {
            this.width = width;
            this.height = height;
            _pixels = pixels;
        }

        public int width { get; }

        public int height { get; }

        public bool hasError => GraphicsCard.Fails;

        public NativeArray<T> GetData<T>(int layer = 0) where T : struct => new NativeArray<T>((T[])(Array)_pixels);
    }
}
