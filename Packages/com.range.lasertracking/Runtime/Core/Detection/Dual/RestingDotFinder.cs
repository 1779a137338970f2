using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Finds green dots that were there before anybody looked: a part of the colour picture a frame is searched for green excess over
    /// the surroundings, and what looks like a dot is then watched in every frame. The cost of a full search is spread over frames,
    /// which a light at rest can wait for.
    /// </summary>
    internal sealed unsafe class RestingDotFinder
    {
        private const int Capacity = 32;
        private const int Neighbor = 3;
        private const int RowStep = 37;
        private const double RestPx = 2;
        private const double FollowPx = 12;

        private readonly DualDetectorSettings _settings;
        private readonly ColorProbe _probe;
        private readonly KernelRunner _kernels;
        private readonly RestingDot[] _dots = new RestingDot[Capacity];
        private byte[] _tiles = Array.Empty<byte>();
        private uint[] _rows = Array.Empty<uint>();
        private int _columns;
        private int _tileRows;
        private int _width;
        private int _height;
        private PixelFormat _format;
        private int _count;
        private int _turn;
        private int _examined;

        public RestingDotFinder(DualDetectorSettings settings, ColorProbe probe, KernelRunner kernels)
        {
            _kernels = kernels;
            _settings = settings;
            _probe = probe;
        }

        /// <summary>What is watched; a dot counts once it has rested for <see cref="DualDetectorSettings.RestFrames"/>.</summary>
        public ReadOnlySpan<RestingDot> Dots => new ReadOnlySpan<RestingDot>(_dots, 0, _count);

        public void Reset() => _width = 0;

        public void Update(Image image)
        {
            bool isStart = image.Width != _width || image.Height != _height || image.Format != _format;
            if (isStart)
                Resize(image);
            Watch(image);
            int part = _turn++ % _settings.PatrolParts;
            Reduce(image, isStart ? 0 : part, isStart ? 1 : _settings.PatrolParts);

            // Where more looks like a dot than there is time for, another place comes first each time.
            int first = _turn * RowStep % _tileRows;
            _examined = 0;
            for (int i = 0; i < _tileRows; i++)
            {
                int row = (first + i) % _tileRows;
                if (isStart || row % _settings.PatrolParts == part)
                    Search(image, row);
            }
        }

        private void Resize(Image image)
        {
            _width = image.Width;
            _height = image.Height;
            _format = image.Format;
            _columns = TileKernel.Count(_width);
            _tileRows = TileKernel.Count(_height);
            _tiles = new byte[_columns * _tileRows];
            _rows = new uint[_format == PixelFormat.Bgra32 ? 0 : TileKernel.Size * _width * _kernels.BandCount];
            _count = _turn = 0;
        }

        private void Watch(Image image)
        {
            double scale = Math.Max(0.25, _width / 1920.0);
            int kept = 0;
            for (int i = 0; i < _count; i++)
            {
                RestingDot dot = _dots[i];
                double reach = (dot.Frames >= _settings.RestFrames ? FollowPx : RestPx) * scale + 0.5;
                Vector2D before = dot.PositionPx;

                // What was bright enough once may flicker a little.
                if (_probe.Look(image, before, reach + 2) != LightHue.Green || _probe.RelativeRise < 0.7 * _settings.MinRestingRise)
                    continue;
                Take(ref dot);
                if ((dot.PositionPx - before).Length <= reach && !IsWatched(dot.PositionPx, scale, kept))
                    _dots[kept++] = dot;
            }

            _count = kept;
        }

        private void Take(ref RestingDot dot)
        {
            dot.PositionPx = _probe.Spot.PositionPx;
            dot.Spot = _probe.Spot;
            dot.RelativeRise = _probe.RelativeRise;
            dot.Peak = _probe.Peak;
            dot.Frames++;
        }

        private void Reduce(Image image, int first, int step)
        {
            fixed (byte* tiles = _tiles)
            fixed (uint* rows = _rows)
            {
                var work = new GreenTileBands
                {
                    Source = image,
                    First = first,
                    Step = step,
                    Count = (_tileRows - first + step - 1) / step,
                    BandCount = _kernels.BandCount,
                    UseVectors = _settings.UseVectors,
                    Tiles = tiles,
                    Rows = rows,
                };
                _kernels.Run(&work, work.BandCount);
            }
        }

        private void Search(Image image, int row)
        {
            double scale = Math.Max(0.25, _width / 1920.0);
            int above = (row >= Neighbor ? row - Neighbor : Math.Min(_tileRows - 1, row + Neighbor)) * _columns;
            int below = (row + Neighbor < _tileRows ? row + Neighbor : Math.Max(0, row - Neighbor)) * _columns;
            for (int column = 0; column < _columns && _count < Capacity && _examined < _settings.MaxCandidates; column++)
            {
                int i = row * _columns + column, floor = _tiles[i] - _settings.MinGreenExcess;
                int left = row * _columns + (column >= Neighbor ? column - Neighbor : Math.Min(_columns - 1, column + Neighbor));
                int right = row * _columns + (column + Neighbor < _columns ? column + Neighbor : Math.Max(0, column - Neighbor));
                if (floor < Math.Min(_tiles[above + column], _tiles[below + column]) || floor < Math.Min(_tiles[left], _tiles[right]))
                    continue;
                var middle = new Vector2D((column + 0.5) * TileKernel.Size - 0.5, (row + 0.5) * TileKernel.Size - 0.5);
                if (IsWatched(middle, scale, _count))
                    continue;
                _examined++;
                if (_probe.Look(image, middle, TileKernel.Size * (0.75 + scale)) != LightHue.Green || _probe.RelativeRise < _settings.MinRestingRise
                    || _probe.Spot.Elongation > _settings.MaxRestingElongation || IsWatched(_probe.Spot.PositionPx, scale, _count))
                    continue;
                var dot = default(RestingDot);
                Take(ref dot);
                _dots[_count++] = dot;
            }
        }

        private bool IsWatched(Vector2D at, double scale, int count)
        {
            for (int i = 0; i < count; i++)
            {
                if ((_dots[i].PositionPx - at).Length <= _settings.MatchRadiusPx * scale)
                    return true;
            }

            return false;
        }
    }
}
