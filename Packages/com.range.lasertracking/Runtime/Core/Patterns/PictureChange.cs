using System;
using LaserTracking.Imaging;

namespace LaserTracking.Patterns
{
    /// <summary>Whether a frame shows another picture than the one before: much of it has changed, not only where somebody moves.</summary>
    internal sealed unsafe class PictureChange
    {
        private const int Across = 64, Down = 36, Side = 8;

        /// <summary>Levels by which a patch's mean must change, and the share of patches that must.</summary>
        private const int PatchChange = 10;
        private const double ChangedShare = 0.04;

        private int[] _now = new int[Across * Down];
        private int[] _before = new int[Across * Down];

        /// <summary>Takes the next frame, at least 8 pixels either way.</summary>
        public bool Update(Image image)
        {
            (_now, _before) = (_before, _now);
            int step = image.Format == PixelFormat.Bgra32 ? 4 : image.Format == PixelFormat.Yuy2 ? 2 : 1, green = step == 4 ? 1 : 0, changed = 0;
            for (int i = 0; i < _now.Length; i++)
            {
                int x = (image.Width - Side) * (i % Across) / (Across - 1), y = (image.Height - Side) * (i / Across) / (Down - 1), sum = 0;
                for (int j = 0; j < Side * Side; j++)
                    sum += image.Pixels[(long)(y + j / Side) * image.Stride + (x + j % Side) * step + green];
                _now[i] = sum;
                changed += Math.Abs(sum - _before[i]) > PatchChange * Side * Side ? 1 : 0;
            }

            return changed > ChangedShare * _now.Length;
        }
    }
}
