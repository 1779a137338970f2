using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Finds small bright spots in a 16-bit infrared picture by their height over what lies around them: nothing need change, so
    /// lights that rest are found like any other. One pass makes tiles; exact work is done on the few that stand out.
    /// </summary>
    internal sealed unsafe class InfraredSpotFinder
    {
        private const int NoiseRowStep = 64;
        private const int MaxDifference = 4095;
        private const int Neighbor = 2;
        private const int WindowRadius = 12;
        private const double GateSigmas = 2.5;

        private readonly DualDetectorSettings _settings;
        private readonly KernelRunner _kernels;
        private readonly SpotWindow _window = new SpotWindow();
        private readonly int[] _differences = new int[MaxDifference + 1];
        private readonly Spot[] _spots;
        private readonly RejectedCandidate[] _verdicts;
        private ushort[] _tiles = Array.Empty<ushort>();
        private long[] _hot = Array.Empty<long>();

        public InfraredSpotFinder(DualDetectorSettings settings, KernelRunner kernels)
        {
            _kernels = kernels;
            _settings = settings;
            _spots = new Spot[settings.MaxCandidates];
            _verdicts = new RejectedCandidate[settings.MaxCandidates];
        }

        /// <summary>Spots examined in the last picture, brightest first.</summary>
        public ReadOnlySpan<Spot> Spots => new ReadOnlySpan<Spot>(_spots, 0, Count);

        /// <summary>For each of them why it is none, in infrared px; reason None: it is one.</summary>
        public ReadOnlySpan<RejectedCandidate> Verdicts => new ReadOnlySpan<RejectedCandidate>(_verdicts, 0, Count);

        public int Count { get; private set; }

        /// <summary>Bright places that there was no time to examine.</summary>
        public int SkippedCount { get; private set; }

        public void Find(Image infrared)
        {
            int columns = TileKernel.Count(infrared.Width), rows = TileKernel.Count(infrared.Height);
            if (_tiles.Length < columns * rows)
            {
                _tiles = new ushort[columns * rows];
                _hot = new long[columns * rows];
            }

            fixed (ushort* tiles = _tiles)
            {
                var work = new InfraredTileBands { Source = infrared, Tiles = tiles, UseVectors = _settings.UseVectors };
                _kernels.Run(&work, rows);
            }

            double noise = Noise(infrared);

            // Other tiles' brightest pixels lie two to three deviations over their mean already.
            int hot = FindHot(columns, rows, (int)Math.Min(65535, Math.Max(_settings.MinInfraredRise / 2, GateSigmas * noise)));
            Examine(infrared, columns, hot, noise);
        }

        /// <summary>One standard deviation: from the median difference of neighbours in a few rows, which edges hardly touch.</summary>
        private double Noise(Image infrared)
        {
            Array.Clear(_differences, 0, _differences.Length);
            int count = 0;
            for (int y = Math.Min(NoiseRowStep / 2, infrared.Height - 1); y < infrared.Height; y += NoiseRowStep)
            {
                ushort* row = (ushort*)(infrared.Pixels + (long)y * infrared.Stride);
                for (int x = 1; x < infrared.Width; x += 2, count++)
                    _differences[Math.Min(MaxDifference, Math.Abs(row[x] - row[x - 1]))]++;
            }

            int median = 0;
            for (int below = _differences[0]; 2 * below < count; below += _differences[++median])
            {
            }

            return median / 0.954;
        }

        /// <summary>Tiles brighter by a limit than one neighbour across and one up or down, two tiles off: a dot covers two at most.</summary>
        private int FindHot(int columns, int rows, int least)
        {
            int count = 0;
            for (int row = 0; row < rows; row++)
            {
                int above = (row >= Neighbor ? row - Neighbor : Math.Min(rows - 1, row + Neighbor)) * columns;
                int below = (row + Neighbor < rows ? row + Neighbor : Math.Max(0, row - Neighbor)) * columns;
                for (int column = 0; column < columns; column++)
                {
                    int i = row * columns + column, floor = _tiles[i] - least;
                    if (floor < Math.Min(_tiles[above + column], _tiles[below + column]))
                        continue;
                    int left = column >= Neighbor ? i - Neighbor : Math.Min(i + Neighbor, row * columns + columns - 1);
                    int right = column + Neighbor < columns ? i + Neighbor : Math.Max(i - Neighbor, row * columns);
                    if (floor >= Math.Min(_tiles[left], _tiles[right]))
                        _hot[count++] = i - ((long)_tiles[i] << 32);
                }
            }

            return count;
        }

        private void Examine(Image infrared, int columns, int hot, double noise)
        {
            Count = SkippedCount = 0;
            Array.Sort(_hot, 0, hot);
            for (int i = 0; i < hot; i++)
            {
                int tile = (int)(_hot[i] & 0xFFFFFFFF);
                if (!TryFindPeak(infrared, tile % columns * TileKernel.Size, tile / columns * TileKernel.Size, _tiles[tile], out int x, out int y) || !StandsOut(infrared, x, y, noise) || IsKnown(x, y))
                    continue;
                if (Count == _settings.MaxCandidates)
                {
                    SkippedCount += hot - i;
                    return;
                }

                _window.Place(x, y, WindowRadius, infrared.Width, infrared.Height);
                for (int wy = 0; wy < _window.Height; wy++)
                {
                    ushort* row = (ushort*)(infrared.Pixels + (long)(_window.Top + wy) * infrared.Stride) + _window.Left;
                    for (int wx = 0; wx < _window.Width; wx++)
                        _window.Light[wy * _window.Width + wx] = row[wx];
                }

                Spot spot = _window.Measure((y - _window.Top) * _window.Width + x - _window.Left);
                spot.Left += _window.Left;
                spot.Right += _window.Left;
                spot.Top += _window.Top;
                spot.Bottom += _window.Top;
                _spots[Count] = spot;
                _verdicts[Count++] = Judge(spot, noise);
            }
        }

        /// <summary>The first pixel as bright as the tile's brightest; false when it only lies on the slope of a peak in another tile.</summary>
        private static bool TryFindPeak(Image infrared, int left, int top, ushort peak, out int x, out int y)
        {
            y = top;
            int width = Math.Min(infrared.Width - left, TileKernel.Size), offset;
            while ((offset = new ReadOnlySpan<ushort>((ushort*)(infrared.Pixels + (long)y * infrared.Stride) + left, width).IndexOf(peak)) < 0)
                y++;
            x = left + offset;

            for (int py = Math.Max(0, y - 1); py <= Math.Min(infrared.Height - 1, y + 1); py++)
            {
                for (int px = Math.Max(0, x - 1); px <= Math.Min(infrared.Width - 1, x + 1); px++)
                {
                    if (At(infrared, px, py) > peak)
                        return false;
                }
            }

            return true;
        }

        /// <summary>The test of the inner pixels' light, roughly and at once: what noise makes here and there is no candidate.</summary>
        private bool StandsOut(Image infrared, int x, int y, double noise)
        {
            int near = 0, around = 0;
            for (int dy = -1; dy <= 1; dy++)
            {
                for (int dx = -1; dx <= 1; dx++)
                {
                    near += AtEdge(infrared, x + dx, y + dy);
                    around += dx == 0 && dy == 0 ? 0 : AtEdge(infrared, x + 5 * dx, y + 5 * dy);
                }
            }

            return near - 9 * around / 8.0 >= 0.8 * 3 * _settings.MinInfraredSigmas * noise;
        }

        private static int AtEdge(Image infrared, int x, int y) =>
            At(infrared, Math.Max(0, Math.Min(infrared.Width - 1, x)), Math.Max(0, Math.Min(infrared.Height - 1, y)));

        private static int At(Image infrared, int x, int y) => ((ushort*)(infrared.Pixels + (long)y * infrared.Stride))[x];

        private bool IsKnown(int x, int y)
        {
            for (int i = 0; i < Count; i++)
            {
                if (x >= _spots[i].Left - 2 && x <= _spots[i].Right + 2 && y >= _spots[i].Top - 2 && y <= _spots[i].Bottom + 2)
                    return true;
            }

            return false;
        }

        private RejectedCandidate Judge(in Spot spot, double noise)
        {
            double least = Math.Max(_settings.MinInfraredRise, Math.Max(_settings.MinInfraredContrast * spot.Sigma, _settings.MinInfraredShare * spot.Background));
            if (spot.Rise < least)
                return Reject(spot, RejectionReason.TooFaint, spot.Rise, least);
            if (spot.CoreLight < 3 * _settings.MinInfraredSigmas * noise)
                return Reject(spot, RejectionReason.TooFaint, spot.CoreLight, 3 * _settings.MinInfraredSigmas * noise);
            if (spot.Foot < _settings.MinInfraredFootPx)
                return Reject(spot, RejectionReason.TooSmall, spot.Foot, _settings.MinInfraredFootPx);
            if (spot.IsCut || spot.Area > _settings.MaxInfraredAreaPx)
                return Reject(spot, RejectionReason.TooLarge, spot.Area, _settings.MaxInfraredAreaPx);
            if (spot.Elongation > _settings.MaxElongation)
                return Reject(spot, RejectionReason.TooElongated, spot.Elongation, _settings.MaxElongation);
            return spot.RingShare > _settings.MaxRingShare
                ? Reject(spot, RejectionReason.NotIsolated, spot.RingShare, _settings.MaxRingShare)
                : default;
        }

        private static RejectedCandidate Reject(in Spot spot, RejectionReason reason, double value, double limit) =>
            new RejectedCandidate { PositionPx = spot.PositionPx, Reason = reason, Value = value, Limit = limit };
    }
}
