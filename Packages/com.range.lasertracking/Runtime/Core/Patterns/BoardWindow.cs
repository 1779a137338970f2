using System;

namespace LaserTracking.Patterns
{
    /// <summary>A rectangle of a lattice's cells read in one of the four ways that keep columns and rows clockwise in the picture.</summary>
    internal readonly struct BoardWindow
    {
        private readonly int _i, _j, _columnI, _columnJ;

        private BoardWindow(int i, int j, int columnI, int columnJ, BoardSize size)
        {
            _i = i;
            _j = j;
            _columnI = columnI;
            _columnJ = columnJ;
            Size = size;
        }

        public BoardSize Size { get; }

        /// <summary>True when the square between the first four corners is dark.</summary>
        private bool StartsDark
        {
            get
            {
                // The square's least cell on either axis says its colour.
                int i = Math.Min(_i, _i + _columnI - _columnJ), j = Math.Min(_j, _j + _columnJ + _columnI);
                return (i + j) % 2 == 0;
            }
        }

        public bool TryGet(CornerLattice lattice, int column, int row, out SaddlePoint point) =>
            lattice.TryGet(_i + column * _columnI - row * _columnJ, _j + column * _columnJ + row * _columnI, out point);

        /// <summary>
        /// Finds a whole board of exactly this size in a lattice and the reading that starts with a dark square; of several the one
        /// whose first column runs most nearly down the picture.
        /// </summary>
        public static bool TryFind(CornerLattice lattice, BoardSize size, out BoardWindow window)
        {
            window = default;
            bool isFound = false, isDark = false;
            double bestDrop = 0;
            for (int turn = 0; turn < 4; turn++)
            {
                int columnI = turn == 0 ? 1 : turn == 2 ? -1 : 0, columnJ = turn == 1 ? 1 : turn == 3 ? -1 : 0;
                for (int j = lattice.FirstJ; j <= lattice.LastJ; j++)
                for (int i = lattice.FirstI; i <= lattice.LastI; i++)
                {
                    var candidate = new BoardWindow(i, j, columnI, columnJ, size);
                    if (!candidate.IsWholeBoard(lattice))
                        continue;
                    candidate.TryGet(lattice, 0, 0, out SaddlePoint first);
                    candidate.TryGet(lattice, 0, size.Rows - 1, out SaddlePoint last);
                    double drop = last.PositionPx.Y - first.PositionPx.Y;
                    bool dark = candidate.StartsDark;
                    if (isFound && (isDark && !dark || isDark == dark && drop <= bestDrop))
                        continue;
                    isFound = true;
                    isDark = dark;
                    bestDrop = drop;
                    window = candidate;
                }
            }

            return isFound;
        }

        /// <summary>Every corner is there, and beyond no side is there half a line or more.</summary>
        private bool IsWholeBoard(CornerLattice lattice)
        {
            if (!TryGet(lattice, Size.Columns - 1, Size.Rows - 1, out _))
                return false;
            for (int row = 0; row < Size.Rows; row++)
            for (int column = 0; column < Size.Columns; column++)
            {
                if (!TryGet(lattice, column, row, out _))
                    return false;
            }

            return 2 * CountRow(lattice, -1) < Size.Columns && 2 * CountRow(lattice, Size.Rows) < Size.Columns
                && 2 * CountColumn(lattice, -1) < Size.Rows && 2 * CountColumn(lattice, Size.Columns) < Size.Rows;
        }

        private int CountRow(CornerLattice lattice, int row)
        {
            int count = 0;
            for (int column = 0; column < Size.Columns; column++)
                count += TryGet(lattice, column, row, out _) ? 1 : 0;
            return count;
        }

        private int CountColumn(CornerLattice lattice, int column)
        {
            int count = 0;
            for (int row = 0; row < Size.Rows; row++)
                count += TryGet(lattice, column, row, out _) ? 1 : 0;
            return count;
        }
    }
}
