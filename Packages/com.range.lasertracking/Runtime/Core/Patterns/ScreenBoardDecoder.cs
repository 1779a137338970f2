using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>
    /// Reads the dots of a grid's cells and finds the one place on one of the boards, in one of the eight ways to lay it, where they
    /// fit. The fit is judged against chance: agreements less disagreements, in standard deviations of throwing coins.
    /// </summary>
    internal sealed class ScreenBoardDecoder
    {
        /// <summary>Of some ten thousand places tried, none gets this far by chance in 10⁴ grids.</summary>
        private const double LeastScore = 6;

        /// <summary>Share of the cells' colours that must alternate as the board's do.</summary>
        private const double LeastAlternation = 0.9;

        private readonly ScreenBoard[] _boards;
        private readonly List<Cell> _cells = new List<Cell>();

        /// <param name="boards">Those that may be seen.</param>
        public ScreenBoardDecoder(ScreenBoard[] boards) => _boards = boards;

        public ScreenBoard Board { get; private set; } = null!;

        /// <summary>White cells are bright in the plane; otherwise dark.</summary>
        public bool IsUpright { get; private set; }

        public bool IsMirrored { get; private set; }

        /// <summary>How well the last grid fitted.</summary>
        public double Score { get; private set; }

        /// <summary>Board points (column, row) in the plane; after a success.</summary>
        public Dictionary<(int Column, int Row), Vector2D> Points { get; } = new Dictionary<(int, int), Vector2D>();

        public bool TryDecode(LightPlane plane, SaddleGrid grid)
        {
            ReadCells(plane, grid);
            Score = 0;
            double second = 0;
            int bestWay = 0, bestU = 0, bestV = 0, bestAgreement = 0;
            for (int way = 0; way < 8; way++)
            {
                Bounds(way, out int left, out int top, out int right, out int bottom);
                foreach (ScreenBoard board in _boards)
                {
                    for (int v = -top; v + bottom <= board.Rows - 2; v++)
                    {
                        for (int u = -left; u + right <= board.Columns - 2; u++)
                        {
                            double score = Judge(board, way, u, v, out int alternation);
                            if (Math.Abs(alternation) < (2 * LeastAlternation - 1) * _cells.Count || score <= second)
                                continue;
                            if (score <= Score)
                            {
                                second = score;
                                continue;
                            }

                            (second, Score, Board, bestWay, bestU, bestV, bestAgreement) = (Score, score, board, way, u, v, alternation);
                        }
                    }
                }
            }

            if (Score < LeastScore || Score - second < 1)
                return false;
            IsUpright = bestAgreement > 0;
            IsMirrored = bestWay >= 4;
            Points.Clear();
            foreach (KeyValuePair<(int U, int V), Vector2D> corner in grid.Corners)
            {
                // A corner is the cell's top-left one only as the grid lies; turned, cells and corners shift against one another.
                Turn(bestWay, 2 * corner.Key.U - 1, 2 * corner.Key.V - 1, out int x, out int y);
                int column = (x + 1) / 2 + bestU, row = (y + 1) / 2 + bestV;
                if (column >= 0 && row >= 0 && column < Board.Columns && row < Board.Rows)
                    Points[(column, row)] = corner.Value;
            }

            return true;
        }

        private void ReadCells(LightPlane plane, SaddleGrid grid)
        {
            _cells.Clear();
            double sum = 0;
            foreach (KeyValuePair<(int U, int V), Vector2D> corner in grid.Corners)
            {
                (int u, int v) = corner.Key;
                if (!grid.Corners.TryGetValue((u + 1, v), out Vector2D right) || !grid.Corners.TryGetValue((u, v + 1), out Vector2D below) || !grid.Corners.TryGetValue((u + 1, v + 1), out Vector2D opposite))
                    continue;
                double At(double x, double y)
                {
                    Vector2D p = (corner.Value * (1 - x) + right * x) * (1 - y) + (below * (1 - x) + opposite * x) * y;
                    return plane.At(p.X, p.Y);
                }

                double ring = (At(0.25, 0.25) + At(0.75, 0.25) + At(0.25, 0.75) + At(0.75, 0.75) + At(0.15, 0.5) + At(0.85, 0.5) + At(0.5, 0.15) + At(0.5, 0.85)) / 8;
                double middle = (2 * At(0.5, 0.5) + At(0.42, 0.5) + At(0.58, 0.5) + At(0.5, 0.42) + At(0.5, 0.58)) / 6;
                _cells.Add(new Cell { U = u, V = v, IsBright = ring > 0, HasDot = middle / ring < 0.5, Light = Math.Abs(ring) });
                sum += Math.Abs(ring);
            }

            double least = 0.25 * sum / Math.Max(1, _cells.Count);
            _cells.RemoveAll(cell => cell.Light < least);
        }

        private double Judge(ScreenBoard board, int way, int u, int v, out int alternation)
        {
            int agreements = 0;
            alternation = 0;
            foreach (Cell cell in _cells)
            {
                Turn(way, 2 * cell.U, 2 * cell.V, out int x, out int y);
                int column = x / 2 + u, row = y / 2 + v;
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
                Turn(way, 2 * cell.U, 2 * cell.V, out int x, out int y);
                left = Math.Min(left, x / 2);
                right = Math.Max(right, x / 2);
                top = Math.Min(top, y / 2);
                bottom = Math.Max(bottom, y / 2);
            }
        }

        /// <summary>Quarter turns, from 4 on mirrored.</summary>
        private static void Turn(int way, int u, int v, out int x, out int y)
        {
            if (way >= 4)
                u = -u;
            (x, y) = (way & 3) switch { 0 => (u, v), 1 => (-v, u), 2 => (-u, -v), _ => (v, -u) };
        }

        private struct Cell
        {
            public int U, V;
            public bool IsBright, HasDot;
            public double Light;
        }
    }
}
