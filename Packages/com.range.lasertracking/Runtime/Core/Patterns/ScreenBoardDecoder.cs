using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// Reads the dots of a lattice's cells and finds the one place on one of the boards, in one of the eight ways to lay it, where
    /// they fit. The fit is judged against chance: agreements less disagreements, in standard deviations of throwing coins.
    /// </summary>
    internal sealed class ScreenBoardDecoder
    {
        /// <summary>Of some ten thousand places tried, none gets this far by chance in 10⁴ lattices.</summary>
        private const double LeastScore = 6;

        /// <summary>By how much the best place must be better than any other.</summary>
        private const double LeastLead = 1;

        /// <summary>Cells by which a lattice may reach beyond the board: edges of the picture and what lies next to it.</summary>
        private const int Beyond = 2;

        private readonly ScreenBoard[] _boards;
        private readonly List<Cell> _cells = new List<Cell>();
        private readonly List<(int I, int J, Vector2D Px)> _corners = new List<(int, int, Vector2D)>();

        /// <param name="boards">Those that may be seen.</param>
        public ScreenBoardDecoder(ScreenBoard[] boards) => _boards = boards;

        /// <summary>The board recognised last.</summary>
        public ScreenBoard Board { get; private set; } = null!;

        /// <summary>Its white cells are the bright ones; else it is seen as the inverse picture shows it.</summary>
        public bool IsUpright { get; private set; }

        public bool IsMirrored { get; private set; }

        /// <summary>Its points (column, row) as far as the lattice holds them, px of the full picture.</summary>
        public Dictionary<(int Column, int Row), Vector2D> Points { get; } = new Dictionary<(int, int), Vector2D>();

        /// <param name="signal">What the lattice was found in.</param>
        /// <param name="lattice">Its corners in px of a halving.</param>
        /// <param name="level">How often that was halved.</param>
        public bool TryDecode(SignalPicture signal, CornerLattice lattice, int level)
        {
            ReadCells(signal, lattice, 1 << level);
            double best = 0, second = 0;
            int bestWay = 0, bestI = 0, bestJ = 0, bestAlternation = 0;
            for (int way = 0; way < 8; way++)
            {
                Bounds(way, out int left, out int top, out int right, out int bottom);
                foreach (ScreenBoard board in _boards)
                {
                    for (int j = -top - Beyond; j + bottom <= board.Rows - 2 + Beyond; j++)
                    {
                        for (int i = -left - Beyond; i + right <= board.Columns - 2 + Beyond; i++)
                        {
                            double score = Judge(board, way, i, j, out int alternation);
                            if (score <= second)
                                continue;
                            if (score <= best)
                                second = score;
                            else
                                (second, best, Board, bestWay, bestI, bestJ, bestAlternation) = (best, score, board, way, i, j, alternation);
                        }
                    }
                }
            }

            if (best < LeastScore || best - second < LeastLead)
                return false;
            IsUpright = bestAlternation > 0;
            IsMirrored = bestWay >= 4;
            Points.Clear();
            foreach ((int i, int j, Vector2D px) in _corners)
            {
                // In half cells, corners are odd and middles even: a turn takes corners to corners.
                Turn(bestWay, 2 * i - 1, 2 * j - 1, out int x, out int y);
                int column = (x + 1) / 2 + bestI, row = (y + 1) / 2 + bestJ;
                if (column >= 0 && row >= 0 && column < Board.Columns && row < Board.Rows)
                    Points[(column, row)] = px;
            }

            return true;
        }

        private void ReadCells(SignalPicture signal, CornerLattice lattice, double scale)
        {
            _cells.Clear();
            _corners.Clear();
            double sum = 0;
            for (int j = lattice.FirstJ; j <= lattice.LastJ; j++)
            {
                for (int i = lattice.FirstI; i <= lattice.LastI; i++)
                {
                    if (!TryCorner(lattice, i, j, scale, out Vector2D first))
                        continue;
                    _corners.Add((i, j, first));
                    if (!TryCorner(lattice, i + 1, j, scale, out Vector2D along) || !TryCorner(lattice, i, j + 1, scale, out Vector2D across) || !TryCorner(lattice, i + 1, j + 1, scale, out Vector2D opposite))
                        continue;
                    double At(double x, double y) => signal.At((first * (1 - x) + along * x) * (1 - y) + (across * (1 - x) + opposite * x) * y);
                    double ring = (At(0.25, 0.25) + At(0.75, 0.25) + At(0.25, 0.75) + At(0.75, 0.75) + At(0.15, 0.5) + At(0.85, 0.5) + At(0.5, 0.15) + At(0.5, 0.85)) / 8;
                    double middle = (2 * At(0.5, 0.5) + At(0.42, 0.5) + At(0.58, 0.5) + At(0.5, 0.42) + At(0.5, 0.58)) / 6;

                    // Blur takes off the dot's contrast first: half way from the cell's own colour is a dot.
                    _cells.Add(new Cell { I = i, J = j, IsBright = ring > 0, HasDot = middle / ring < 0.5, Light = Math.Abs(ring) });
                    sum += Math.Abs(ring);
                }
            }

            double least = 0.25 * sum / Math.Max(1, _cells.Count);
            _cells.RemoveAll(cell => cell.Light < least);
        }

        private static bool TryCorner(CornerLattice lattice, int i, int j, double scale, out Vector2D px)
        {
            bool isThere = lattice.TryGet(i, j, out Vector2D place);
            px = (place + new Vector2D(0.5, 0.5)) * scale - new Vector2D(0.5, 0.5);
            return isThere;
        }

        private double Judge(ScreenBoard board, int way, int offsetI, int offsetJ, out int alternation)
        {
            int agreements = 0;
            alternation = 0;
            foreach (Cell cell in _cells)
            {
                Turn(way, 2 * cell.I, 2 * cell.J, out int x, out int y);
                int column = x / 2 + offsetI, row = y / 2 + offsetJ;
                if (column < 0 || row < 0 || column >= board.Columns - 1 || row >= board.Rows - 1)
                    continue;
                agreements += board.HasDot(column, row) == cell.HasDot ? 1 : -1;
                alternation += ScreenBoard.IsWhite(column, row) == cell.IsBright ? 1 : -1;
            }

            return agreements / Math.Sqrt(_cells.Count);
        }

        private void Bounds(int way, out int left, out int top, out int right, out int bottom)
        {
            left = top = int.MaxValue / 4;
            right = bottom = int.MinValue / 4;
            foreach (Cell cell in _cells)
            {
                Turn(way, 2 * cell.I, 2 * cell.J, out int x, out int y);
                left = Math.Min(left, x / 2);
                right = Math.Max(right, x / 2);
                top = Math.Min(top, y / 2);
                bottom = Math.Max(bottom, y / 2);
            }
        }

        /// <summary>Quarter turns, from 4 on of the mirrored lattice.</summary>
        private static void Turn(int way, int i, int j, out int x, out int y)
        {
            if (way >= 4)
                i = -i;
            (x, y) = (way & 3) switch { 0 => (i, j), 1 => (-j, i), 2 => (-i, -j), _ => (j, -i) };
        }

        private struct Cell
        {
            public int I, J;
            public bool IsBright, HasDot;
            public double Light;
        }
    }
}
