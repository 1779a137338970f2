using System;
using System.Globalization;

namespace LaserTracking.Imaging
{
    /// <summary>
    /// An upright part of a camera's picture, in whole pixels from its top-left corner, with the size of the whole. Position and size
    /// are even, so that every pixel layout can be cut there.
    /// </summary>
    public readonly struct PixelRegion : IEquatable<PixelRegion>
    {
        private const int MaxSide = 1 << 14;

        private PixelRegion(int x, int y, int width, int height, int fullWidth, int fullHeight)
        {
            X = x;
            Y = y;
            Width = width;
            Height = height;
            FullWidth = fullWidth;
            FullHeight = fullHeight;
        }

        public int X { get; }

        public int Y { get; }

        public int Width { get; }

        public int Height { get; }

        public int FullWidth { get; }

        public int FullHeight { get; }

        /// <summary>The smallest region that holds the given part of a picture. False when nothing of it lies in the picture, or its sides are odd.</summary>
        /// <param name="left">First column wanted; may lie outside, as the others may.</param>
        /// <param name="top">First row.</param>
        /// <param name="right">Column behind the last.</param>
        /// <param name="bottom">Row behind the last.</param>
        /// <param name="fullWidth">Of the picture, even.</param>
        /// <param name="fullHeight">Of the picture, even.</param>
        /// <param name="region">The result.</param>
        public static bool TryCreate(double left, double top, double right, double bottom, int fullWidth, int fullHeight, out PixelRegion region)
        {
            region = default;
            bool isPicture = fullWidth > 0 && fullHeight > 0 && fullWidth <= MaxSide && fullHeight <= MaxSide && (fullWidth | fullHeight) % 2 == 0;
            if (!isPicture || !(right > left) || !(bottom > top) || !(left < fullWidth) || !(top < fullHeight) || !(right > 0) || !(bottom > 0))
                return false;
            int x = (int)Math.Max(0, left) & ~1, y = (int)Math.Max(0, top) & ~1;
            int endX = ((int)Math.Ceiling(Math.Min(fullWidth, right)) + 1) & ~1, endY = ((int)Math.Ceiling(Math.Min(fullHeight, bottom)) + 1) & ~1;
            region = new PixelRegion(x, y, endX - x, endY - y, fullWidth, fullHeight);
            return true;
        }

        /// <summary>As <see cref="ToString"/> writes it. False for anything else.</summary>
        public static bool TryParse(string text, out PixelRegion region)
        {
            region = default;
            string[] words = text.Split(' ');
            var n = new int[6];
            if (words.Length != n.Length)
                return false;
            for (int i = 0; i < n.Length; i++)
            {
                if (!int.TryParse(words[i], NumberStyles.None, CultureInfo.InvariantCulture, out n[i]) || n[i] > MaxSide)
                    return false;
            }

            if ((n[0] | n[1] | n[2] | n[3]) % 2 != 0 || n[0] + n[2] > n[4] || n[1] + n[3] > n[5])
                return false;
            return TryCreate(n[0], n[1], n[0] + n[2], n[1] + n[3], n[4], n[5], out region);
        }

        /// <summary>Copies this part of a picture, rows without padding.</summary>
        /// <exception cref="ArgumentException">The picture has another size than the whole that this is a part of.</exception>
        public void Crop(Image source, Image target)
        {
            if (source.Width != FullWidth || source.Height != FullHeight)
                throw new ArgumentException("a picture of " + source.Width + "×" + source.Height + " has no region of one of " + FullWidth + "×" + FullHeight);
            target.Reset(source.Format, Width, Height, source.TimeUs);
            Copy(source, X, Y, target, 0, 0);
        }

        /// <summary>Puts the part back at its place in a black picture of the full size.</summary>
        public void Restore(Image part, Image target)
        {
            target.Reset(part.Format, FullWidth, FullHeight, part.TimeUs);
            FillBlack(target);
            Copy(part, 0, 0, target, X, Y);
        }

        /// <summary>"x y width height fullWidth fullHeight".</summary>
        public override string ToString() =>
            string.Format(CultureInfo.InvariantCulture, "{0} {1} {2} {3} {4} {5}", X, Y, Width, Height, FullWidth, FullHeight);

        public bool Equals(PixelRegion other) =>
            X == other.X && Y == other.Y && Width == other.Width && Height == other.Height && FullWidth == other.FullWidth && FullHeight == other.FullHeight;

        public override bool Equals(object? obj) => obj is PixelRegion other && Equals(other);

        public override int GetHashCode() => HashCode.Combine(X, Y, Width, Height, FullWidth, FullHeight);

        private void Copy(Image source, int sourceX, int sourceY, Image target, int targetX, int targetY)
        {
            int row = Image.TightStride(source.Format, Width);
            CopyRows(source, Image.TightStride(source.Format, sourceX), sourceY, target, Image.TightStride(source.Format, targetX), targetY, row, Height);
            if (source.Format == PixelFormat.Nv12)
                CopyRows(source, sourceX, source.Height + sourceY / 2, target, targetX, target.Height + targetY / 2, row, Height / 2);
        }

        private static void CopyRows(Image source, int sourceByte, int sourceRow, Image target, int targetByte, int targetRow, int bytes, int rows)
        {
            for (int i = 0; i < rows; i++)
            {
                Span<byte> from = source.Bytes.Slice((sourceRow + i) * source.Stride + sourceByte, bytes);
                from.CopyTo(target.Bytes.Slice((targetRow + i) * target.Stride + targetByte, bytes));
            }
        }

        private static void FillBlack(Image target)
        {
            target.Bytes.Clear();
            if (target.Format == PixelFormat.Nv12)
                target.Bytes.Slice(target.Stride * target.Height).Fill(128);
            if (target.Format != PixelFormat.Yuy2)
                return;
            Span<byte> bytes = target.Bytes;
            for (int i = 1; i < bytes.Length; i += 2)
                bytes[i] = 128;
        }
    }
}
