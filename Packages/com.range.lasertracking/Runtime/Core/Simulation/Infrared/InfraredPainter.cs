using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// The infrared picture of a frame: the wall, noise, and the lasers that shine at 850 nm. Visible lasers are not in it; neither is
    /// the projected picture. Lives in the same moments as camera 0's frames. Not thread-safe.
    /// </summary>
    internal sealed unsafe class InfraredPainter
    {
        private const double ActiveFactor = 10;
        private const double TextureM = 0.35;
        private const int MaxWall = 65536;

        private readonly SimulationScenario _scenario;
        private readonly InfraredCameraSettings _camera;
        private readonly ColorCameraGeometry _geometry;
        private readonly PlaneMap _colorToInfrared;
        private readonly PlannedShot[] _shots;
        private readonly LightSampler _light;
        private readonly float[] _wall;
        private readonly float[] _scene;
        private readonly ushort[] _sigma = new ushort[MaxWall];
        private readonly short[] _gaussian = CounterRandom.GaussianTable();

        public InfraredPainter(SimulationScenario scenario, ColorCameraGeometry color, ColorCameraGeometry infrared, List<PlannedShot> shots, LightSampler light)
        {
            _scenario = scenario;
            _camera = scenario.InfraredCamera;
            _geometry = infrared;
            _colorToInfrared = infrared.ScreenToImage * color.ScreenToImage.Inverse;
            _shots = shots.ToArray();
            _light = light;
            _wall = new float[_camera.Width * _camera.Height];
            _scene = new float[_wall.Length];
            for (int i = 0; i < _sigma.Length; i++)
                _sigma[i] = (ushort)Math.Min(65535, 16 * Math.Sqrt(_camera.ReadNoiseCounts * _camera.ReadNoiseCounts + _camera.ShotNoise * i));
            FillWall();
        }

        /// <summary>Where camera 0 stands, moved by the baseline: the geometry of the infrared sensor.</summary>
        public static ColorCameraGeometry Geometry(SimulationScenario scenario, ColorCameraGeometry color, Vector2D screenSizeM)
        {
            InfraredCameraSettings infrared = scenario.InfraredCamera;
            return new ColorCameraGeometry(new ColorCameraSettings
            {
                Width = infrared.Width,
                Height = infrared.Height,
                FieldOfViewDeg = infrared.FieldOfViewDeg,
                PositionM = color.PositionM - new Vector3D(infrared.BaselineMm / 1000, 0, 0),
                LookAtM = scenario.ColorCamera.LookAtM,
                RollDeg = scenario.ColorCamera.RollDeg,
            }, screenSizeM);
        }

        public void Paint(int frame, Image target, long timeUs)
        {
            Array.Copy(_wall, _scene, _wall.Length);
            foreach (PlannedShot shot in _shots)
            {
                LaserSettings laser = _scenario.Shooters[shot.Shooter].Laser;
                if (laser.Color == LaserColor.Infrared && _light.TryGetLight(shot, frame, default, out double begin, out double end))
                    AddDots(shot, laser, begin, end);
            }

            target.Reset(PixelFormat.Infrared16, _camera.Width, _camera.Height, timeUs);
            uint key = (uint)CounterRandom.Hash(_scenario.Seed, RandomStream.InfraredNoise, _light.Timing.Exposure(frame));
            ushort* pixels = (ushort*)target.Pixels;
            fixed (short* gaussian = _gaussian)
            fixed (ushort* sigma = _sigma)
            fixed (float* scene = _scene)
            {
                for (int i = 0; i < _scene.Length; i++)
                {
                    int level = (int)Math.Min(65535, scene[i]);
                    int noisy = level + (gaussian[CounterRandom.Pixel((uint)i, key) >> 22] * sigma[level] + 2048 >> 12);
                    pixels[i] = (ushort)(noisy < 0 ? 0 : noisy > 65535 ? 65535 : noisy);
                }
            }
        }

        private void FillWall()
        {
            PlaneMap toScreen = _geometry.ScreenToImage.Inverse;
            double level = _camera.AmbientCounts * (_camera.Active ? ActiveFactor : 1);
            for (int y = 0; y < _camera.Height; y++)
            {
                for (int x = 0; x < _camera.Width; x++)
                {
                    Vector2D p = toScreen.Map(new Vector2D(x, y));
                    double swing = Math.Sin(2 * Math.PI * p.X / TextureM) * Math.Sin(2 * Math.PI * p.Y / (1.3 * TextureM));
                    _wall[y * _camera.Width + x] = (float)(level * (1 + _camera.WallContrast * swing));
                }
            }
        }

        private void AddDots(PlannedShot shot, LaserSettings laser, double begin, double end)
        {
            int count = _light.SampleCount(shot, default, begin, end);
            double counts = _camera.EmitterCounts * laser.PowerMw * (end - begin) / _scenario.ColorCamera.ExposureUs / count;
            for (int i = 0; i < count; i++)
            {
                Vector2D p = _colorToInfrared.Map(_light.ImagePx(shot, LightSampler.SampleTimeS(begin, end, i, count), default));
                AddDot(p, laser.DotRadiusMm / 2000, counts / (_camera.Active ? ActiveFactor : 1));
            }
        }

        private void AddDot(Vector2D p, double sigmaM, double counts)
        {
            _geometry.ScreenToImage.Jacobian(_geometry.Screen.ToScreenM(p), out double a, out double b, out double c, out double d);
            Covariance2D seen = Covariance2D.Isotropic(sigmaM).Transform(a, b, c, d);
            double extra = _camera.BlurPx * _camera.BlurPx + 1.0 / 12;
            double xx = seen.XX + extra, yy = seen.YY + extra, xy = seen.XY, determinant = xx * yy - xy * xy;
            double peak = counts / (2 * Math.PI * Math.Sqrt(determinant)), reach = 4 * Math.Sqrt(Math.Max(xx, yy));
            for (int y = (int)Math.Max(0, Math.Ceiling(p.Y - reach)); y <= Math.Min(_camera.Height - 1, p.Y + reach); y++)
            {
                for (int x = (int)Math.Max(0, Math.Ceiling(p.X - reach)); x <= Math.Min(_camera.Width - 1, p.X + reach); x++)
                {
                    double dx = x - p.X, dy = y - p.Y;
                    _scene[y * _camera.Width + x] += (float)(peak * Math.Exp(-0.5 * (yy * dx * dx - 2 * xy * dx * dy + xx * dy * dy) / determinant));
                }
            }
        }
    }
}
