using System;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Where the expected view has been wrong of late: how often each tile was brighter than expected without a dot in it. People before
    /// the screen carry the projected picture displaced; what exceeds the expected view there says nothing.
    /// </summary>
    internal sealed class UnexplainedTiles
    {
        /// <summary>From this share on, unexpected light is what is usual there.</summary>
        public const double MaxShare = 0.1;

        /// <summary>Each frame's weight: a second or two of memory, and no fewer than four frames make a tile doubtful.</summary>
        private const float Follow = 0.03f;

        private float[] _shares = Array.Empty<float>();

        public void Resize(int tiles) => _shares = new float[tiles];

        /// <summary>Takes the frame's tiles; those of dots, which are exempt, keep what they had.</summary>
        public void Learn(TileGrid tiles, int minExcess)
        {
            for (int tile = 0; tile < _shares.Length; tile++)
            {
                if (!tiles.TakeExempt(tile))
                    _shares[tile] += Follow * ((tiles.Onset(tile) >= minExcess ? 1 : 0) - _shares[tile]);
            }
        }

        /// <summary>The largest share, 0…1, of the tile that holds a working pixel and of the eight around it.</summary>
        public double ShareAround(TileGrid tiles, int x, int y)
        {
            float largest = 0;
            int column = x / TileGrid.Size, row = y / TileGrid.Size;
            for (int r = Math.Max(0, row - 1); r <= Math.Min(tiles.Rows - 1, row + 1); r++)
            {
                for (int c = Math.Max(0, column - 1); c <= Math.Min(tiles.Columns - 1, column + 1); c++)
                    largest = Math.Max(largest, _shares[r * tiles.Columns + c]);
            }

            return largest;
        }
    }
}
