using System;
using System.Numerics;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// The projected picture as light on camera 0's sensor: warped, blurred, vignetted, averaged over the pictures that an exposure
    /// saw. What does not move is computed once; each frame redoes the parts that do. Not thread-safe.
    /// </summary>
    internal sealed unsafe class CameraScene : IDisposable
    {
        private readonly SimulationScenario _scenario;
        private readonly ColorCameraSettings _camera;
        private readonly ColorCameraGeometry _geometry;
        private readonly PictureAssets _assets;
        private readonly LightSampler _light;
        private readonly ProjectorPicture _picture;
        private readonly ProjectorRaster _raster;
        private readonly SensorBlur _blur;
        private readonly ushort[] _still, _scene, _ambient;
        private readonly PixelRectList _inPicture = new PixelRectList();
        private readonly PixelRectList _redrawn = new PixelRectList();
        private readonly PixelRectList _stale = new PixelRectList();
        private PlaneMap _imageToPicture;
        private Vector2D _shiftPx;
        private bool _isBuilt;

        public CameraScene(SimulationScenario scenario, ColorCameraGeometry geometry, PictureAssets assets, LightSampler light)
        {
            _scenario = scenario;
            _camera = scenario.ColorCamera;
            _geometry = geometry;
            _assets = assets;
            _light = light;
            _picture = new ProjectorPicture(assets);
            _raster = new ProjectorRaster(assets.Width, assets.Height, scenario.Projector);
            _blur = new SensorBlur(_camera.Width, _camera.Height, _camera.BlurPx);
            int count = _camera.Width * _camera.Height * 4;
            _still = new ushort[count];
            _scene = new ushort[count];
            _ambient = new ushort[count];
        }

        /// <summary>Signals, 4 a pixel (blue, green, red, unused). May be drawn upon; tell <see cref="Spoil"/> where.</summary>
        public ushort[] Signals => _scene;

        /// <summary>Ambient light that is not in the signals because it flickers; null when it is.</summary>
        public ushort[]? Flickering => _scenario.Room.FlickerDepth > 0 ? _ambient : null;

        private PixelRect All => new PixelRect(0, 0, _camera.Width, _camera.Height);

        /// <summary>Signal of projected white of brightness 1 on the axis.</summary>
        private float WhiteSignal =>
            (float)(SensorModel.FullScale * LaserOptics.WhiteLevel * _camera.Gain * _camera.ExposureUs / LaserOptics.ReferenceExposureUs);

        /// <summary>These signals hold more than the scene and must be renewed with the next frame.</summary>
        public void Spoil(PixelRect rect) => _redrawn.Add(rect);

        /// <summary>Share of the light that vignetting leaves at a pixel.</summary>
        public static float Vignette(ColorCameraSettings camera, double x, double y)
        {
            double dx = 2 * x / (camera.Width - 1) - 1, dy = 2 * y / (camera.Height - 1) - 1;
            return (float)(1 - camera.Vignetting * (dx * dx + dy * dy) / 2);
        }

        /// <summary>Makes the signals those of a frame, without lasers.</summary>
        public void Prepare(int frame)
        {
            Vector2D shift = _light.ShiftPx(frame);
            if (!_isBuilt || !shift.Equals(_shiftPx))
                Build(shift);
            _stale.Clear();
            _stale.AddAll(_redrawn);
            foreach (PixelRect rect in _stale.Rects)
                Restore(rect);

            double refresh = _scenario.Projector.RefreshHz;
            int first = SimulationTruth.PictureShown(_scenario.Projector, _light.ExposureBeginUs(frame, 0));
            int last = SimulationTruth.PictureShown(_scenario.Projector, _light.ExposureBeginUs(frame, _camera.Height - 1) + _camera.ExposureUs - 1e-3);
            _inPicture.Clear();
            for (int k = first; k <= last; k++)
                _picture.AddMovingBounds(k / refresh, _inPicture);
            _redrawn.Clear();
            foreach (PixelRect rect in _inPicture.Rects)
                _redrawn.Add(InImage(rect).Grow(2 * _blur.Radius).Intersect(All));
            if (_redrawn.Rects.Length == 0)
                return;

            foreach (PixelRect rect in _redrawn.Rects)
                _blur.Clear(rect);
            for (int k = first; k <= last; k++)
            {
                _picture.Draw(k / refresh);
                _raster.Update(_picture.Image, _picture.Changed);
                foreach (PixelRect rect in _redrawn.Rects)
                    Gather(rect, frame, k);
            }

            foreach (PixelRect rect in _redrawn.Rects)
                Expose(rect, _scene);
        }

        public void Dispose() => _picture.Dispose();

        private void Build(Vector2D shift)
        {
            _isBuilt = true;
            _shiftPx = shift;
            _imageToPicture = _assets.ScreenToPicture * _geometry.ScreenToImage.Inverse * new PlaneMap(1, 0, -shift.X, 0, 1, -shift.Y, 0, 0, 1);
            new WallLight(_scenario, _geometry, shift).Fill(_ambient, WhiteSignal);
            PixelRect all = All;
            _picture.DrawStill();
            _raster.Update(_picture.Image, _picture.Changed);
            _blur.Clear(all);
            Gather(all, -1, 0);
            Expose(all, _still);
            _redrawn.Clear();
            _redrawn.Add(all);
        }

        private void Restore(PixelRect rect)
        {
            int length = (rect.Right - rect.Left) * 4;
            for (int y = rect.Top; y < rect.Bottom; y++)
            {
                int offset = (y * _camera.Width + rect.Left) * 4;
                Array.Copy(_still, offset, _scene, offset, length);
            }
        }

        // Adds a picture's light, weighed by the share of each row's exposure in which it was shown; all of it without a frame.
        private void Gather(PixelRect rect, int frame, int picture)
        {
            double showUs = 1e6 / _scenario.Projector.RefreshHz;
            double shownUs = picture * showUs + _scenario.Projector.DelayMs * 1000;
            for (int y = rect.Top; y < rect.Bottom; y++)
            {
                double weight = 1;
                if (frame >= 0)
                {
                    double begin = _light.ExposureBeginUs(frame, y);
                    weight = (Math.Min(begin + _camera.ExposureUs, shownUs + showUs) - Math.Max(begin, shownUs)) / _camera.ExposureUs;
                }

                if (weight > 1e-9)
                    _raster.AddRow(_imageToPicture, y, rect.Left, rect.Right, (float)weight, _blur.Row(y));
            }
        }

        // Light within a blur's reach of the gathered part's border is incomplete; it is the same as before there, so it stays.
        private void Expose(PixelRect gathered, ushort[] signals)
        {
            PixelRect rect = _blur.Complete(gathered);
            _blur.Run(rect);
            float white = WhiteSignal * (float)_scenario.Projector.Brightness;
            bool addAmbient = Flickering == null;
            // Vignetting as in Vignette(), its row part taken out of the loop.
            float fallX = 2f / (_camera.Width - 1), fallY = 2f / (_camera.Height - 1), lost = (float)_camera.Vignetting / 2;
            fixed (ushort* signalBase = signals, ambientBase = _ambient)
            {
                for (int y = rect.Top; y < rect.Bottom; y++)
                {
                    float dy = y * fallY - 1, rowWhite = white * (1 - lost * dy * dy), curve = white * lost;
                    fixed (Vector4* light = _blur.Result(y))
                    {
                        ushort* signal = signalBase + (y * _camera.Width + rect.Left) * 4;
                        ushort* ambient = ambientBase + (y * _camera.Width + rect.Left) * 4;
                        for (int x = rect.Left; x < rect.Right; x++, signal += 4, ambient += 4)
                        {
                            float dx = x * fallX - 1;
                            Vector4 value = light[x] * (rowWhite - curve * dx * dx) + new Vector4(0.5f);
                            if (addAmbient)
                                value += new Vector4(ambient[0], ambient[1], ambient[2], 0);
                            value = Vector4.Min(value, new Vector4(SensorModel.Largest));
                            signal[0] = (ushort)(int)value.X;
                            signal[1] = (ushort)(int)value.Y;
                            signal[2] = (ushort)(int)value.Z;
                        }
                    }
                }
            }
        }

        private PixelRect InImage(PixelRect inPicture)
        {
            PlaneMap toImage = _imageToPicture.Inverse;
            double left = double.PositiveInfinity, top = left, right = double.NegativeInfinity, bottom = right;
            for (int corner = 0; corner < 4; corner++)
            {
                Vector2D p = toImage.Map(new Vector2D(corner % 2 == 0 ? inPicture.Left - 1 : inPicture.Right, corner / 2 == 0 ? inPicture.Top - 1 : inPicture.Bottom));
                left = Math.Min(left, p.X);
                right = Math.Max(right, p.X);
                top = Math.Min(top, p.Y);
                bottom = Math.Max(bottom, p.Y);
            }

            var rect = new PixelRect((int)Math.Floor(left), (int)Math.Floor(top), (int)Math.Ceiling(right) + 1, (int)Math.Ceiling(bottom) + 1);
            return rect;
        }
    }
}
