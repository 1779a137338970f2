using System;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>Camera poses from where they stand and what they look at.</summary>
    internal static class LookAt
    {
        /// <summary>Camera space (x right, y down, z forward) to screen space; both in the position's unit.</summary>
        public static Pose Pose(Vector3D position, Vector3D lookAt, double rollRad)
        {
            Vector3D forward = (lookAt - position).Normalized;
            Vector3D right = Vector3D.Cross(new Vector3D(0, 1, 0), forward);
            // Straight up or down there is no horizon to be level with.
            right = right.Length > 1e-6 ? right.Normalized : new Vector3D(1, 0, 0);
            Vector3D down = Vector3D.Cross(forward, right);
            double c = Math.Cos(rollRad), s = Math.Sin(rollRad);
            return new Pose(position, FromAxes(right * c + down * s, down * c - right * s, forward));
        }

        /// <summary>The rotation that carries the unit axes on to three orthonormal vectors.</summary>
        private static Rotation3D FromAxes(Vector3D x, Vector3D y, Vector3D z)
        {
            double trace = x.X + y.Y + z.Z;
            if (trace > 0)
            {
                double s = 2 * Math.Sqrt(trace + 1);
                return new Rotation3D((y.Z - z.Y) / s, (z.X - x.Z) / s, (x.Y - y.X) / s, s / 4);
            }

            if (x.X >= y.Y && x.X >= z.Z)
            {
                double s = 2 * Math.Sqrt(1 + x.X - y.Y - z.Z);
                return new Rotation3D(s / 4, (y.X + x.Y) / s, (z.X + x.Z) / s, (y.Z - z.Y) / s);
            }

            if (y.Y >= z.Z)
            {
                double s = 2 * Math.Sqrt(1 + y.Y - x.X - z.Z);
                return new Rotation3D((y.X + x.Y) / s, s / 4, (z.Y + y.Z) / s, (z.X - x.Z) / s);
            }
            else
            {
                double s = 2 * Math.Sqrt(1 + z.Z - x.X - y.Y);
                return new Rotation3D((z.X + x.Z) / s, (z.Y + y.Z) / s, s / 4, (x.Y - y.X) / s);
            }
        }
    }
}
