using System;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>Finds in a tile the pixel from which a candidate grows: what no other candidate and no dot of this frame has taken.</summary>
    internal sealed unsafe class SeedFinder
    {
        private readonly KernelRunner _kernels;
        private readonly byte[] _rises;
        private readonly byte[] _peaks;
        private readonly BlobMeasurer _blobs;
        private readonly DotMemory _memory;

        /// <param name="maxTiles">Tiles of which the rises are kept at a time.</param>
        /// <param name="blobs">Says what this plane's candidates have taken.</param>
        /// <param name="memory">Says where this frame's dots shine.</param>
        /// <param name="kernels">Runs the loop over the tiles.</param>
        public SeedFinder(int maxTiles, BlobMeasurer blobs, DotMemory memory, KernelRunner kernels)
        {
            _kernels = kernels;
            _rises = new byte[maxTiles * TileGrid.Size * TileGrid.Size];
            _peaks = new byte[maxTiles * TileGrid.Size];
            _blobs = blobs;
            _memory = memory;
        }

        /// <summary>Keeps the tiles' relative rises, each in the slot of its place in the list: both rounds look for their highest.</summary>
        public void Fill(in FrameView view, DetectionPlane plane, int tileColumns, ReadOnlySpan<int> tiles)
        {
            fixed (int* list = tiles)
            fixed (byte* rises = _rises, peaks = _peaks)
            {
                var work = new RiseBands { View = view, Plane = plane, TileColumns = tileColumns, Tiles = list, Rises = rises, Peaks = peaks };
                _kernels.Run(&work, tiles.Length);
            }
        }

        /// <summary>The highest relative rise in the tile that no candidate of this plane, and no dot found already, has taken.</summary>
        public bool TryFind(in FrameView view, DetectionPlane plane, int tileX, int tileY, int slot, out Candidate candidate)
        {
            int best = 0, bestX = -1, bestY = -1;
            int x0 = tileX * TileGrid.Size, x1 = Math.Min(view.Width, x0 + TileGrid.Size);
            int y0 = tileY * TileGrid.Size, y1 = Math.Min(view.Height, y0 + TileGrid.Size);
            for (int y = y0; y < y1; y++)
            {
                int slotRow = slot * TileGrid.Size + y - y0;
                if (_peaks[slotRow] <= best)
                    continue;
                ReadOnlySpan<byte> rises = _rises.AsSpan(slotRow * TileGrid.Size, x1 - x0);
                for (int x = x0; x < x1; x++)
                {
                    int rise = rises[x - x0];
                    if (rise <= best || _blobs.IsTaken(y * view.Width + x) || _memory.IsLit(x, y))
                        continue;
                    best = rise;
                    bestX = x;
                    bestY = y;
                }
            }

            candidate = new Candidate { Plane = plane, SeedX = bestX, SeedY = bestY, PeakRelativeRise = best };
            if (bestX < 0)
                return false;
            candidate.PeakRise = view.Rise(bestY * view.Width + bestX, plane);
            return true;
        }

        /// <summary>The tile's brightest pixel above the limit; of equally bright ones that which rose most.</summary>
        public bool TryFindExcess(in FrameView view, int tileX, int tileY, int limit, out Candidate candidate)
        {
            int best = 0, bestX = -1, bestY = -1;
            int x0 = tileX * TileGrid.Size, y0 = tileY * TileGrid.Size;
            int x1 = Math.Min(view.Width, x0 + TileGrid.Size), y1 = Math.Min(view.Height, y0 + TileGrid.Size);
            for (int y = y0; y < y1; y++)
            {
                for (int x = x0; x < x1; x++)
                {
                    // The new envelope is never below the level itself, and one byte.
                    int i = y * view.Width + x;
                    if (view.NewLargest[i] < limit)
                        continue;
                    int level = FrameView.Level(view.Now[i], DetectionPlane.Largest);
                    int rise = level - view.OldLargest[i];
                    if (level < limit || rise <= 0 || (level << 8 | rise) <= best || _blobs.IsTaken(i) || _memory.IsLit(x, y))
                        continue;
                    best = level << 8 | rise;
                    bestX = x;
                    bestY = y;
                }
            }

            candidate = new Candidate { Plane = DetectionPlane.Largest, SeedX = bestX, SeedY = bestY, PeakRise = best & 255 };
            if (bestX < 0)
                return false;
            candidate.PeakRelativeRise = view.RelativeRise(bestY * view.Width + bestX, DetectionPlane.Largest);
            return true;
        }
    }
}
