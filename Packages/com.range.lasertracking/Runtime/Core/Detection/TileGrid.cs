using System;

namespace LaserTracking.Detection
{
    /// <summary>
    /// The largest onset of each tile of 16×16 working pixels, and how large it has been of late: a region that keeps moving raises
    /// its own threshold and nobody else's. Picks the tiles worth exact work, the most surprising ones when there are too many.
    /// </summary>
    internal sealed partial class TileGrid
    {
        public const int Size = 16;
        private const float Follow = 0.25f;

        /// <summary>Share of its activity that a tile's onset must exceed.</summary>
        public const float GateShare = 0.9f;

        private readonly int[] _histogram = new int[256];
        private byte[] _onsets = Array.Empty<byte>();
        private float[] _activity = Array.Empty<float>();
        private bool[] _isExempt = Array.Empty<bool>();
        private int[] _hot = Array.Empty<int>();

        public int Columns { get; private set; }

        public int Rows { get; private set; }

        /// <summary>Tiles above their threshold in this frame, also those beyond the limit.</summary>
        public int HotCount { get; private set; }

        /// <summary>The tile's largest onset in this frame, levels.</summary>
        public int Onset(int tile) => _onsets[tile];

        public double Activity(int tile) => _activity[tile];

        /// <summary>The largest activity of a tile and the eight around it: how much has moved nearby.</summary>
        public double ActivityAround(int tile)
        {
            float largest = 0;
            int column = tile % Columns, row = tile / Columns;
            for (int y = Math.Max(0, row - 1); y <= Math.Min(Rows - 1, row + 1); y++)
            {
                for (int x = Math.Max(0, column - 1); x <= Math.Min(Columns - 1, column + 1); x++)
                    largest = Math.Max(largest, _activity[y * Columns + x]);
            }

            return largest;
        }

        public void Resize(int width, int height)
        {
            Columns = Count(width);
            Rows = Count(height);
            _onsets = new byte[Columns * Rows];
            _activity = new float[Columns * Rows];
            _isExempt = new bool[Columns * Rows];
            _hot = new int[Columns * Rows];
        }

        /// <summary>Where <see cref="ReduceRow"/> puts each frame's onsets, in reading order.</summary>
        public byte[] Onsets => _onsets;

        public static int Count(int length) => (length + Size - 1) / Size;

        /// <summary>Reduces column maxima to the onsets of one row of tiles.</summary>
        public static unsafe void ReduceRow(byte* columns, int width, byte* onsets)
        {
            int t = 0;
#if NET8_0_OR_GREATER
            t = ReduceRowVector(columns, width, onsets);
#endif
            for (; t < Count(width); t++)
            {
                int end = (t + 1) * Size < width ? (t + 1) * Size : width;
                byte largest = 0;
                for (int x = t * Size; x < end; x++)
                {
                    if (columns[x] > largest)
                        largest = columns[x];
                }

                onsets[t] = largest;
            }
        }

        /// <summary>Tiles to look into, in reading order; at most limit of them. The caller's until the next call.</summary>
        public Span<int> FindHot(int floor, int limit)
        {
            Array.Clear(_histogram, 0, 256);
            HotCount = 0;
            for (int i = 0; i < _onsets.Length; i++)
            {
                int surprise = Surprise(i, floor);
                if (surprise <= 0)
                    continue;
                _histogram[surprise]++;
                HotCount++;
            }

            int cut = 1;
            if (HotCount > limit)
            {
                int above = 0;
                for (cut = 255; cut > 0 && above + _histogram[cut] <= limit; cut--)
                    above += _histogram[cut];
                cut = Math.Min(255, cut + 1);
            }

            int count = 0;
            for (int i = 0; i < _onsets.Length && count < limit; i++)
            {
                if (_onsets[i] > 0 && Surprise(i, floor) >= cut)
                    _hot[count++] = i;
            }

            return new Span<int>(_hot, 0, count);
        }

        /// <summary>Those of some tiles that have an onset so large, moved to the front.</summary>
        public Span<int> Reaching(int least, Span<int> tiles)
        {
            int count = 0;
            foreach (int tile in tiles)
            {
                if (_onsets[tile] >= least)
                    tiles[count++] = tile;
            }

            return tiles.Slice(0, count);
        }

        /// <summary>A dot's own light must not raise the threshold under it.</summary>
        public void Exempt(int left, int top, int right, int bottom)
        {
            for (int y = Math.Max(0, top / Size); y <= Math.Min(Rows - 1, bottom / Size); y++)
            {
                for (int x = Math.Max(0, left / Size); x <= Math.Min(Columns - 1, right / Size); x++)
                    _isExempt[y * Columns + x] = true;
            }
        }

        /// <summary>Whether a dot was found in the tile in this frame; asked once a frame by who does not let the activity follow.</summary>
        public bool TakeExempt(int tile)
        {
            bool isExempt = _isExempt[tile];
            _isExempt[tile] = false;
            return isExempt;
        }

        /// <summary>Takes this frame's onsets for the ordinary, but for those of dots: the first look at what the picture does by itself.</summary>
        public void LearnAtOnce()
        {
            for (int i = 0; i < _onsets.Length; i++)
            {
                _activity[i] = _isExempt[i] ? 0 : _onsets[i];
                _isExempt[i] = false;
            }
        }

        /// <summary>Lets the activity follow this frame's onsets.</summary>
        public void Learn()
        {
            for (int i = 0; i < _onsets.Length; i++)
            {
                if (!_isExempt[i])
                    _activity[i] += Follow * (_onsets[i] - _activity[i]);
                _isExempt[i] = false;
            }
        }

        /// <summary>What the tile's onset must exceed to be hot, levels.</summary>
        public int Gate(int tile, int floor) => floor + (int)(GateShare * _activity[tile]);

        private int Surprise(int i, int floor) => _onsets[i] - Gate(i, floor);
    }
}
