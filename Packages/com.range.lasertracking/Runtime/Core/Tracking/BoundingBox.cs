using System;

namespace LaserTracking.Tracking
{
    /// <summary>A box in a picture: top-left corner and size, px, x right, y down.</summary>
    public readonly struct BoundingBox
    {
        private const double MaximumPx = 1e9;

        public readonly double X;
        public readonly double Y;
        public readonly double Width;
        public readonly double Height;

        public BoundingBox(double x, double y, double width, double height)
        {
            X = x;
            Y = y;
            Width = width;
            Height = height;
        }

        public double CenterX => X + Width / 2;

        public double CenterY => Y + Height / 2;

        /// <summary>Finite and larger than nothing; boxes far beyond any picture (1e9 px) are not usable either.</summary>
        public bool IsUsable => Math.Abs(X) < MaximumPx && Math.Abs(Y) < MaximumPx && Width > 0 && Width < MaximumPx && Height > 0 && Height < MaximumPx;

        /// <summary>Common area through the area of both together, 0…1; 0 where there is none.</summary>
        public static double IntersectionOverUnion(in BoundingBox a, in BoundingBox b)
        {
            double width = Math.Min(a.X + a.Width, b.X + b.Width) - Math.Max(a.X, b.X);
            double height = Math.Min(a.Y + a.Height, b.Y + b.Height) - Math.Max(a.Y, b.Y);
            if (!(width > 0 && height > 0))
                return 0;
            double common = width * height;
            return common / (a.Width * a.Height + b.Width * b.Height - common);
        }
    }
}
