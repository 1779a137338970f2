using System;

namespace LaserTracking.Simulation
{
    /// <summary>Pixels Left ≤ x &lt; Right, Top ≤ y &lt; Bottom.</summary>
    internal readonly struct PixelRect
    {
        public readonly int Left, Top, Right, Bottom;

        public PixelRect(int left, int top, int right, int bottom)
        {
            Left = left;
            Top = top;
            Right = right;
            Bottom = bottom;
        }

        public bool IsEmpty => Left >= Right || Top >= Bottom;

        public bool Touches(PixelRect other) =>
            Left < other.Right && other.Left < Right && Top < other.Bottom && other.Top < Bottom;

        public PixelRect Union(PixelRect other)
        {
            if (IsEmpty)
                return other;
            return other.IsEmpty ? this : new PixelRect(Math.Min(Left, other.Left), Math.Min(Top, other.Top),
                Math.Max(Right, other.Right), Math.Max(Bottom, other.Bottom));
        }

        public PixelRect Intersect(PixelRect other) => new PixelRect(Math.Max(Left, other.Left), Math.Max(Top, other.Top),
            Math.Min(Right, other.Right), Math.Min(Bottom, other.Bottom));

        public PixelRect Grow(int margin) => new PixelRect(Left - margin, Top - margin, Right + margin, Bottom + margin);
    }
}
