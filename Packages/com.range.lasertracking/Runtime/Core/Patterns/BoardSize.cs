using System;
using System.Globalization;

namespace LaserTracking.Patterns
{
    /// <summary>Inner corners of a checkerboard, where four squares meet: a board of 10×7 squares has 9×6.</summary>
    public readonly struct BoardSize : IEquatable<BoardSize>
    {
        /// <summary>Fewest corners either way: with less there is no telling a board from clutter.</summary>
        public const int Least = 3;

        /// <summary>Most corners either way.</summary>
        public const int Most = 50;

        /// <param name="columns">Corners in a row, 3 to 50.</param>
        /// <param name="rows">Rows of corners, 3 to 50.</param>
        /// <exception cref="ArgumentOutOfRangeException">Outside these ranges.</exception>
        public BoardSize(int columns, int rows)
        {
            if (columns < Least || columns > Most)
                throw new ArgumentOutOfRangeException(nameof(columns), "3 to 50");
            if (rows < Least || rows > Most)
                throw new ArgumentOutOfRangeException(nameof(rows), "3 to 50");
            Columns = columns;
            Rows = rows;
        }

        public int Columns { get; }

        public int Rows { get; }

        public int Count => Columns * Rows;

        /// <summary>
        /// True when half a turn shows the board as it was (columns and rows both even or both odd), so that its first corner is a
        /// matter of how it is held; see <see cref="CheckerboardFinder"/> for the rule.
        /// </summary>
        public bool IsSymmetric => (Columns + Rows) % 2 == 0;

        /// <summary>Reads "9x6": columns, then rows.</summary>
        public static bool TryParse(string text, out BoardSize size)
        {
            size = default;
            string[] parts = text.Split('x', 'X', '×');
            if (parts.Length != 2
                || !int.TryParse(parts[0], NumberStyles.None, CultureInfo.InvariantCulture, out int columns)
                || !int.TryParse(parts[1], NumberStyles.None, CultureInfo.InvariantCulture, out int rows)
                || columns < Least || columns > Most || rows < Least || rows > Most)
                return false;
            size = new BoardSize(columns, rows);
            return true;
        }

        public bool Equals(BoardSize other) => Columns == other.Columns && Rows == other.Rows;

        public override bool Equals(object? obj) => obj is BoardSize other && Equals(other);

        public override int GetHashCode() => Columns * 64 + Rows;

        public override string ToString() => FormattableString.Invariant($"{Columns}×{Rows}");
    }
}
