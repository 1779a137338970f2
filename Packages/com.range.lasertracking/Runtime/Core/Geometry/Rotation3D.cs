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

        /// <summary>From a rotation vector: axis times angle in radians. <see cref="Rodrigues"/> has the derivatives.</summary>
        public static Rotation3D FromVector(Vector3D vector) => AboutAxis(vector, vector.Length);

        /// <summary>The rotation vector, axis times angle in radians, no longer than π; at π either of two opposite ones.</summary>
        public Vector3D ToVector()
        {
            var q = new Vector3D(X, Y, Z);
            double sine = q.Length, sign = W < 0 ? -1 : 1;
            return sine > 0 ? q * (sign * 2 * Math.Atan2(sine, Math.Abs(W)) / sine) : default;
        }

        /// <summary>The 3×3 matrix, row by row.</summary>
        public double[] ToMatrix() => new[]
        {
            1 - 2 * (Y * Y + Z * Z), 2 * (X * Y - W * Z), 2 * (X * Z + W * Y),
            2 * (X * Y + W * Z), 1 - 2 * (X * X + Z * Z), 2 * (Y * Z - W * X),
            2 * (X * Z - W * Y), 2 * (Y * Z + W * X), 1 - 2 * (X * X + Y * Y),
        };

        /// <summary>From a 3×3 matrix, row by row. False unless it is orthonormal (within 1e-4) with determinant +1.</summary>
        public static bool TryFromMatrix(ReadOnlySpan<double> m, out Rotation3D rotation)
        {
            rotation = Identity;
            if (m.Length != 9)
                return false;
            var x = new Vector3D(m[0], m[3], m[6]);
            var y = new Vector3D(m[1], m[4], m[7]);
            var z = new Vector3D(m[2], m[5], m[8]);
            const double tolerance = 1e-4;
            bool isRotation = Math.Abs(x.Length - 1) < tolerance && Math.Abs(y.Length - 1) < tolerance &&
                Math.Abs(Vector3D.Dot(x, y)) < tolerance && (Vector3D.Cross(x, y) - z).Length < tolerance;
            if (!isRotation)
                return false;

            // Of the four quaternion components the largest is taken from the diagonal: dividing by it is safe (Shepperd 1978).
            double trace = m[0] + m[4] + m[8];
            if (trace >= m[0] && trace >= m[4] && trace >= m[8])
                rotation = new Rotation3D(m[7] - m[5], m[2] - m[6], m[3] - m[1], 1 + trace);
            else if (m[0] >= m[4] && m[0] >= m[8])
                rotation = new Rotation3D(1 + m[0] - m[4] - m[8], m[1] + m[3], m[2] + m[6], m[7] - m[5]);
            else if (m[4] >= m[8])
                rotation = new Rotation3D(m[1] + m[3], 1 + m[4] - m[0] - m[8], m[5] + m[7], m[2] - m[6]);
            else
                rotation = new Rotation3D(m[2] + m[6], m[5] + m[7], 1 + m[8] - m[0] - m[4], m[3] - m[1]);
            return true;
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
