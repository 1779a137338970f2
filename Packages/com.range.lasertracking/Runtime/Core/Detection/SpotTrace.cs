using System;
using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>
    /// What <see cref="ShotDetector"/> saw at one place in its last frame, candidate or not: the searched pictures around it, the
    /// remembered brightness, the rise, the tile's gate. Hang it on <see cref="DetectionTrace.Spot"/>. Allocates nothing once
    /// constructed; same thread as the detector.
    /// </summary>
    public sealed unsafe class SpotTrace
    {
        /// <summary>The highest rise is looked for within this many searched pixels of the spot.</summary>
        public const int PeakReach = 4;

        private readonly uint[] _now;
        private readonly uint[] _before;
        private readonly byte[][] _envelopes;
        private readonly byte[][] _rises;
        private SpotPlane _smallest;
        private SpotPlane _largest;

        /// <param name="atPx">The spot in pixels of the whole picture.</param>
        /// <param name="radius">Searched pixels kept to each side, 4…512.</param>
        /// <exception cref="ArgumentException">The spot is no point, or the radius is outside its range.</exception>
        public SpotTrace(Vector2D atPx, int radius = 20)
        {
            SettingCheck.InRange(nameof(radius), radius, 4, 512);
            SettingCheck.InRange("x", atPx.X, 0, 1 << 20);
            SettingCheck.InRange("y", atPx.Y, 0, 1 << 20);
            AtPx = atPx;
            Radius = radius;
            _now = new uint[Side * Side];
            _before = new uint[Side * Side];
            _envelopes = new[] { new byte[Side * Side], new byte[Side * Side] };
            _rises = new[] { new byte[Side * Side], new byte[Side * Side] };
        }

        public Vector2D AtPx { get; }

        public int Radius { get; }

        /// <summary>Searched pixels along a side of what is kept; outside the picture they are 0.</summary>
        public int Side => 2 * Radius + 1;

        /// <summary>False while the detector still learns the picture: nothing was searched, and nothing here means anything.</summary>
        public bool IsSearched { get; private set; }

        /// <summary>Pixels of the whole picture per searched pixel along a side.</summary>
        public int Factor { get; private set; } = 1;

        /// <summary>The light of a dot found in this frame covers the spot: nothing further is looked for there.</summary>
        public bool IsLit { get; private set; }

        /// <summary>Brightness from which light is more than the projected picture can be; 256 where brightness proves nothing.</summary>
        public int ContentLimit { get; private set; } = 256;

        public SpotPlane Smallest => _smallest;

        public SpotPlane Largest => _largest;

        /// <summary>The searched picture of this frame, Side × Side pixels, blue in the lowest byte.</summary>
        public ReadOnlySpan<uint> Now => _now;

        /// <summary>The same of the frame before.</summary>
        public ReadOnlySpan<uint> Before => _before;

        /// <summary>Brightness that each pixel's own past explains, 0…255.</summary>
        public ReadOnlySpan<byte> Envelope(bool ofSmallestChannel) => _envelopes[ofSmallestChannel ? 0 : 1];

        /// <summary>Rise as a share of the room left, 0…255.</summary>
        public ReadOnlySpan<byte> Rise(bool ofSmallestChannel) => _rises[ofSmallestChannel ? 0 : 1];

        internal void Begin()
        {
            IsSearched = IsLit = false;
            ContentLimit = 256;
            _smallest = _largest = default;
        }

        /// <summary>Keeps what the plane's tile at the spot let through.</summary>
        internal void SetTile(DetectionPlane plane, TileGrid tiles, ReadOnlySpan<int> examined, int floor, int factor)
        {
            int column = (int)(AtPx.X + 0.5) / factor / TileGrid.Size, row = (int)(AtPx.Y + 0.5) / factor / TileGrid.Size;
            if (column >= tiles.Columns || row >= tiles.Rows)
                return;
            int tile = row * tiles.Columns + column;
            ref SpotPlane of = ref plane == DetectionPlane.Smallest ? ref _smallest : ref _largest;
            of.TileOnset = tiles.Onset(tile);
            of.TileGate = tiles.Gate(tile, floor);
            of.TileActivity = tiles.Activity(tile);
            of.HotTiles = tiles.HotCount;
            of.IsTileExamined = examined.IndexOf(tile) >= 0;
        }

        /// <summary>Keeps the pictures around the spot, before the detector turns to the next frame.</summary>
        internal void Look(in FrameView view, int factor, int contentLimit, DotMemory memory)
        {
            int centerX = (int)(AtPx.X + 0.5) / factor, centerY = (int)(AtPx.Y + 0.5) / factor;
            Factor = factor;
            ContentLimit = contentLimit;
            IsLit = memory.IsLit(centerX, centerY);
            IsSearched = true;
            for (int i = 0; i < _now.Length; i++)
            {
                int x = centerX - Radius + i % Side, y = centerY - Radius + i / Side;
                bool isInside = x >= 0 && y >= 0 && x < view.Width && y < view.Height;
                int at = isInside ? y * view.Width + x : 0;
                _now[i] = isInside ? view.Now[at] : 0;
                _before[i] = isInside ? view.Before[at] : 0;
                for (int p = 0; p < 2; p++)
                {
                    _envelopes[p][i] = isInside ? (byte)view.Envelope(at, (DetectionPlane)p) : (byte)0;
                    _rises[p][i] = isInside ? (byte)view.RelativeRise(at, (DetectionPlane)p) : (byte)0;
                }
            }

            FindPeak(view, DetectionPlane.Smallest, centerX, centerY, ref _smallest);
            FindPeak(view, DetectionPlane.Largest, centerX, centerY, ref _largest);
        }

        private void FindPeak(in FrameView view, DetectionPlane plane, int centerX, int centerY, ref SpotPlane of)
        {
            int best = -1;
            for (int y = Math.Max(0, centerY - PeakReach); y <= Math.Min(view.Height - 1, centerY + PeakReach); y++)
            {
                for (int x = Math.Max(0, centerX - PeakReach); x <= Math.Min(view.Width - 1, centerX + PeakReach); x++)
                {
                    int i = y * view.Width + x, rise = view.RelativeRise(i, plane);
                    if (rise <= best)
                        continue;
                    best = rise;
                    of.PeakPx = new Vector2D(x * Factor + (Factor - 1) * 0.5, y * Factor + (Factor - 1) * 0.5);
                    of.Level = FrameView.Level(view.Now[i], plane);
                    of.Envelope = view.Envelope(i, plane);
                    of.Rise = rise / 255.0;
                }
            }
        }
    }
}
