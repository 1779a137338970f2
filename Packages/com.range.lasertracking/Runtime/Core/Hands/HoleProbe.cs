using System;
using LaserTracking.Geometry;

namespace LaserTracking.Hands
{
    /// <summary>Looks whether a place in space is one where the sensor measured nothing.</summary>
    internal static class HoleProbe
    {
        /// <summary>
        /// True when a place is mostly lost while three times its surroundings mostly are not: the sensor also measures nothing
        /// where the room is out of its range, and an empty room is no hidden hand.
        /// </summary>
        public static bool IsHole(DepthGrid grid, Vector3D middleMm, double radiusMm, double lostShare) =>
            Measure(grid, middleMm, radiusMm, out double inside, out _) && inside >= lostShare
            && Measure(grid, middleMm, 3 * radiusMm, out double around, out _) && around < lostShare;

        /// <summary>Whether a sphere reaches over the picture's border.</summary>
        public static bool IsNearBorder(DepthGrid grid, Vector3D middleMm, double radiusMm)
        {
            int centre = middleMm.Z > 1 ? grid.CellOf(middleMm) : -1;
            if (centre < 0)
                return true;
            int reach = (int)Math.Ceiling(radiusMm / middleMm.Z / Math.Sqrt(grid.UnitArea));
            int x = centre % grid.Width, y = centre / grid.Width;
            return x < reach || y < reach || x >= grid.Width - reach || y >= grid.Height - reach;
        }

        /// <summary>
        /// Share of lost cells in the disc that a sphere covers in the picture, and the mean ray (z = 1) of those; false when the
        /// disc lies outside the picture.
        /// </summary>
        public static bool Measure(DepthGrid grid, Vector3D middleMm, double radiusMm, out double share, out Vector3D ray)
        {
            share = 0;
            ray = default;
            int centre = middleMm.Z > 1 ? grid.CellOf(middleMm) : -1;
            if (centre < 0)
                return false;
            int reach = (int)Math.Ceiling(radiusMm / middleMm.Z / Math.Sqrt(grid.UnitArea));
            int cx = centre % grid.Width, cy = centre / grid.Width, seen = 0, lost = 0;
            double sumX = 0, sumY = 0;
            for (int y = Math.Max(0, cy - reach); y <= Math.Min(grid.Height - 1, cy + reach); y++)
            {
                for (int x = Math.Max(0, cx - reach); x <= Math.Min(grid.Width - 1, cx + reach); x++)
                {
                    if ((x - cx) * (x - cx) + (y - cy) * (y - cy) > reach * reach)
                        continue;
                    seen++;
                    if (!grid.Lost[y * grid.Width + x])
                        continue;
                    lost++;
                    sumX += grid.RayX[x];
                    sumY += grid.RayY[y];
                }
            }

            share = lost / (double)seen;
            if (lost > 0)
                ray = new Vector3D(sumX / lost, sumY / lost, 1);
            return true;
        }
    }
}
