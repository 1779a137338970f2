using System;

namespace LaserTracking.Geometry
{
    /// <summary>Where the projected screen lies in camera 0's picture: image px to screen m, its outline, its size. Immutable.</summary>
    public sealed class ScreenGeometry
    {
        private readonly Homography _imageToScreen;
        private readonly Homography _screenToImage;
        private readonly Vector2D[] _cornersPx;

        /// <param name="imageToScreen">Maps image px to screen m (origin top-left, x right, y down).</param>
        /// <param name="screenSizeM">Width and height of the projected picture.</param>
        public ScreenGeometry(Homography imageToScreen, Vector2D screenSizeM)
        {
            _imageToScreen = imageToScreen;
            _screenToImage = imageToScreen.Inverse;
            ScreenSizeM = screenSizeM;
            _cornersPx = new[]
            {
                _screenToImage.Map(new Vector2D(0, 0)),
                _screenToImage.Map(new Vector2D(screenSizeM.X, 0)),
                _screenToImage.Map(screenSizeM),
                _screenToImage.Map(new Vector2D(0, screenSizeM.Y)),
            };
        }

        public Vector2D ScreenSizeM { get; }

        public Homography ImageToScreen => _imageToScreen;

        /// <summary>The screen's corners in the image, top-left first, clockwise as seen.</summary>
        public Vector2D[] CornersPx => (Vector2D[])_cornersPx.Clone();

        public Vector2D ToScreenM(Vector2D imagePx) => _imageToScreen.Map(imagePx);

        public Vector2D ToImagePx(Vector2D screenM) => _screenToImage.Map(screenM);

        /// <summary>Carries a covariance in px² to mm² on the screen, linearised at the point.</summary>
        public Covariance2D ToScreenMm2(Vector2D imagePx, Covariance2D covariancePx)
        {
            _imageToScreen.Jacobian(imagePx, out double a, out double b, out double c, out double d);
            return covariancePx.Transform(a * 1000, b * 1000, c * 1000, d * 1000);
        }
    }
}
