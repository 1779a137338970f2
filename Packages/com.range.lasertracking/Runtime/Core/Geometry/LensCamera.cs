using System;

namespace LaserTracking.Geometry
{
    /// <summary>A camera with its lens: pixels to rays (normalised to z = 1) and back. Pixel centres are integers. Immutable.</summary>
    public sealed class LensCamera
    {
        /// <param name="pinhole">Focal lengths, principal point, picture size.</param>
        /// <param name="distortion">Of the lens.</param>
        public LensCamera(PinholeCamera pinhole, BrownDistortion distortion)
        {
            Pinhole = pinhole;
            Distortion = distortion;
        }

        public PinholeCamera Pinhole { get; }

        public BrownDistortion Distortion { get; }

        /// <summary>The ray seen at a pixel; false outside what the lens model covers.</summary>
        public bool TryUnproject(Vector2D pixel, out Vector2D ray) => Distortion.TryUndistort(ToPlane(pixel), out ray);

        /// <summary>The same from a ray near the result: fewer steps.</summary>
        internal bool TryUnproject(Vector2D pixel, Vector2D start, out Vector2D ray) => Distortion.TryUndistort(ToPlane(pixel), start, out ray);

        /// <summary>Where a ray is seen, also beside the picture; false outside what the lens model covers.</summary>
        public bool TryProject(Vector2D ray, out Vector2D pixel)
        {
            bool isValid = Distortion.TryDistort(ray, out Vector2D distorted);
            pixel = ToPixel(distorted);
            return isValid;
        }

        /// <summary>Where a point of camera space is seen, any unit; false at or behind the camera or outside what the lens model covers.</summary>
        public bool TryProject(Vector3D point, out Vector2D pixel)
        {
            pixel = default;
            return point.Z > 0 && TryProject(new Vector2D(point.X / point.Z, point.Y / point.Z), out pixel);
        }

        /// <summary>Where the same camera without distortion would see what lies at a pixel; false outside what the lens model covers.</summary>
        public bool TryUndistort(Vector2D pixel, out Vector2D ideal)
        {
            bool isValid = TryUnproject(pixel, out Vector2D ray);
            ideal = ToPixel(ray);
            return isValid;
        }

        /// <summary>The inverse of <see cref="TryUndistort"/>; false outside what the lens model covers.</summary>
        public bool TryDistort(Vector2D ideal, out Vector2D pixel) => TryProject(ToPlane(ideal), out pixel);

        /// <summary>How pixels move with those of the camera without distortion, at a pixel.</summary>
        /// <param name="pixel">One that has a ray.</param>
        /// <param name="pixelByIdeal">2×2, row by row.</param>
        public void DistortionJacobian(Vector2D pixel, Span<double> pixelByIdeal)
        {
            TryUnproject(pixel, out Vector2D ray);
            Distortion.Distort(ray, pixelByIdeal, default);
            pixelByIdeal[1] *= Pinhole.FocalXPx / Pinhole.FocalYPx;
            pixelByIdeal[2] *= Pinhole.FocalYPx / Pinhole.FocalXPx;
        }

        /// <summary>
        /// Where a point of camera space is seen, with derivatives for a solver; false only at or behind the camera, for a solver may
        /// pass through places that the lens model does not cover. All derivatives are rows for x and y, one after the other.
        /// </summary>
        /// <param name="point">Camera space, any unit.</param>
        /// <param name="pixel">Valid only when true is returned, as are the derivatives.</param>
        /// <param name="byPoint">2×3: px by the point's unit.</param>
        /// <param name="byPinhole">2×4: by focal length x, focal length y, centre x, centre y.</param>
        /// <param name="byDistortion">2×5 or 2×8: by the coefficients in OpenCV's order k1, k2, p1, p2, k3 (, k4, k5, k6); or empty.</param>
        public bool TryProject(Vector3D point, out Vector2D pixel, Span<double> byPoint, Span<double> byPinhole, Span<double> byDistortion)
        {
            pixel = default;
            if (!(point.Z > 0))
                return false;
            Span<double> byRay = stackalloc double[4];
            var ray = new Vector2D(point.X / point.Z, point.Y / point.Z);
            Vector2D distorted = Distortion.Distort(ray, byRay, byDistortion);
            pixel = ToPixel(distorted);
            int columns = byDistortion.Length / 2;
            for (int row = 0; row < 2; row++)
            {
                double focal = row == 0 ? Pinhole.FocalXPx : Pinhole.FocalYPx;
                double x = focal * byRay[row * 2] / point.Z, y = focal * byRay[row * 2 + 1] / point.Z;
                byPoint[row * 3] = x;
                byPoint[row * 3 + 1] = y;
                byPoint[row * 3 + 2] = -x * ray.X - y * ray.Y;
                Span<double> camera = byPinhole.Slice(row * 4, 4);
                camera.Clear();
                camera[row] = row == 0 ? distorted.X : distorted.Y;
                camera[2 + row] = 1;
                for (int i = 0; i < columns; i++)
                    byDistortion[row * columns + i] *= focal;
            }

            return true;
        }

        private Vector2D ToPlane(Vector2D pixel) =>
            new Vector2D((pixel.X - Pinhole.CenterXPx) / Pinhole.FocalXPx, (pixel.Y - Pinhole.CenterYPx) / Pinhole.FocalYPx);

        private Vector2D ToPixel(Vector2D distorted) =>
            new Vector2D(Pinhole.FocalXPx * distorted.X + Pinhole.CenterXPx, Pinhole.FocalYPx * distorted.Y + Pinhole.CenterYPx);
    }
}
