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
        public bool TryUnproject(Vector2D pixel, out Vector2D ray) => Distortion.TryUndistort(
            new Vector2D((pixel.X - Pinhole.CenterXPx) / Pinhole.FocalXPx, (pixel.Y - Pinhole.CenterYPx) / Pinhole.FocalYPx), out ray);

        /// <summary>Where a ray is seen, also beside the picture; false outside what the lens model covers.</summary>
        public bool TryProject(Vector2D ray, out Vector2D pixel)
        {
            bool isValid = Distortion.TryDistort(ray, out Vector2D distorted);
            pixel = new Vector2D(Pinhole.FocalXPx * distorted.X + Pinhole.CenterXPx, Pinhole.FocalYPx * distorted.Y + Pinhole.CenterYPx);
            return isValid;
        }
    }
}
