using System;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>Ambient light reflected by the screen, its black frame and the wall around it, as camera 0 sees them.</summary>
    internal sealed class WallLight
    {
        private const double FrameM = 0.05;
        private const float ScreenReflectance = 1;
        private const float FrameReflectance = 0.05f;
        private const float WallReflectance = 0.45f;

        private readonly SimulationScenario _scenario;
        private readonly ColorCameraGeometry _geometry;
        private const double LampRadiusM = 0.6;
        private readonly Vector2D _shiftPx;
        private readonly LensMap? _lens;

        public WallLight(SimulationScenario scenario, ColorCameraGeometry geometry, Vector2D shiftPx, LensMap? lens)
        {
            _lens = lens;
            _scenario = scenario;
            _geometry = geometry;
            _shiftPx = shiftPx;
        }

        /// <summary>Signals, four a pixel.</summary>
        public void Fill(ushort[] signals, float whiteSignal)
        {
            ColorCameraSettings camera = _scenario.ColorCamera;
            Vector2D size = _geometry.Screen.ScreenSizeM;
            PlaneMap toScreen = _geometry.ScreenToImage.Inverse;
            toScreen.Jacobian(new Vector2D(camera.Width / 2.0, camera.Height / 2.0), out double a, out double b, out double c, out double d);
            double pixelM = Math.Sqrt(Math.Abs(a * d - b * c)) * (1 + camera.BlurPx);
            double floor = size.Y + _scenario.Room.FloorBelowScreenM;
            for (int y = 0; y < camera.Height; y++)
            {
                for (int x = 0; x < camera.Width; x++)
                {
                    Vector2D p = toScreen.Map(IdealPx(x, y));
                    double outside = ZoneDistance.Box(p - size * 0.5, size.X / 2, size.Y / 2);
                    float frame = Cover(outside, pixelM), wall = Cover(outside - FrameM, pixelM);
                    float grain = 0.94f + 0.12f * ValueNoise.At(p.X * 5, p.Y * 5, 50);
                    // The picture's own light comes back from the room and glows on the wall close to it.
                    double glow = 0.012 * _scenario.Projector.Brightness * Math.Exp(-Math.Max(0, outside) / 0.5);
                    float around = WallReflectance * grain * (p.Y > floor ? 0.4f : 1);
                    float reflectance = ScreenReflectance + (FrameReflectance - ScreenReflectance) * frame;
                    reflectance += (around - reflectance) * wall;
                    foreach (ObstacleSettings obstacle in _scenario.Room.Obstacles)
                        reflectance = obstacle.Hides(p) ? (float)obstacle.Reflectance : reflectance;
                    double lamp = _scenario.Room.Lamp == 0 ? 0 : _scenario.Room.Lamp * Math.Exp(-(p - _scenario.Room.LampM).LengthSquared / (2 * LampRadiusM * LampRadiusM));
                    float level = (float)((_scenario.Room.Ambient + lamp) * reflectance + glow * Math.Min(reflectance, around) * frame);
                    level *= whiteSignal * CameraScene.Vignette(camera, x, y);
                    int offset = (y * camera.Width + x) * 4;
                    signals[offset] = Signal(level * 0.9f);
                    signals[offset + 1] = Signal(level);
                    signals[offset + 2] = Signal(level * 1.06f);
                }
            }
        }

        private Vector2D IdealPx(int x, int y)
        {
            if (_lens == null)
                return new Vector2D(x, y) - _shiftPx;
            System.Numerics.Vector2 ideal = _lens.At(x, y);
            return new Vector2D(ideal.X, ideal.Y);
        }

        private static float Cover(double outside, double pixelM) => (float)Math.Max(0, Math.Min(1, 0.5 + outside / pixelM));

        private static ushort Signal(float value) => (ushort)Math.Min(SensorModel.Largest, value + 0.5f);
    }
}
