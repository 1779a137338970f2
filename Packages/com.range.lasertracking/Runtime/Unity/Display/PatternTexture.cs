using System;
using LaserTracking.Imaging;
using LaserTracking.Patterns;
using UnityEngine;
using Image = LaserTracking.Imaging.Image;
using Object = UnityEngine.Object;

namespace LaserTracking.Unity
{
    /// <summary>The projector's calibration pictures as a texture, one at a time, pixel for pixel.</summary>
    internal sealed class PatternTexture : IDisposable
    {
        private readonly ScreenPattern _pattern;
        private readonly Image _picture = new Image();
        private readonly byte[] _rows;

        /// <param name="widthPx">Of the projector's picture; a size that <see cref="ScreenPattern.CanDraw"/> accepts.</param>
        /// <param name="heightPx">The same for its height.</param>
        public PatternTexture(int widthPx, int heightPx)
        {
            _pattern = new ScreenPattern(widthPx, heightPx);
            _rows = new byte[widthPx * heightPx * 4];
            Texture = new Texture2D(widthPx, heightPx, TextureFormat.RGBA32, false) { filterMode = FilterMode.Point, wrapMode = TextureWrapMode.Clamp };
        }

        public Texture2D Texture { get; }

        /// <summary>Takes some hundredths of a second.</summary>
        public void Draw(int picture)
        {
            _pattern.Draw(picture, _picture);
            int width = _pattern.WidthPx, height = _pattern.HeightPx;
            for (int y = 0; y < height; y++)
            {
                // A texture's rows begin at the bottom.
                ReadOnlySpan<byte> from = _picture.Bytes.Slice((height - 1 - y) * _picture.Stride, width);
                Span<byte> to = _rows.AsSpan(y * width * 4, width * 4);
                for (int x = 0; x < width; x++)
                {
                    to[4 * x] = to[4 * x + 1] = to[4 * x + 2] = from[x];
                    to[4 * x + 3] = 255;
                }
            }

            Texture.LoadRawTextureData(_rows);
            Texture.Apply(false);
        }

        public void Dispose()
        {
            _picture.Dispose();
            Object.Destroy(Texture);
        }
    }
}
