using System;

namespace LaserTracking.Geometry
{
    /// <summary>The screen's plane as a depth camera beside the colour camera measures it.</summary>
    public static class DepthScreenPlane
    {
        // Every so many pixels along each axis: thousands of points are plenty for a plane.
        private const int Step = 3;
        private const int LeastPoints = 100;
        private const double LeastShare = 0.5;

        /// <summary>Fits the plane to the depth pixels that show the screen; people before it are left out. Allocates.</summary>
        /// <param name="depthCamera">What took the depth picture.</param>
        /// <param name="depthToColorMm">From its space to the colour camera's, both mm.</param>
        /// <param name="color">What took the picture that the screen was calibrated in, with its true focal length.</param>
        /// <param name="depthMm">The depth picture, row by row without gaps; 0: nothing measured.</param>
        /// <param name="screen">Where the screen lies in the colour picture.</param>
        /// <param name="fit">In the colour camera's space, mm. Valid only when true is returned.</param>
        /// <param name="reason">Why there is none, one line; empty on success.</param>
        public static bool TryMeasure(LensCamera depthCamera, Pose depthToColorMm, LensCamera color, ReadOnlySpan<ushort> depthMm, ScreenGeometry screen, out PlaneFit? fit, out string reason)
        {
            fit = null;
            PinholeCamera depth = depthCamera.Pinhole;
            if (depthMm.Length != depth.Width * depth.Height)
                throw new ArgumentException("this is no depth picture of that camera", nameof(depthMm));
            var points = new Vector3D[(depth.Width / Step + 1) * (depth.Height / Step + 1)];
            Vector2D[] outline = screen.OutlinePx;
            int count = 0;
            for (int y = 0; y < depth.Height; y += Step)
            for (int x = 0; x < depth.Width; x += Step)
            {
                double z = depthMm[y * depth.Width + x];
                if (!(z > 0) || !depthCamera.TryUnproject(new Vector2D(x, y), out Vector2D ray))
                    continue;
                Vector3D point = depthToColorMm.TransformPoint(new Vector3D(ray.X * z, ray.Y * z, z));
                if (color.TryProject(point, out Vector2D pixel) && Polygon2D.Contains(outline, pixel))
                    points[count++] = point;
            }

            if (count < LeastPoints)
            {
                reason = FormattableString.Invariant($"the depth camera sees only {count} points of the screen");
                return false;
            }

            if (!PlaneFit.TryFit(points.AsSpan(0, count), out fit, out reason))
                return false;
            if (fit!.NearCount >= LeastShare * count)
                return true;
            reason = FormattableString.Invariant($"only {100.0 * fit.NearCount / count:F0} % of the screen's depth lies on one plane: it is not flat, or hidden");
            fit = null;
            return false;
        }
    }
}
