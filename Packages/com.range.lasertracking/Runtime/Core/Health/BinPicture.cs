using System;
using LaserTracking.Imaging;

namespace LaserTracking.Health
{
    /// <summary>
    /// A small grey copy of a picture, one bin a pixel of a picture 640 wide, and that again at half its size. Filled in bands of rows,
    /// so that no frame bears all of the work.
    /// </summary>
    internal sealed unsafe class BinPicture
    {
        /// <summary>Pixels of the picture in a bin.</summary>
        public int BinPx { get; private set; } = 1;

        public int Width { get; private set; }

        public int Height { get; private set; }

        /// <summary>Row by row, 0…255.</summary>
        public byte[] Levels { get; private set; } = Array.Empty<byte>();

        /// <summary>Means of two by two bins, <see cref="Width"/> / 2 a row.</summary>
        public byte[] Half { get; private set; } = Array.Empty<byte>();

        /// <summary>Takes the size that a picture asks for; true when it is another than before.</summary>
        public bool Fit(Image image)
        {
            int bin = Math.Max(1, image.Width / 640), width = image.Width / bin, height = image.Height / bin;
            if (width == Width && height == Height && bin == BinPx)
                return false;
            (BinPx, Width, Height) = (bin, width, height);
            Levels = new byte[width * height];
            Half = new byte[width / 2 * (height / 2)];
            return true;
        }

        /// <summary>Reads one of so many bands of rows.</summary>
        public void FillBand(Image image, int band, int bands)
        {
            int pairs = (Height + 1) / 2, first = 2 * (pairs * band / bands), end = Math.Min(Height, 2 * (pairs * (band + 1) / bands));
            int step = image.Format == PixelFormat.Bgra32 ? 4 : image.Format == PixelFormat.Yuy2 ? 2 : 1, right = step * BinPx;
            byte* corner = image.Pixels + (step == 4 ? 1 : 0);
            fixed (byte* levels = Levels, half = Half)
            {
                for (int y = first; y < end; y++)
                {
                    byte* p = corner + (long)y * BinPx * image.Stride, to = levels + y * Width;
                    for (int x = 0; x < Width; x++, p += right)
                        to[x] = *p;
                    if (y % 2 == 1)
                        Halve(to - Width, to, half + y / 2 * (Width / 2), Width / 2);
                }
            }
        }

        private static void Halve(byte* upper, byte* lower, byte* to, int count)
        {
            for (int x = 0; x < count; x++)
                to[x] = (byte)(upper[2 * x] + upper[2 * x + 1] + lower[2 * x] + lower[2 * x + 1] + 2 >> 2);
        }

        /// <summary>Copies a square of bins, even place and size, from another picture of the same size.</summary>
        public void CopyFrom(BinPicture other, int x, int y, int size)
        {
            for (int row = y; row < y + size; row++)
                Buffer.BlockCopy(other.Levels, row * Width + x, Levels, row * Width + x, size);
            for (int row = y / 2; row < (y + size) / 2; row++)
                Buffer.BlockCopy(other.Half, row * (Width / 2) + x / 2, Half, row * (Width / 2) + x / 2, size / 2);
        }
    }
}
