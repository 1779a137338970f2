// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;

namespace UnityEngine
{
    /// <summary>Four bytes a pixel, rows from the bottom; what was set is seen once Apply was called.</summary>
    public sealed class Texture2D : Texture
    {
        private readonly byte[] _pixels;

        public Texture2D(int width, int height, TextureFormat textureFormat, bool mipChain)
        {
            base.width = width;
            base.height = height;
            _pixels = new byte[width * height * 4];
        }

        /// <summary>What a projector would show.</summary>
        internal byte[] Shown { get; private set; } = new byte[0];

        public void LoadRawTextureData(byte[] data) => Array.Copy(data, _pixels, _pixels.Length);

        public void Apply(bool updateMipmaps) => Shown = (byte[])_pixels.Clone();
    }
}
