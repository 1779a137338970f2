using System;
using System.Collections.Generic;
using LaserTracking.Detection;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// Adds the lasers' light to a scene's signals before the sensor clips them: a Gaussian core along the dot's way, a wide halo
    /// (Moffat profile, exponent 2) and speckle. Not thread-safe.
    /// </summary>
    internal sealed unsafe class LaserPainter
    {
        // Light below this many signal units is left out: a sixth of the darkest noise.
        private const double Faintest = 2;

        private readonly SimulationScenario _scenario;
        private readonly PlannedShot[] _shots;
        private readonly LightSampler _light;
        private readonly LaserOptics _optics;
        private readonly float[] _energy;
        private readonly float[] _exponential = new float[64 * 64 + 2];
        private readonly short[] _gaussian = CounterRandom.GaussianTable();

        public LaserPainter(SimulationScenario scenario, List<PlannedShot> shots, LightSampler light, LaserOptics optics)
        {
            _scenario = scenario;
            _shots = shots.ToArray();
            _light = light;
            _optics = optics;
            _energy = new float[scenario.ColorCamera.Width * scenario.ColorCamera.Height];
            for (int i = 0; i < _exponential.Length; i++)
                _exponential[i] = (float)Math.Exp(-i / 128.0);
        }

        public void Paint(int frame, CameraScene scene)
        {
            Vector2D shift = _light.ShiftPx(frame);
            for (int i = 0; i < _shots.Length; i++)
            {
                if (_light.TryGetLight(_shots[i], frame, shift, out double begin, out double end))
                    Paint(i, frame, shift, begin, end, scene);
            }
        }

        private void Paint(int index, int frame, Vector2D shift, double begin, double end, CameraScene scene)
        {
            PlannedShot shot = _shots[index];
            ColorCameraSettings camera = _scenario.ColorCamera;
            LaserSettings laser = _scenario.Shooters[shot.Shooter].Laser;
            double middleS = (begin + end) / 2e6;
            Vector2D middle = _light.ImagePx(shot, middleS, shift);
            double signal = _optics.Shape(shot.Shooter, middle - shift, middleS, out Covariance2D shape) * (end - begin) * SensorModel.FullScale;
            signal *= CameraScene.Vignette(camera, middle.X, middle.Y);
            LaserResponse.Of(laser.Color, out float red, out float green, out float blue);
            double strongest = Math.Max(red, Math.Max(green, blue));
            double root = Math.Sqrt(shape.XX * shape.YY - shape.XY * shape.XY);
            double widest = Math.Sqrt(Math.Max(shape.XX, shape.YY));
            var all = new PixelRect(0, 0, camera.Width, camera.Height);

            double core = signal * (1 - laser.HaloShare) / (2 * Math.PI * root);
            double reach = core * strongest > Faintest ? Math.Sqrt(Math.Min(62, 2 * Math.Log(core * strongest / Faintest))) * widest : 0;
            double scale2 = laser.HaloScale * laser.HaloScale;
            double halo = signal * laser.HaloShare / (Math.PI * scale2 * root);
            double haloReach = halo * strongest > Faintest ? Math.Sqrt(scale2 * (Math.Sqrt(halo * strongest / Faintest) - 1)) * widest : 0;
            haloReach = Math.Min(haloReach, camera.Width / 8.0);

            int count = _light.SampleCount(shot, shift, begin, end), haloCount = Math.Min(count, 4);
            Vector2D first = _light.ImagePx(shot, begin / 1e6, shift), last = _light.ImagePx(shot, end / 1e6, shift);
            PixelRect touched = default;
            for (int i = 0; i < count; i++)
                touched = touched.Union(Around(_light.ImagePx(shot, LightSampler.SampleTimeS(begin, end, i, count), shift), Math.Max(reach, haloReach)).Intersect(all));
            if (touched.IsEmpty)
                return;
            for (int i = 0; i < count; i++)
                AddCore(_light.ImagePx(shot, LightSampler.SampleTimeS(begin, end, i, count), shift), reach, shape, (float)(core / count), all);
            for (int i = 0; i < haloCount; i++)
                AddHalo(_light.ImagePx(shot, LightSampler.SampleTimeS(begin, end, i, haloCount), shift), haloReach, shape, (float)(halo / haloCount), (float)scale2, all);

            // A moving dot averages over its grains.
            double contrast = laser.SpeckleContrast / Math.Sqrt(1 + (last - first).Length / 1.5);
            ulong key = CounterRandom.Hash(_scenario.Seed, RandomStream.Speckle, index, _light.Timing.Exposure(frame));
            Transfer(touched, scene.Signals, red, green, blue, (float)(contrast / 256), (uint)key);
            scene.Spoil(touched);
        }

        private static PixelRect Around(Vector2D p, double reach)
        {
            if (!p.IsFinite || Math.Abs(p.X) > 1e6 || Math.Abs(p.Y) > 1e6)
                return default;
            return new PixelRect((int)Math.Floor(p.X - reach), (int)Math.Floor(p.Y - reach), (int)Math.Ceiling(p.X + reach) + 1, (int)Math.Ceiling(p.Y + reach) + 1);
        }

        private void AddCore(Vector2D p, double reach, Covariance2D shape, float peak, PixelRect all)
        {
            PixelRect rect = Around(p, reach).Intersect(all);
            double determinant = shape.XX * shape.YY - shape.XY * shape.XY;
            double a = shape.YY / determinant, b = -2 * shape.XY / determinant, c = shape.XX / determinant;
            for (int y = rect.Top; y < rect.Bottom; y++)
            {
                double dy = y - p.Y;
                int row = y * _scenario.ColorCamera.Width;
                for (int x = rect.Left; x < rect.Right; x++)
                {
                    double dx = x - p.X;
                    float u = (float)((a * dx * dx + b * dx * dy + c * dy * dy) * 64);
                    if (u >= 64 * 64)
                        continue;
                    int i = (int)u;
                    _energy[row + x] += peak * (_exponential[i] + (_exponential[i + 1] - _exponential[i]) * (u - i));
                }
            }
        }

        private void AddHalo(Vector2D p, double reach, Covariance2D shape, float peak, float scale2, PixelRect all)
        {
            PixelRect rect = Around(p, reach).Intersect(all);
            double determinant = shape.XX * shape.YY - shape.XY * shape.XY;
            double a = shape.YY / determinant, b = -2 * shape.XY / determinant, c = shape.XX / determinant;
            for (int y = rect.Top; y < rect.Bottom; y++)
            {
                double dy = y - p.Y;
                int row = y * _scenario.ColorCamera.Width;
                for (int x = rect.Left; x < rect.Right; x++)
                {
                    double dx = x - p.X;
                    float fall = scale2 / (scale2 + (float)(a * dx * dx + b * dx * dy + c * dy * dy));
                    _energy[row + x] += peak * fall * fall;
                }
            }
        }

        private void Transfer(PixelRect rect, ushort[] signals, float red, float green, float blue, float contrast, uint key)
        {
            for (int y = rect.Top; y < rect.Bottom; y++)
            {
                for (int x = rect.Left; x < rect.Right; x++)
                {
                    int index = y * _scenario.ColorCamera.Width + x;
                    float energy = _energy[index];
                    _energy[index] = 0;
                    if (contrast > 0)
                        energy *= Math.Max(0, 1 + contrast * _gaussian[CounterRandom.Pixel((uint)index, key) >> 22]);
                    index *= 4;
                    signals[index] = (ushort)Math.Min(SensorModel.Largest, signals[index] + energy * blue + 0.5f);
                    signals[index + 1] = (ushort)Math.Min(SensorModel.Largest, signals[index + 1] + energy * green + 0.5f);
                    signals[index + 2] = (ushort)Math.Min(SensorModel.Largest, signals[index + 2] + energy * red + 0.5f);
                }
            }
        }
    }
}
