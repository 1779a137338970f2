using System;
using LaserTracking.Imaging;

namespace LaserTracking.Health
{
    /// <summary>
    /// Twelve blocks of the picture, each as two lists: brightness from column to column, summed over a few rows, and from row to
    /// row, summed over a few columns; as slopes, so that light levels do not matter. One bin is a pixel of a picture 640 wide.
    /// </summary>
    internal sealed unsafe class ShiftProfiles
    {
        public const int BlocksX = 4;
        public const int BlocksY = 3;
        public const int Blocks = BlocksX * BlocksY;
        public const int Lists = 2 * Blocks;

        /// <summary>Largest displacement looked for, bins.</summary>
        public const int Reach = 20;

        private const int Lines = 8;

        /// <summary>Mean square slope of a list worth matching: several times that of eight noisy pixels.</summary>
        private const long LeastSlope = 300;

        private int[] _sums = Array.Empty<int>();

        /// <summary>Slopes: for each block its list along x, then its list along y.</summary>
        public int[][] Slopes { get; } = new int[Lists][];

        /// <summary>Pixels of the picture in a bin.</summary>
        public int BinPx { get; private set; }

        /// <summary>Fills one block from a picture; false when that is too small for it.</summary>
        public bool TryFill(Image image, int block)
        {
            BinPx = Math.Max(1, image.Width / 640);
            int blockX = image.Width / BinPx / BlocksX, blockY = image.Height / BinPx / BlocksY;
            if (blockX <= 3 * Reach || blockY <= 3 * Reach)
                return false;
            int first = image.Format == PixelFormat.Bgra32 ? 1 : 0;
            int step = image.Format == PixelFormat.Bgra32 ? 4 : image.Format == PixelFormat.Yuy2 ? 2 : 1;
            int x0 = block % BlocksX * blockX * BinPx, y0 = block / BlocksX * blockY * BinPx;
            byte* corner = image.Pixels + first + (long)y0 * image.Stride + (long)x0 * step;
            long right = (long)step * BinPx, down = (long)image.Stride * BinPx;
            Slopes[2 * block] = Fill(Slopes[2 * block], corner, right, blockX, down * blockY / Lines / image.Stride * image.Stride);
            Slopes[2 * block + 1] = Fill(Slopes[2 * block + 1], corner, down, blockY, right * blockX / Lines / step * step);
            return true;
        }

        private int[] Fill(int[]? slopes, byte* corner, long along, int count, long across)
        {
            if (slopes == null || slopes.Length != count)
                slopes = new int[count];
            if (_sums.Length < count)
                _sums = new int[count];
            Array.Clear(_sums, 0, count);
            for (int line = 0; line < Lines; line++)
            {
                byte* p = corner + across * line;
                for (int i = 0; i < count; i++, p += along)
                    _sums[i] += *p;
            }

            slopes[0] = slopes[count - 1] = 0;
            for (int i = 1; i < count - 1; i++)
                slopes[i] = _sums[i + 1] - _sums[i - 1];
            return slopes;
        }

        /// <summary>Displacement of a list against an earlier one, bins; false where there is too little to see or nothing fits.</summary>
        public bool TryMatch(ShiftProfiles earlier, int list, out double shift) =>
            SlopeMatch.TryFind(Slopes[list], earlier.Slopes[list], Reach, LeastSlope, out shift);
    }
}
