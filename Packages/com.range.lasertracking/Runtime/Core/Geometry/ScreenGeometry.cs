using System;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// Where the projected screen lies in camera 0's picture: image px to screen m, its outline, its size. The camera's lens, where
    /// known, is corrected first, always. Immutable; mapping allocates nothing.
    /// </summary>
    public sealed class ScreenGeometry
    {
        private const int OutlinePointsPerEdge = 16;
        private readonly Homography _imageToScreen;
        private readonly Homography _screenToImage;
        private readonly Vector2D[] _cornersPx;

        /// <param name="imageToScreen">Maps image px, free of lens distortion, to screen m (origin top-left, x right, y down).</param>
        /// <param name="screenSizeM">Width and height of the projected picture.</param>
        /// <param name="camera">The camera with its lens; null: it has no distortion worth correcting.</param>
        /// <param name="uncertainty">How far the inverse mapping, screen m to image px, may be off; null: not known, taken as exact.</param>
        /// <param name="isFocalLengthKnown">False for a lens that was found from the screen's own points: its focal length is nominal.</param>
        public ScreenGeometry(Homography imageToScreen, Vector2D screenSizeM, LensCamera? camera = null, HomographyUncertainty? uncertainty = null, bool isFocalLengthKnown = true)
        {
            IsFocalLengthKnown = camera != null && isFocalLengthKnown;
            _imageToScreen = imageToScreen;
            _screenToImage = imageToScreen.Inverse;
            ScreenSizeM = screenSizeM;
            Camera = camera;
            Uncertainty = uncertainty;
            _cornersPx = CornersOf(screenSizeM);
            for (int i = 0; i < 4; i++)
                _cornersPx[i] = ToImagePx(_cornersPx[i]);
        }

        public Vector2D ScreenSizeM { get; }

        /// <summary>Camera 0 with its lens; null when not known.</summary>
        public LensCamera? Camera { get; }

        /// <summary>The camera's focal length is a measured one: with it pixels are directions in space. A plane alone does not show it.</summary>
        public bool IsFocalLengthKnown { get; }

        /// <summary>Of screen m to image px free of distortion, in px²; null when not known.</summary>
        public HomographyUncertainty? Uncertainty { get; }

        /// <summary>Of the picture as the camera would take it without distortion.</summary>
        public Homography ImageToScreen => _imageToScreen;

        /// <summary>The screen's corners in the image, top-left first, clockwise as seen. Not finite where the lens model does not reach.</summary>
        public Vector2D[] CornersPx => (Vector2D[])_cornersPx.Clone();

        /// <summary>The smallest convex outline of the screen in the image: with a barrel lens its edges bulge beyond the corners' quad.</summary>
        public Vector2D[] OutlinePx
        {
            get
            {
                if (Camera == null)
                    return CornersPx;
                var outline = new Vector2D[4 * OutlinePointsPerEdge];
                Vector2D[] corners = CornersOf(ScreenSizeM);
                int count = 0;
                for (int i = 0; i < outline.Length; i++)
                {
                    Vector2D a = corners[i / OutlinePointsPerEdge], b = corners[(i / OutlinePointsPerEdge + 1) % 4];
                    Vector2D point = ToImagePx(a + (b - a) * ((double)(i % OutlinePointsPerEdge) / OutlinePointsPerEdge));
                    if (point.IsFinite)
                        outline[count++] = point;
                }

                return Polygon2D.ConvexHull(outline.AsSpan(0, count));
            }
        }

        /// <summary>The screen's corners in its own plane, metres, top-left first, clockwise.</summary>
        public static Vector2D[] CornersOf(Vector2D screenSizeM) =>
            new[] { default, new Vector2D(screenSizeM.X, 0), screenSizeM, new Vector2D(0, screenSizeM.Y) };

        /// <summary>
        /// Fits measured points: lens first, then the homography with the least squared error in the image, and its uncertainty.
        /// </summary>
        /// <param name="imagePx">Where the camera sees the points, at least four.</param>
        /// <param name="screenM">Where the projector drew them.</param>
        /// <param name="screenSizeM">Width and height of the projected picture.</param>
        /// <param name="camera">The camera with its lens, or null.</param>
        /// <param name="expectedSigmaPx">How well one coordinate is expected to be measured, above zero; see <see cref="HomographyFit"/>.</param>
        /// <param name="screen">Valid only when true is returned.</param>
        /// <param name="reason">Why it was refused, one line; empty on success.</param>
        /// <param name="commonSigmaPx">Error that neighbours share; see <see cref="HomographyFit"/>.</param>
        public static bool TryFit(ReadOnlySpan<Vector2D> imagePx, ReadOnlySpan<Vector2D> screenM, Vector2D screenSizeM, LensCamera? camera, double expectedSigmaPx, out ScreenGeometry? screen, out string reason, double commonSigmaPx = 0)
        {
            screen = null;
            Vector2D[] ideal = imagePx.ToArray();
            var pixelByIdeal = new double[camera == null ? 0 : 4 * ideal.Length];
            for (int i = 0; i < ideal.Length && camera != null; i++)
            {
                if (!ideal[i].IsFinite)
                    continue;
                if (camera.TryUndistort(imagePx[i], out ideal[i]))
                {
                    camera.DistortionJacobian(imagePx[i], pixelByIdeal.AsSpan(4 * i, 4));
                    continue;
                }

                reason = FormattableString.Invariant($"point {i + 1} at {imagePx[i].X:F1},{imagePx[i].Y:F1} px lies outside what the camera's lens model covers");
                return false;
            }

            if (!HomographyFit.TryFit(screenM, ideal, pixelByIdeal, expectedSigmaPx, out HomographyFit? fit, out reason, commonSigmaPx))
                return false;
            screen = new ScreenGeometry(fit!.Homography.Inverse, screenSizeM, camera, fit.Uncertainty);
            return true;
        }

        /// <summary>The place on the screen that is seen at a pixel; not finite on the horizon or where the lens model does not reach.</summary>
        public Vector2D ToScreenM(Vector2D imagePx) => _imageToScreen.Map(Undistort(imagePx));

        /// <summary>Where a place on the screen is seen; not finite where the lens model does not reach.</summary>
        public Vector2D ToImagePx(Vector2D screenM)
        {
            Vector2D ideal = _screenToImage.Map(screenM);
            if (Camera == null)
                return ideal;
            return Camera.TryDistort(ideal, out Vector2D pixel) ? pixel : new Vector2D(double.NaN, double.NaN);
        }

        /// <summary>Metres on the screen by pixels of the image at a pixel: dx' = xx dx + xy dy, dy' = yx dx + yy dy.</summary>
        public void Jacobian(Vector2D imagePx, out double xx, out double xy, out double yx, out double yy)
        {
            _imageToScreen.Jacobian(Undistort(imagePx), out xx, out xy, out yx, out yy);
            if (Camera == null)
                return;
            LensJacobian(imagePx, out double a, out double b, out double c, out double d);
            (xx, xy) = (xx * a + xy * c, xx * b + xy * d);
            (yx, yy) = (yx * a + yy * c, yx * b + yy * d);
        }

        /// <summary>
        /// Carries a covariance in px² to mm² on the screen, linearised at the point, and adds how far the calibration itself may be off.
        /// </summary>
        public Covariance2D ToScreenMm2(Vector2D imagePx, Covariance2D covariancePx)
        {
            Vector2D ideal = Undistort(imagePx);
            if (Camera != null)
            {
                LensJacobian(imagePx, out double xx, out double xy, out double yx, out double yy);
                covariancePx = covariancePx.Transform(xx, xy, yx, yy);
            }

            if (Uncertainty != null)
            {
                Span<double> byLens = stackalloc double[Camera == null ? 0 : 2 * Uncertainty.LensCoefficients];
                if (byLens.Length > 0)
                    LensDerivatives(imagePx, byLens);
                covariancePx += Uncertainty.At(_imageToScreen.Map(ideal), byLens);
            }

            _imageToScreen.Jacobian(ideal, out double a, out double b, out double c, out double d);
            return covariancePx.Transform(a * 1000, b * 1000, c * 1000, d * 1000);
        }

        private Vector2D Undistort(Vector2D imagePx)
        {
            if (Camera == null)
                return imagePx;
            return Camera.TryUndistort(imagePx, out Vector2D ideal) ? ideal : new Vector2D(double.NaN, double.NaN);
        }

        /// <summary>
        /// How far a pixel's own place free of distortion falls behind where the homography would put it, by k1 and k2: 2×2, row by row.
        /// </summary>
        private void LensDerivatives(Vector2D imagePx, Span<double> byLens)
        {
            Span<double> byRay = stackalloc double[4], by = stackalloc double[10];
            Camera!.TryUnproject(imagePx, out Vector2D ray);
            Camera.Distortion.Distort(ray, byRay, by);
            LensJacobian(imagePx, out double xx, out double xy, out double yx, out double yy);
            for (int k = 0; k < PlaneLens.Coefficients; k++)
            {
                double x = by[k] * Camera.Pinhole.FocalXPx, y = by[5 + k] * Camera.Pinhole.FocalYPx;
                byLens[k] = xx * x + xy * y;
                byLens[PlaneLens.Coefficients + k] = yx * x + yy * y;
            }
        }

        /// <summary>Pixels free of distortion by pixels, at a pixel.</summary>
        private void LensJacobian(Vector2D imagePx, out double xx, out double xy, out double yx, out double yy)
        {
            Span<double> by = stackalloc double[4];
            Camera!.DistortionJacobian(imagePx, by);
            double determinant = by[0] * by[3] - by[1] * by[2];
            xx = by[3] / determinant;
            xy = -by[1] / determinant;
            yx = -by[2] / determinant;
            yy = by[0] / determinant;
        }
    }
}
