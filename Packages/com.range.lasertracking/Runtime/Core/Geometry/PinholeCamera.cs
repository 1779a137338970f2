using System;

namespace LaserTracking.Geometry
{
    /// <summary>A camera without lens distortion. Pixel centres are integers; camera space is x right, y down, z forward.</summary>
    public sealed class PinholeCamera
    {
        /// <param name="focalXPx">Focal length along x in pixels, above zero.</param>
        /// <param name="focalYPx">Focal length along y in pixels, above zero.</param>
        /// <param name="centerXPx">Principal point, pixels.</param>
        /// <param name="centerYPx">Principal point, pixels.</param>
        /// <param name="width">Picture width in pixels.</param>
        /// <param name="height">Picture height in pixels.</param>
        public PinholeCamera(double focalXPx, double focalYPx, double centerXPx, double centerYPx, int width, int height)
        {
            if (!(focalXPx > 0 && focalYPx > 0) || double.IsInfinity(focalXPx) || double.IsInfinity(focalYPx))
                throw new ArgumentException("focal lengths must be above zero");
            if (double.IsNaN(centerXPx + centerYPx) || double.IsInfinity(centerXPx + centerYPx))
                throw new ArgumentException("the principal point must be finite");
            if (width <= 0 || height <= 0)
                throw new ArgumentException("the picture's size must be above zero");
            FocalXPx = focalXPx;
            FocalYPx = focalYPx;
            CenterXPx = centerXPx;
            CenterYPx = centerYPx;
            Width = width;
            Height = height;
        }

        public double FocalXPx { get; }

        public double FocalYPx { get; }

        public double CenterXPx { get; }

        public double CenterYPx { get; }

        public int Width { get; }

        public int Height { get; }

        /// <summary>The point at distance z along the axis that is seen at the pixel; in the unit of z.</summary>
        public Vector3D Unproject(double xPx, double yPx, double z) =>
            new Vector3D((xPx - CenterXPx) / FocalXPx * z, (yPx - CenterYPx) / FocalYPx * z, z);

        /// <summary>Where a point in front of the camera is seen; false at or behind the camera.</summary>
        public bool TryProject(Vector3D point, out Vector2D pixel)
        {
            if (!(point.Z > 0))
            {
                pixel = default;
                return false;
            }

            pixel = new Vector2D(FocalXPx * point.X / point.Z + CenterXPx, FocalYPx * point.Y / point.Z + CenterYPx);
            return true;
        }
    }
}
