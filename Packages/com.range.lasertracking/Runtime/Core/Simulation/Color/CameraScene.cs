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
        private readonly Vector4[] _row;
        private PlaneMap _imageToPicture;
        private LensMap? _lens;
        private ObstacleSettings?[]? _hiddenBy;
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
            _row = new Vector4[_camera.Width];
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
            _lens = _geometry.Lens == null ? null : new LensMap(_geometry.Lens, shift);
            Vector2D taken = _lens == null ? shift : default;
            _imageToPicture = _assets.ScreenToPicture * _geometry.ScreenToImage.Inverse * new PlaneMap(1, 0, -taken.X, 0, 1, -taken.Y, 0, 0, 1);
            new WallLight(_scenario, _geometry, shift, _lens).Fill(_ambient, WhiteSignal);
            _hiddenBy = _scenario.Room.Obstacles.Count == 0 ? null : FindHidden();
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

                if (weight > 1e-9 && _hiddenBy == null)
                    Gather(_imageToPicture, y, rect.Left, rect.Right, (float)weight, _blur.Row(y));
                else if (weight > 1e-9)
                    GatherBehind(y, rect, (float)weight, _blur.Row(y));
            }
        }

        private void Gather(in PlaneMap map, int y, int left, int right, float weight, Span<Vector4> row)
        {
            if (_lens == null)
                _raster.AddRow(map, y, left, right, weight, row);
            else
                _raster.AddRow(map, _lens, y, left, right, weight, row);
        }

        /// <summary>By pixel, who stands in front of it.</summary>
        private ObstacleSettings?[] FindHidden()
        {
            var hiddenBy = new ObstacleSettings?[_camera.Width * _camera.Height];
            PlaneMap toScreen = _assets.ScreenToPicture.Inverse * _imageToPicture;
            for (int i = 0; i < hiddenBy.Length; i++)
            {
                int x = i % _camera.Width, y = i / _camera.Width;
                Vector2 ideal = _lens?.At(x, y) ?? new Vector2(x, y);
                Vector2D p = toScreen.Map(new Vector2D(ideal.X, ideal.Y));
                foreach (ObstacleSettings obstacle in _scenario.Room.Obstacles)
                    hiddenBy[i] = obstacle.Hides(p) ? obstacle : hiddenBy[i];
            }

            return hiddenBy;
        }

        /// <summary>The picture on the screen where nobody hides it; elsewhere what falls on them, displaced and dimmer.</summary>
        private void GatherBehind(int y, PixelRect rect, float weight, Span<Vector4> row)
        {
            AddWhere(null, _imageToPicture, y, rect.Left, rect.Right, weight, row);
            foreach (ObstacleSettings obstacle in _scenario.Room.Obstacles)
            {
                int first = rect.Left, end = rect.Right;
                while (first < end && _hiddenBy![y * _camera.Width + first] != obstacle)
                    first++;
                while (end > first && _hiddenBy![y * _camera.Width + end - 1] != obstacle)
                    end--;
                if (first == end)
                    continue;
                PlaneMap aside = _assets.ScreenToPicture * new PlaneMap(1, 0, obstacle.ParallaxM.X, 0, 1, obstacle.ParallaxM.Y, 0, 0, 1) * _assets.ScreenToPicture.Inverse * _imageToPicture;
                AddWhere(obstacle, aside, y, first, end, (float)(weight * obstacle.Reflectance), row);
            }
        }

        // Nothing is added and taken off again: what rounding leaves of that may lie below zero.
        private void AddWhere(ObstacleSettings? hiddenBy, in PlaneMap map, int y, int left, int right, float weight, Span<Vector4> row)
        {
            Array.Clear(_row, left, right - left);
            Gather(map, y, left, right, weight, _row);
            for (int x = left; x < right; x++)
            {
                if (_hiddenBy![y * _camera.Width + x] == hiddenBy)
                    row[x] += _row[x];
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
            if (_lens != null)
                return All;
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
