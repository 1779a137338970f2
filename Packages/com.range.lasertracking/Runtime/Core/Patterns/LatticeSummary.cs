using System;

namespace LaserTracking.Patterns
{
    /// <summary>The largest grid of a search, for the reason of a refusal.</summary>
    internal sealed class LatticeSummary
    {
        private int _across, _down, _filled;
        private bool _touchesBorder;

        public void Clear()
        {
            _across = _down = _filled = 0;
            _touchesBorder = false;
        }

        /// <summary>Keeps a grid if it has more corners than those before; lines that are less than half full at its rim do not count.</summary>
        public void Consider(CornerLattice lattice, int width, int height)
        {
            if (lattice.Count <= _filled)
                return;
            int left = lattice.FirstI, right = lattice.LastI, top = lattice.FirstJ, bottom = lattice.LastJ;
            bool isTrimmed = true;
            while (isTrimmed && left < right && top < bottom)
            {
                isTrimmed = true;
                if (2 * Filled(lattice, left, left, top, bottom) < bottom - top + 1)
                    left++;
                else if (2 * Filled(lattice, right, right, top, bottom) < bottom - top + 1)
                    right--;
                else if (2 * Filled(lattice, left, right, top, top) < right - left + 1)
                    top++;
                else if (2 * Filled(lattice, left, right, bottom, bottom) < right - left + 1)
                    bottom--;
                else
                    isTrimmed = false;
            }

            int filled = Filled(lattice, left, right, top, bottom);
            if (filled <= _filled)
                return;
            _across = right - left + 1;
            _down = bottom - top + 1;
            _filled = filled;
            _touchesBorder = TouchesBorder(lattice, left, right, top, bottom, width, height);
        }

        /// <summary>One line: what there is in place of the board asked for.</summary>
        public string Explain(BoardSize board)
        {
            if (_across < BoardSize.Least || _down < BoardSize.Least)
                return FormattableString.Invariant($"no checkerboard found, {board} inner corners asked for");
            bool turn = _across != board.Columns && _down != board.Rows
                && (_across == board.Rows || _down == board.Columns || _across > _down != board.Columns >= board.Rows);
            int columns = turn ? _down : _across, rows = turn ? _across : _down;
            string found = FormattableString.Invariant($"{columns}×{rows} corners found, {board} asked for");
            int missing = columns * rows - _filled;
            if (missing == 0 && columns == board.Columns && rows == board.Rows && !_touchesBorder)
                return FormattableString.Invariant($"{board} corners found, but they cannot be placed: too blurred, or the board is not flat");
            if (missing > 0)
                found += FormattableString.Invariant($"; {missing} of the {columns}×{rows} are hidden, in glare or too blurred");
            return _touchesBorder ? found + "; the board reaches the picture's edge" : found;
        }

        private static int Filled(CornerLattice lattice, int left, int right, int top, int bottom)
        {
            int count = 0;
            for (int j = top; j <= bottom; j++)
            for (int i = left; i <= right; i++)
                count += lattice.TryGet(i, j, out SaddlePoint _) ? 1 : 0;
            return count;
        }

        /// <summary>One more corner beyond a side would lie outside the picture.</summary>
        private static bool TouchesBorder(CornerLattice lattice, int left, int right, int top, int bottom, int width, int height)
        {
            for (int j = top; j <= bottom; j++)
            {
                if (IsLeaving(lattice, left + 1, j, left, j, width, height) || IsLeaving(lattice, right - 1, j, right, j, width, height))
                    return true;
            }

            for (int i = left; i <= right; i++)
            {
                if (IsLeaving(lattice, i, top + 1, i, top, width, height) || IsLeaving(lattice, i, bottom - 1, i, bottom, width, height))
                    return true;
            }

            return false;
        }

        private static bool IsLeaving(CornerLattice lattice, int fromI, int fromJ, int toI, int toJ, int width, int height)
        {
            if (!lattice.TryGet(fromI, fromJ, out Geometry.Vector2D from) || !lattice.TryGet(toI, toJ, out Geometry.Vector2D to))
                return false;
            Geometry.Vector2D next = to * 2 - from;
            return next.X < SaddleRing.Margin || next.Y < SaddleRing.Margin || next.X > width - SaddleRing.Margin || next.Y > height - SaddleRing.Margin;
        }
    }
}
