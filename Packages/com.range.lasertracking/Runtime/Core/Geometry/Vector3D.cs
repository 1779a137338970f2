using System;

namespace LaserTracking.Geometry
{
    /// <summary>Three doubles. The unit and the frame of reference stand in the name of the variable that holds it.</summary>
    public readonly struct Vector3D : IEquatable<Vector3D>
    {
        public readonly double X;
        public readonly double Y;
        public readonly double Z;

        public Vector3D(double x, double y, double z)
        {
            X = x;
            Y = y;
            Z = z;
        }

        public double Length => Math.Sqrt(X * X + Y * Y + Z * Z);

        public double LengthSquared => X * X + Y * Y + Z * Z;

        public bool IsFinite => !double.IsNaN(X + Y + Z) && !double.IsInfinity(X) && !double.IsInfinity(Y) && !double.IsInfinity(Z);

        /// <summary>The unit vector, or zero when the length is zero.</summary>
        public Vector3D Normalized
        {
            get
            {
                double length = Length;
                return length > 0 ? this * (1 / length) : default;
            }
        }

        public static Vector3D operator +(Vector3D a, Vector3D b) => new Vector3D(a.X + b.X, a.Y + b.Y, a.Z + b.Z);

        public static Vector3D operator -(Vector3D a, Vector3D b) => new Vector3D(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

        public static Vector3D operator -(Vector3D a) => new Vector3D(-a.X, -a.Y, -a.Z);

        public static Vector3D operator *(Vector3D a, double s) => new Vector3D(a.X * s, a.Y * s, a.Z * s);

        /// <summary>Component by component, as Unity's Vector3.Scale.</summary>
        public static Vector3D Scale(Vector3D a, Vector3D b) => new Vector3D(a.X * b.X, a.Y * b.Y, a.Z * b.Z);

        /// <summary>Angle from one to another as seen along Y, radians, −π…π: their bearings' difference, whatever their slopes.</summary>
        public static double Turn(Vector3D from, Vector3D to) => Math.Atan2(from.X * to.Z - from.Z * to.X, from.X * to.X + from.Z * to.Z);

        public static double Dot(Vector3D a, Vector3D b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

        public static Vector3D Cross(Vector3D a, Vector3D b) =>
            new Vector3D(a.Y * b.Z - a.Z * b.Y, a.Z * b.X - a.X * b.Z, a.X * b.Y - a.Y * b.X);

        public bool Equals(Vector3D other) => X.Equals(other.X) && Y.Equals(other.Y) && Z.Equals(other.Z);

        public override bool Equals(object? obj) => obj is Vector3D other && Equals(other);

        public override int GetHashCode() => unchecked((X.GetHashCode() * 397 ^ Y.GetHashCode()) * 397 ^ Z.GetHashCode());

        public override string ToString() => FormattableString.Invariant($"({X}, {Y}, {Z})");
    }
}
