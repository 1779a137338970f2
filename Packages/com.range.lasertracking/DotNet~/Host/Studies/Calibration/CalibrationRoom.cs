using System;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Patterns;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Studies.Calibration
{
    /// <summary>
    /// A room drawn at random in which the calibration's pictures are shown: where the camera stands and how it looks, its size, lens,
    /// blur, noise and format, lamps, a person before the screen, a bump now and then.
    /// </summary>
    internal sealed class CalibrationRoom
    {
        /// <summary>Four frames a picture: less than a thirteenth of the ten seconds that a real capture may take.</summary>
        private const double HoldMs = 133.4;

        private readonly Random _random;

        public CalibrationRoom(int seed)
        {
            _random = new Random(seed);
            var scenario = new SimulationScenario { Name = "calibration", Seed = seed, DurationS = HoldMs * ScreenPattern.Pictures / 1000 };
            scenario.DepthCamera.Enabled = false;
            scenario.Projector.Content = ProjectedContent.Calibration;
            scenario.Projector.PatternHoldMs = HoldMs;
            scenario.Projector.Brightness = Uniform(0.4, 1.1);
            Vector2D size = SimulationScenes.Empty().ScreenSizeM;
            SetCamera(scenario.ColorCamera, size);
            scenario.Room.Ambient = Math.Exp(Uniform(Math.Log(0.005), Math.Log(0.3)));
            if (Chance(0.5))
            {
                scenario.Room.Lamp = Uniform(0.05, 0.6);
                scenario.Room.LampM = new Vector2D(Uniform(-0.3, size.X + 0.3), Uniform(-0.3, size.Y));
            }

            HasPerson = Chance(0.5);
            if (HasPerson)
            {
                scenario.Room.Obstacles.Add(new ObstacleSettings
                {
                    TopM = new Vector2D(Uniform(0, size.X), Uniform(0.3, 0.8) * size.Y),
                    WidthM = Uniform(0.35, 0.9),
                    Reflectance = Uniform(0.05, 0.6),
                    ParallaxM = new Vector2D(Uniform(-0.5, 0.5), Uniform(-0.3, 0.1)),
                });
            }

            IsBumped = Chance(0.1);
            if (IsBumped)
            {
                double angle = Uniform(0, 2 * Math.PI), px = Uniform(2, 12);
                scenario.Nudges.Add(new NudgeSettings { TimeS = Uniform(0.1, 0.45), ShiftPx = new Vector2D(px * Math.Cos(angle), px * Math.Sin(angle)) });
            }

            Range = new SimulatedRange(scenario, SimulationScenes.Empty());
        }

        public SimulatedRange Range { get; }

        public bool HasPerson { get; }

        public bool IsBumped { get; }

        public bool IsBlurred { get; private set; }

        /// <summary>How far all bumps together displaced the picture, px.</summary>
        public Vector2D BumpPx => IsBumped ? Range.Scenario.Nudges[0].ShiftPx : default;

        public ScreenPatternView Look()
        {
            using var finder = new ScreenPatternFinder();
            using IFrameSource source = Range.CreateColorSource();
            using var frame = new Frame();
            while (source.TryRead(frame))
                finder.Add(frame.Color);
            return finder.Find();
        }

        private void SetCamera(ColorCameraSettings camera, Vector2D size)
        {
            (camera.Width, camera.Height) = _random.Next(5) switch { 0 => (640, 480), 1 => (1920, 1080), _ => (1280, 720) };
            camera.PositionM = new Vector3D(Uniform(-0.1, 1.1) * size.X, Uniform(-0.4, 1.1) * size.Y, -Uniform(0.9, 1.9) * size.X);
            camera.LookAtM = new Vector2D(Uniform(0.45, 0.55) * size.X, Uniform(0.45, 0.55) * size.Y);
            camera.RollDeg = Uniform(-5, 5);
            if (Chance(0.5))
            {
                var middle = new Vector3D(size.X / 2, size.Y / 2, 0);
                double half = size.X / 2 / (camera.PositionM.Value - middle).Length;
                camera.FieldOfViewDeg = 360 / Math.PI * Math.Atan(half * Uniform(1.2, 2));
            }

            IsBlurred = Chance(0.1);
            camera.BlurPx = Math.Min(6, camera.Width / 1280.0 * (IsBlurred ? Uniform(3, 5) : Uniform(0.4, 2)));
            camera.FullWellElectrons = Uniform(2500, 15000);
            camera.ReadNoiseElectrons = Uniform(2, 15);
            camera.Gain = Uniform(0.5, 1.4);
            camera.Vignetting = Uniform(0, 0.5);
            camera.LensK1 = Uniform(-0.2, 0.05);
            camera.LensK2 = Uniform(-0.02, 0.06);
            camera.Format = _random.Next(3) switch { 0 => PixelFormat.Bgra32, 1 => PixelFormat.Nv12, _ => PixelFormat.Yuy2 };
            camera.JpegQuality = camera.Format != PixelFormat.Bgra32 && Chance(0.5) ? _random.Next(70, 95) : 0;
            camera.RollingShutterRowUs = Chance(0.5) ? 10 : 0;
            camera.ExposureUs = 16667;
        }

        private bool Chance(double share) => _random.NextDouble() < share;

        private double Uniform(double low, double high) => low + (high - low) * _random.NextDouble();
    }
}
