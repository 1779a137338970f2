using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// Finds saddle points of the brightness: peaks of minus the Hessian's determinant, placed where the smoothed picture is level,
    /// and kept when a ring around them alternates twice and half a turn leaves it as it was. Works on one scale: squares of 11 px and
    /// more, blur up to a third of a square. Not thread-safe; allocates nothing once warm.
    /// </summary>
    public sealed unsafe class SaddlePointFinder
    {
        /// <summary>Points kept at most; the strongest responses go first where there are more.</summary>
        public const int MaximumPoints = 4096;

        private const int PeakReach = 2;
        private const int LeastResponse = 24;
        private const double LeastContrast = 5;
        private const double LeastQuality = 0.7;
        private const int MaximumCandidates = 30_000;

        private readonly SaddleRing _ring = new SaddleRing();
        private readonly SaddlePoint[] _points = new SaddlePoint[MaximumPoints];
        private ushort[] _smooth = Array.Empty<ushort>();
        private ushort[] _along = Array.Empty<ushort>();
        private int[] _response = Array.Empty<int>();
        private int[] _peaks = new int[1024];
        private int[] _strengths = new int[1024];
        private byte[] _padded = Array.Empty<byte>();
        private int _width, _height, _peakCount, _count;

        /// <summary>What the last search found, strongest response first; valid until the next search.</summary>
        public ReadOnlySpan<SaddlePoint> Points => new ReadOnlySpan<SaddlePoint>(_points, 0, _count);

        /// <summary>Searches a <see cref="PixelFormat.Gray8"/> picture of any size. Points less than 7 px from its border are not found.</summary>
        /// <exception cref="ArgumentException">Another format.</exception>
        public ReadOnlySpan<SaddlePoint> Find(Image gray)
        {
            if (gray.Format != PixelFormat.Gray8)
                throw new ArgumentException($"a picture of format {gray.Format} is not grey", nameof(gray));
            _width = gray.Width;
            _height = gray.Height;
            _count = _peakCount = 0;
            if (_width <= 2 * SaddleRing.Margin || _height <= 2 * SaddleRing.Margin)
                return Points;
            MakeRoom();
            Smooth(gray);
            FindPeaks();
            Array.Sort(_strengths, _peaks, 0, _peakCount);
            fixed (ushort* smooth = _smooth)
            {
                _ring.Use(smooth, _width, _height);
                for (int i = 0; i < _peakCount && _count < MaximumPoints; i++)
                {
                    int x = _peaks[i] % _width, y = _peaks[i] / _width;
                    if (_ring.TrySettle(new Vector2D(x, y), 1.5, out Vector2D at)
                        && _ring.TryMeasure(at, out SaddlePoint point)
                        && point.Contrast >= LeastContrast && point.Quality >= LeastQuality)
                        _points[_count++] = point;
                }
            }

            return Points;
        }

        /// <summary>
        /// Looks for a saddle point of any contrast near a place of the picture searched last, where there is reason to expect one.
        /// </summary>
        /// <param name="expectedPx">Where to start.</param>
        /// <param name="reachPx">How far off it may be.</param>
        /// <param name="point">Its contrast and quality are for the caller to judge.</param>
        public bool TryFindNear(Vector2D expectedPx, double reachPx, out SaddlePoint point)
        {
            point = default;
            if (_width <= 2 * SaddleRing.Margin || _height <= 2 * SaddleRing.Margin)
                return false;
            fixed (ushort* smooth = _smooth)
            {
                _ring.Use(smooth, _width, _height);
                return _ring.TrySettle(expectedPx, reachPx, out Vector2D at) && _ring.TryMeasure(at, out point);
            }
        }

        private void MakeRoom()
        {
            int pixels = _width * _height;
            if (_smooth.Length < pixels)
                _smooth = new ushort[pixels];
            if (_along.Length < 9 * _width)
            {
                _along = new ushort[9 * _width];
                _response = new int[5 * _width];
                _padded = new byte[_width + 2 * SaddleKernel.Reach];
            }
        }

        private void Smooth(Image gray)
        {
            const int Reach = SaddleKernel.Reach, Rows = 2 * Reach + 1;
            fixed (byte* padded = _padded)
            fixed (ushort* along = _along, smooth = _smooth)
            {
                ushort** rows = stackalloc ushort*[Rows];
                int next = 0;
                for (int y = 0; y < _height; y++)
                {
                    for (; next < Math.Min(_height, y + Reach + 1); next++)
                    {
                        var row = new Span<byte>(gray.Pixels + (long)next * gray.Stride, _width);
                        new Span<byte>(padded, Reach).Fill(row[0]);
                        row.CopyTo(new Span<byte>(padded + Reach, _width));
                        new Span<byte>(padded + Reach + _width, Reach).Fill(row[_width - 1]);
                        SaddleKernel.SmoothAlong(padded, _width, along + next % Rows * _width);
                    }

                    for (int i = 0; i < Rows; i++)
                        rows[i] = along + Math.Max(0, Math.Min(_height - 1, y + i - Reach)) % Rows * _width;
                    SaddleKernel.SmoothAcross(rows, _width, smooth + y * _width);
                }
            }
        }

        private void FindPeaks()
        {
            const int Rows = 2 * PeakReach + 1;
            fixed (ushort* smooth = _smooth)
            fixed (int* response = _response)
            {
                int** rows = stackalloc int*[Rows];
                int next = SaddleRing.Margin - PeakReach;
                for (int y = SaddleRing.Margin; y < _height - SaddleRing.Margin; y++)
                {
                    for (; next <= y + PeakReach; next++)
                    {
                        ushort* row = smooth + next * _width;
                        SaddleKernel.Respond(row - _width, row, row + _width, _width, response + next % Rows * _width);
                    }

                    for (int i = 0; i < Rows; i++)
                        rows[i] = response + (y + i - PeakReach) % Rows * _width;
                    FindPeaks(rows, y);
                }
            }
        }

        private void FindPeaks(int** rows, int y)
        {
            int* middle = rows[PeakReach];
            for (int x = SaddleRing.Margin; x < _width - SaddleRing.Margin; x++)
            {
                int value = middle[x];
                if (value < LeastResponse || value < middle[x - 1] || value <= middle[x + 1] || !IsPeak(rows, x, value))
                    continue;
                if (_peakCount == MaximumCandidates)
                    return;
                if (_peakCount == _peaks.Length)
                {
                    Array.Resize(ref _peaks, 2 * _peakCount);
                    Array.Resize(ref _strengths, 2 * _peakCount);
                }

                _peaks[_peakCount] = y * _width + x;
                _strengths[_peakCount++] = -value;
            }
        }

        /// <summary>No other value within reach is larger; of equal ones the last in reading order counts.</summary>
        private static bool IsPeak(int** rows, int x, int value)
        {
            for (int i = 0; i < 2 * PeakReach + 1; i++)
            {
                int* row = rows[i] + x;
                for (int dx = -PeakReach; dx <= PeakReach; dx++)
                {
                    bool isLater = i > PeakReach || (i == PeakReach && dx > 0);
                    if (row[dx] > value || (isLater && row[dx] == value))
                        return false;
                }
            }

            return true;
        }
    }
}
