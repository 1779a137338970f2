using System;

namespace LaserTracking.Geometry
{
    /// <summary>Two doubles. The unit and the frame of reference stand in the name of the variable that holds it.</summary>
    public readonly struct Vector2D : IEquatable<Vector2D>
    {
        public readonly double X;
        public readonly double Y;

        public Vector2D(double x, double y)
        {
            X = x;
            Y = y;
        }

        public double Length => Math.Sqrt(X * X + Y * Y);

        public double LengthSquared => X * X + Y * Y;

        public bool IsFinite => !double.IsNaN(X) && !double.IsInfinity(X) && !double.IsNaN(Y) && !double.IsInfinity(Y);

        public static Vector2D operator +(Vector2D a, Vector2D b) => new Vector2D(a.X + b.X, a.Y + b.Y);

        public static Vector2D operator -(Vector2D a, Vector2D b) => new Vector2D(a.X - b.X, a.Y - b.Y);

        public static Vector2D operator *(Vector2D a, double s) => new Vector2D(a.X * s, a.Y * s);

        public static double Dot(Vector2D a, Vector2D b) => a.X * b.X + a.Y * b.Y;

        /// <summary>The z component of the cross product: positive when b lies clockwise of a in a picture (y down).</summary>
        public static double Cross(Vector2D a, Vector2D b) => a.X * b.Y - a.Y * b.X;

        public bool Equals(Vector2D other) => X.Equals(other.X) && Y.Equals(other.Y);

        public override bool Equals(object? obj) => obj is Vector2D other && Equals(other);

        public override int GetHashCode() => unchecked(X.GetHashCode() * 397 ^ Y.GetHashCode());

        public override string ToString() => FormattableString.Invariant($"({X}, {Y})");
    }
}
