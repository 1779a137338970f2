using System;

namespace LaserTracking.Tracking
{
    /// <summary>
    /// Minimal-cost one-to-one assignment of rows to columns, rectangular, O(n² m) by shortest augmenting paths with potentials
    /// (Kuhn 1955; Jonker and Volgenant 1987). Room is taken once; the same costs always give the same answer: rows enter in order,
    /// and of equally short paths the one to the lower column wins. Not thread-safe.
    /// </summary>
    public sealed class HungarianAssignment
    {
        /// <summary>Stands for a pairing that must not be; still assigned when there is no other way, so check the cost afterwards.</summary>
        public const double Forbidden = 1e9;

        private readonly int _capacity;
        private readonly double[] _potentialOfRow;
        private readonly double[] _potentialOfColumn;
        private readonly double[] _shortest;
        private readonly int[] _rowOfColumn;
        private readonly int[] _previous;
        private readonly bool[] _visited;

        /// <param name="capacity">Largest number of rows and of columns.</param>
        public HungarianAssignment(int capacity)
        {
            if (capacity < 1)
                throw new ArgumentOutOfRangeException(nameof(capacity));
            _capacity = capacity;
            _potentialOfRow = new double[capacity + 1];
            _potentialOfColumn = new double[capacity + 1];
            _shortest = new double[capacity + 1];
            _rowOfColumn = new int[capacity + 1];
            _previous = new int[capacity + 1];
            _visited = new bool[capacity + 1];
        }

        /// <summary>
        /// Fills columnOfRow with each row's column, or -1 for the rows that are left over, and returns the sum of the costs chosen.
        /// </summary>
        /// <param name="cost">Row by row, rows × columns; NaN and anything above <see cref="Forbidden"/> count as that.</param>
        /// <param name="rows">0 up to the capacity.</param>
        /// <param name="columns">0 up to the capacity.</param>
        /// <param name="columnOfRow">At least as long as there are rows.</param>
        public double Solve(ReadOnlySpan<double> cost, int rows, int columns, Span<int> columnOfRow)
        {
            if (rows < 0 || columns < 0 || rows > _capacity || columns > _capacity)
                throw new ArgumentOutOfRangeException(nameof(rows), "more rows or columns than the capacity");
            if (cost.Length < rows * columns || columnOfRow.Length < rows)
                throw new ArgumentException("the spans are shorter than rows and columns say");
            columnOfRow.Slice(0, rows).Fill(-1);
            if (rows == 0 || columns == 0)
                return 0;
            // The path search wants at most as many rows as columns; otherwise the matrix is read the other way round.
            bool swapped = rows > columns;
            int n = swapped ? columns : rows, m = swapped ? rows : columns;
            int rowStride = swapped ? 1 : columns, columnStride = swapped ? columns : 1;
            Array.Clear(_potentialOfRow, 0, n + 1);
            Array.Clear(_potentialOfColumn, 0, m + 1);
            Array.Clear(_rowOfColumn, 0, m + 1);
            for (int row = 1; row <= n; row++)
                Augment(cost, row, m, rowStride, columnStride);
            double total = 0;
            for (int j = 1; j <= m; j++)
            {
                int i = _rowOfColumn[j];
                if (i == 0)
                    continue;
                total += At(cost, (i - 1) * rowStride + (j - 1) * columnStride);
                if (swapped)
                    columnOfRow[j - 1] = i - 1;
                else
                    columnOfRow[i - 1] = j - 1;
            }

            return total;
        }

        /// <summary>Indices from 1; column 0 is the start of every path.</summary>
        private void Augment(ReadOnlySpan<double> cost, int row, int columns, int rowStride, int columnStride)
        {
            _rowOfColumn[0] = row;
            int column = 0;
            for (int j = 0; j <= columns; j++)
            {
                _shortest[j] = double.MaxValue;
                _visited[j] = false;
            }

            do
            {
                _visited[column] = true;
                int i = _rowOfColumn[column], next = 0;
                double delta = double.MaxValue;
                for (int j = 1; j <= columns; j++)
                {
                    if (_visited[j])
                        continue;
                    double reduced = At(cost, (i - 1) * rowStride + (j - 1) * columnStride) - _potentialOfRow[i] - _potentialOfColumn[j];
                    if (reduced < _shortest[j])
                    {
                        _shortest[j] = reduced;
                        _previous[j] = column;
                    }

                    if (_shortest[j] < delta)
                    {
                        delta = _shortest[j];
                        next = j;
                    }
                }

                for (int j = 0; j <= columns; j++)
                {
                    if (_visited[j])
                    {
                        _potentialOfRow[_rowOfColumn[j]] += delta;
                        _potentialOfColumn[j] -= delta;
                    }
                    else
                    {
                        _shortest[j] -= delta;
                    }
                }

                column = next;
            }
            while (_rowOfColumn[column] != 0);

            while (column != 0)
            {
                int before = _previous[column];
                _rowOfColumn[column] = _rowOfColumn[before];
                column = before;
            }
        }

        private static double At(ReadOnlySpan<double> cost, int index)
        {
            double value = cost[index];
            return value < Forbidden ? value : Forbidden;
        }
    }
}
