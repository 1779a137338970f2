using System;
using LaserTracking.Detection;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// How much light of each laser reaches each pixel. The dot is a Gaussian on the screen, stretched where the light falls in
    /// obliquely, seen in perspective and blurred by lens and pixel; its energy is spread over the area that a pixel covers.
    /// </summary>
    internal sealed class LaserOptics
    {
        /// <summary>Light of projected white of brightness 1, W/m² (a 1000 lm projector on 2 m²).</summary>
        public const double WhiteWPerM2 = 2;

        /// <summary>Share of saturation that this white reaches in <see cref="ReferenceExposureUs"/> at gain 1.</summary>
        public const double WhiteLevel = 0.55;

        public const double ReferenceExposureUs = 16670;

        private readonly ColorCameraSettings _camera;
        private readonly ColorCameraGeometry _geometry;
        private readonly ShooterSettings[] _shooters;
        private readonly ShooterMotion[] _motions;

        public LaserOptics(SimulationScenario scenario, ColorCameraGeometry geometry, ShooterMotion[] motions)
        {
            _camera = scenario.ColorCamera;
            _geometry = geometry;
            _shooters = scenario.Shooters.ToArray();
            _motions = motions;
        }

        /// <summary>
        /// The dot's shape at a point of the picture (before bumps) at a time: covariance in px², and the signal in units of
        /// saturation that one µs of light brings to a pixel of unit share and unit response.
        /// </summary>
        public double Shape(int shooter, Vector2D imagePx, double timeS, out Covariance2D covariancePx)
        {
            Vector2D screen = _geometry.Screen.ToScreenM(imagePx);
            _geometry.ScreenToImage.Jacobian(screen, out double a, out double b, out double c, out double d);
            LaserSettings laser = _shooters[shooter].Laser;
            double sigma = laser.DotRadiusMm / 2000;
            Vector3D light = _motions[shooter].Hand(timeS).LightDirection;
            double cosine = Math.Max(0.1, light.Z), sine2 = light.X * light.X + light.Y * light.Y;
            double stretch = sine2 > 1e-12 ? (1 / (cosine * cosine) - 1) / sine2 : 0;
            var onScreen = new Covariance2D(sigma * sigma * (1 + stretch * light.X * light.X), sigma * sigma * stretch * light.X * light.Y,
                sigma * sigma * (1 + stretch * light.Y * light.Y));
            Covariance2D seen = onScreen.Transform(a, b, c, d);
            // A pixel averages over its square: variance 1/12 along each axis.
            double extra = _camera.BlurPx * _camera.BlurPx + 1.0 / 12;
            covariancePx = new Covariance2D(seen.XX + extra, seen.XY, seen.YY + extra);
            double areaM2 = 1 / Math.Abs(a * d - b * c);
            return laser.PowerMw / 1000 / areaM2 / WhiteWPerM2 * (WhiteLevel * _camera.Gain / ReferenceExposureUs);
        }

        /// <summary>Rise of the strongest channel at the middle of the dot, linear; 1 = saturation.</summary>
        public double Peak(int shooter, Vector2D imagePx, double timeS, double lightUs, double streakPx)
        {
            LaserSettings laser = _shooters[shooter].Laser;
            double signal = Shape(shooter, imagePx, timeS, out Covariance2D c) * lightUs;
            double determinant = c.XX * c.YY - c.XY * c.XY;
            LaserResponse.Of(laser.Color, out float red, out float green, out float blue);
            double sigma = Math.Sqrt(Math.Sqrt(determinant));
            double smear = Math.Sqrt(1 + streakPx * streakPx / (2 * Math.PI * sigma * sigma));
            double share = 1 - laser.HaloShare + laser.HaloShare * 2 / (laser.HaloScale * laser.HaloScale);
            return signal * Math.Max(red, Math.Max(green, blue)) * share / (2 * Math.PI * Math.Sqrt(determinant) * smear);
        }
    }
}
