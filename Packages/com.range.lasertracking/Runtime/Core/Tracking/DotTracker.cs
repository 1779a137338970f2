using System;
using LaserTracking.Geometry;

namespace LaserTracking.Tracking
{
    /// <summary>
    /// Follows the dots of several lasers that all look alike: small, fast, trembling, now and then hidden. Each dot has a smooth way
    /// with tremor about it; dots go to ways by likelihood, all at once. A way that is lost is taken up again by a new dot whose place and
    /// velocity both fit. One thread at a time; allocates nothing once constructed; work per frame is bounded.
    /// </summary>
    public sealed class DotTracker
    {
        /// <summary>Further dots of a frame get no number.</summary>
        public const int MaxDots = 128;

        private const int MaxPaths = 256;
        private const double SettingsWidthPx = 640;

        /// <summary>No frame comes sooner after another as far as motion goes; clocks that stand still or run back count so.</summary>
        private const long LeastStepUs = 1000;

        /// <summary>
        /// What stray light costs: it comes once in ten frames anywhere on the picture, 2 ln (640 × 360 / 0.1) − 2 ln 2π = 26. Less,
        /// so that a dot that turns more sharply than any hand begins anew.
        /// </summary>
        private const double StrayCost = 20;

        /// <summary>
        /// What a new laser costs: it appears anywhere with any velocity of the first kind, 2 ln (640 × 360 × 2π × 250²) − 4 ln 2π = 43, and
        /// for one that appears four hundred come back (12).
        /// </summary>
        private const double NewCost = 55;

        private const int MemoryPerFollowed = 3;
        private const long SlowestFrameUs = 200_000;

        private readonly DotTrackerSettings _settings;
        private readonly HungarianAssignment _assignment = new HungarianAssignment(MaxPaths);
        private readonly DotPath[] _paths = new DotPath[MaxPaths];
        private readonly Vector2D[] _dots = new Vector2D[MaxDots];
        private readonly int[] _pathOfDot = new int[MaxDots];
        private readonly int[] _rows = new int[MaxPaths];
        private readonly int[] _columns = new int[MaxPaths];
        private readonly int[] _columnOfRow = new int[MaxPaths];
        private readonly double[] _costs = new double[MaxPaths * MaxPaths];
        private int _dotCount;
        private int _pathCount;
        private int _lastId;
        private long _clockUs;
        private long _frameUs;
        private long _previousTimeUs;
        private bool _isBegun;

        /// <param name="settings">Defaults when absent. Copied.</param>
        /// <exception cref="ArgumentException">A setting is outside its range.</exception>
        public DotTracker(DotTrackerSettings? settings = null)
        {
            _settings = settings?.Clone() ?? new DotTrackerSettings();
            _settings.Validate();
        }

        /// <summary>Dots of the last call beyond <see cref="MaxDots"/>, and those that could not be followed because too many were.</summary>
        public int IgnoredDots { get; private set; }

        /// <summary>Forgets everything and starts to count from 1 again.</summary>
        public void Reset()
        {
            _pathCount = _dotCount = _lastId = IgnoredDots = 0;
            _clockUs = 0;
            _isBegun = false;
        }

        /// <summary>Takes the dots of the next frame; also the frames without any should be given.</summary>
        /// <param name="timeUs">Mid-exposure.</param>
        /// <param name="positionsPx">In pixels of the picture; those that are not finite get no number.</param>
        /// <param name="imageWidthPx">Width of the picture, above 0.</param>
        /// <param name="ids">As long as the positions: each dot's number, counting from 1; 0: none (yet).</param>
        public void Process(long timeUs, ReadOnlySpan<Vector2D> positionsPx, double imageWidthPx, Span<int> ids)
        {
            Take(positionsPx, SettingsWidthPx / imageWidthPx);
            Step(timeUs);
            Link(isNumbered: true, isJump: false);
            Link(isNumbered: false, isJump: false);
            if (_settings.JumpRadiusPx > 0)
                Link(isNumbered: true, isJump: true);
            Begin();
            Return();
            ids.Slice(0, positionsPx.Length).Clear();
            for (int d = 0; d < _dotCount; d++)
                ids[d] = _pathOfDot[d] < 0 ? 0 : _paths[_pathOfDot[d]].Id;
        }

        private void Take(ReadOnlySpan<Vector2D> positionsPx, double scale)
        {
            _dotCount = Math.Min(positionsPx.Length, MaxDots);
            IgnoredDots = positionsPx.Length - _dotCount;
            for (int d = 0; d < _dotCount; d++)
            {
                _dots[d] = positionsPx[d] * scale;
                _pathOfDot[d] = -1;
            }
        }

        private void Step(long timeUs)
        {
            long stepUs = _isBegun ? Math.Clamp(timeUs - _previousTimeUs, LeastStepUs, _settings.MemoryUs + LeastStepUs) : LeastStepUs;
            _isBegun = true;
            _previousTimeUs = timeUs;
            _clockUs += stepUs;
            _frameUs = Math.Min(stepUs, SlowestFrameUs);
            int kept = 0;
            for (int i = 0; i < _pathCount; i++)
            {
                if (_clockUs - _paths[i].LastUs > MemoryUs(_paths[i]))
                    continue;
                _paths[i].Predict(stepUs * 1e-6, _settings.SpeedWanderPxPerS);
                _paths[kept++] = _paths[i];
            }

            _pathCount = kept;
        }

