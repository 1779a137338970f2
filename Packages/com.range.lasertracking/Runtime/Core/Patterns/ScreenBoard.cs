using System;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// One of the two checkerboards that are projected for calibration. Each cell may carry a dot of the other colour in its middle;
    /// which cells do is a fixed code, so that any part of the board that is seen says where on the board it is, which way it lies and
    /// whether it is mirrored. The dots keep away from the cells' corners, which are the points that are measured. Immutable.
    /// </summary>
    public sealed class ScreenBoard
    {
        /// <summary>Cells from the picture's left edge to its right one.</summary>
        public const int CellsAcross = 16;

        /// <summary>Fewest and most rows of cells: pictures from 16:6 to 16:14.</summary>
        public const int LeastCellsDown = 6, MostCellsDown = 14;

        /// <summary>Radius of the dots as a share of a cell's height.</summary>
        public const double DotRadius = 0.2;

        private readonly bool[] _hasDot;

        /// <param name="cellsDown">Rows of cells in the picture, 6…14.</param>
        /// <param name="isShifted">Half a cell further right and down, with a code of its own: the points that prove the others.</param>
        public ScreenBoard(int cellsDown, bool isShifted)
        {
            if (cellsDown < LeastCellsDown || cellsDown > MostCellsDown)
                throw new ArgumentOutOfRangeException(nameof(cellsDown));
            CellsDown = cellsDown;
            IsShifted = isShifted;
            Columns = isShifted ? CellsAcross : CellsAcross - 1;
            Rows = isShifted ? cellsDown : cellsDown - 1;
            _hasDot = new bool[(Columns - 1) * (Rows - 1)];
            ulong state = (ulong)(2 * cellsDown + (isShifted ? 1 : 0));
            for (int i = 0; i < _hasDot.Length; i++)
                _hasDot[i] = (Scramble(ref state) >> 40 & 1) != 0;
        }

        public int CellsDown { get; }

        public bool IsShifted { get; }

        /// <summary>Points in a row.</summary>
        public int Columns { get; }

        /// <summary>Rows of points.</summary>
        public int Rows { get; }

        public int Count => Columns * Rows;

        /// <summary>Rows of cells that keep the cells of a picture of this shape nearly square.</summary>
        public static int CellsDownFor(double widthThroughHeight) =>
            (int)Math.Max(LeastCellsDown, Math.Min(MostCellsDown, Math.Round(CellsAcross / widthThroughHeight)));

        /// <summary>A point's place as shares of the picture's width and height, from its top-left corner.</summary>
        public Vector2D Place(int column, int row)
        {
            double first = IsShifted ? 0.5 : 1;
            return new Vector2D((column + first) / CellsAcross, (row + first) / CellsDown);
        }

        /// <summary>Whether the cell right of and below a point carries a dot; column below Columns - 1, row below Rows - 1.</summary>
        public bool HasDot(int column, int row) => _hasDot[row * (Columns - 1) + column];

        /// <summary>The colour of the cell right of and below a point, also at the picture's edge (column and row from -1).</summary>
        public static bool IsWhite(int column, int row) => (column + row & 1) == 0;

        /// <summary>Steele, Lea and Flood 2014, SplitMix64: a fixed sequence without pattern.</summary>
        private static ulong Scramble(ref ulong state)
        {
            unchecked
            {
                ulong z = state += 0x9E3779B97F4A7C15UL;
                z = (z ^ z >> 30) * 0xBF58476D1CE4E5B9UL;
                z = (z ^ z >> 27) * 0x94D049BB133111EBUL;
                return z ^ z >> 31;
            }
        }
    }
}
