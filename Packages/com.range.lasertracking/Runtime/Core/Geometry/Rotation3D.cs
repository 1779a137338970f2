using System;

namespace LaserTracking.Geometry
{
    /// <summary>A rotation as a unit quaternion (x, y, z, w): the same component order and product as Unity's Quaternion.</summary>
    public readonly struct Rotation3D
    {
        public readonly double X;
        public readonly double Y;
        public readonly double Z;
        public readonly double W;

        /// <summary>Components are normalised; four zeros give the identity.</summary>
        public Rotation3D(double x, double y, double z, double w)
        {
            double length = Math.Sqrt(x * x + y * y + z * z + w * w);
            if (length > 0)
            {
                X = x / length;
                Y = y / length;
                Z = z / length;
                W = w / length;
            }
            else
            {
                X = Y = Z = 0;
                W = 1;
            }
        }

        public static Rotation3D Identity => new Rotation3D(0, 0, 0, 1);

        public Rotation3D Inverse => new Rotation3D(-X, -Y, -Z, W);

        /// <summary>Turns about the axis by the angle in radians, in the sense of the frame's own handedness.</summary>
        public static Rotation3D AboutAxis(Vector3D axis, double angleRad)
        {
            Vector3D unit = axis.Normalized;
            double s = Math.Sin(angleRad / 2);
            return new Rotation3D(unit.X * s, unit.Y * s, unit.Z * s, Math.Cos(angleRad / 2));
        }

        /// <summary>a * b turns by b first, then by a.</summary>
        public static Rotation3D operator *(Rotation3D a, Rotation3D b) => new Rotation3D(
            a.W * b.X + a.X * b.W + a.Y * b.Z - a.Z * b.Y,
            a.W * b.Y + a.Y * b.W + a.Z * b.X - a.X * b.Z,
            a.W * b.Z + a.Z * b.W + a.X * b.Y - a.Y * b.X,
            a.W * b.W - a.X * b.X - a.Y * b.Y - a.Z * b.Z);

        public static Vector3D operator *(Rotation3D r, Vector3D v)
        {
            var q = new Vector3D(r.X, r.Y, r.Z);
            Vector3D t = Vector3D.Cross(q, v) * 2;
            return v + t * r.W + Vector3D.Cross(q, t);
        }
    }
}