        /// <summary>
        /// What has been seen too rarely must not be continued by the next stray light, and where a dot went of which only a flash was seen
        /// nobody knows: no dot is remembered for much longer than it was followed.
        /// </summary>
        private long MemoryUs(in DotPath path) =>
            path.Id == 0 ? Math.Max(_settings.LinkUs / 2, _frameUs) : Math.Min(_settings.MemoryUs, LinkUs + MemoryPerFollowed * (path.LastUs - path.FirstUs));

        /// <summary>However slow the frames, the next one may continue what the last one showed.</summary>
        private long LinkUs => Math.Max(_settings.LinkUs, _frameUs);

        /// <summary>
        /// Dots continue the ways that were seen just now; ways with a number have the first choice. A jump breaks with the way and
        /// begins another under the same number.
        /// </summary>
        private void Link(bool isNumbered, bool isJump)
        {
            int rows = 0, columns = 0;
            for (int i = 0; i < _pathCount; i++)
            {
                if (_paths[i].Id > 0 == isNumbered && _paths[i].LastUs < _clockUs && _clockUs - _paths[i].LastUs <= LinkUs)
                    _rows[rows++] = i;
            }

            for (int d = 0; d < _dotCount; d++)
            {
                if (_pathOfDot[d] < 0 && _dots[d].IsFinite)
                    _columns[columns++] = d;
            }

            double radius = isJump ? _settings.JumpRadiusPx : _settings.LinkRadiusPx;
            for (int r = 0; r < rows; r++)
            {
                ref DotPath path = ref _paths[_rows[r]];
                for (int c = 0; c < columns; c++)
                {
                    Vector2D dot = _dots[_columns[c]];
                    double jump = Math.Min(0, (dot - path.PlacePx).LengthSquared - radius * radius);
                    _costs[r * columns + c] = isJump || jump == 0 ? jump : Cost(path.DistanceSquared(dot, _settings.TremorPx, out double spread), spread, StrayCost);
                }
            }

            Solve(rows, columns);
            for (int r = 0; r < rows; r++)
            {
                int c = _columnOfRow[r];
                if (c < 0 || _costs[r * columns + c] >= 0)
                    continue;
                if (isJump)
                    _paths[_rows[r]].Restart(_dots[_columns[c]], _clockUs, _settings);
                else
                    _paths[_rows[r]].Update(_dots[_columns[c]], _clockUs, _settings.TremorPx);
                _pathOfDot[_columns[c]] = _rows[r];
            }
        }

        /// <summary>
        /// A pair against its two staying apart: twice the negative logarithm of how much likelier it is. Staying apart costs nothing, and
        /// what is no pair no more than that.
        /// </summary>
        private static double Cost(double distanceSquared, double spread, double bound) => Math.Min(0, distanceSquared + spread - bound);

        private void Solve(int rows, int columns) =>
            _assignment.Solve(new ReadOnlySpan<double>(_costs, 0, rows * columns), rows, columns, _columnOfRow);

        private void Begin()
        {
            for (int d = 0; d < _dotCount; d++)
            {
                if (_pathOfDot[d] >= 0 || !_dots[d].IsFinite)
                    continue;
                if (_pathCount == MaxPaths)
                {
                    IgnoredDots++;
                    continue;
                }

                _pathOfDot[d] = _pathCount;
                _paths[_pathCount++] = new DotPath(_dots[d], _clockUs, _settings);
            }
        }

        /// <summary>Ways seen often enough get the number of a lost way that they carry on, or a new one.</summary>
        private void Return()
        {
            int rows = 0, columns = 0;
            for (int i = 0; i < _pathCount; i++)
            {
                if (_paths[i].Id == 0 && _paths[i].LastUs == _clockUs && _paths[i].Hits >= _settings.MinHits)
                    _rows[rows++] = i;
                else if (_paths[i].Id > 0 && _paths[i].LastUs < _clockUs)
                    _columns[columns++] = i;
            }

            if (rows == 0)
                return;
            for (int r = 0; r < rows; r++)
            {
                for (int c = 0; c < columns; c++)
                {
                    ref DotPath found = ref _paths[_rows[r]], lost = ref _paths[_columns[c]];
                    _costs[r * columns + c] = found.FirstUs > lost.LastUs ? Cost(found.DistanceSquared(lost, out double spread), spread, NewCost) : 0;
                }
            }

            Solve(rows, columns);
            for (int r = 0; r < rows; r++)
            {
                ref DotPath found = ref _paths[_rows[r]];
                int c = _columnOfRow[r];
                if (c < 0 || _costs[r * columns + c] >= 0)
                {
                    found.Id = ++_lastId;
                    continue;
                }

                // The old way is now this one; without a number it is forgotten with the next frame.
                ref DotPath lost = ref _paths[_columns[c]];
                found.Id = lost.Id;
                found.FirstUs = lost.FirstUs;
                lost.Id = 0;
                lost.LastUs = long.MinValue / 2;
            }
        }
    }
}
