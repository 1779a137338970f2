using System;
using LaserTracking.Geometry;

namespace LaserTracking.Calibration
{
    /// <summary>What one picture shows of a flat board: points known on the board and where they lie in the picture. Immutable.</summary>
    public sealed class BoardView
    {
        private const int MinimumPoints = 4;

        private BoardView(string name, Vector2D[] boardMm, Vector2D[] imagePx)
        {
            Name = name;
            BoardMm = boardMm;
            ImagePx = imagePx;
        }

        /// <summary>As messages name it: the picture's file name.</summary>
        public string Name { get; }

        /// <summary>In the board's plane, x along its rows, y along its columns; any unit, millimetres by custom.</summary>
        public Vector2D[] BoardMm { get; }

        /// <summary>As many, pixel centres are integers.</summary>
        public Vector2D[] ImagePx { get; }

        /// <param name="name">For messages.</param>
        /// <param name="boardMm">At least four finite points, not all on one line.</param>
        /// <param name="imagePx">Their places in the picture.</param>
        /// <param name="view">Null when refused.</param>
        /// <param name="reason">Why it was refused, one line that names the view; empty on success.</param>
        public static bool TryCreate(string name, Vector2D[] boardMm, Vector2D[] imagePx, out BoardView? view, out string reason)
        {
            view = null;
            reason = string.Empty;
            if (boardMm.Length != imagePx.Length)
                reason = FormattableString.Invariant($"{name}: {imagePx.Length} points in the picture against {boardMm.Length} on the board");
            else if (boardMm.Length < MinimumPoints)
                reason = FormattableString.Invariant($"{name}: {boardMm.Length} points; a view of a board needs at least {MinimumPoints}");
            for (int i = 0; i < boardMm.Length && reason.Length == 0; i++)
            {
                if (!boardMm[i].IsFinite || !imagePx[i].IsFinite)
                    reason = FormattableString.Invariant($"{name}: point {i + 1} is not finite");
            }

            if (reason.Length == 0 && !HomographyEstimator.TryFit(boardMm, imagePx, out _, out string why))
                reason = name + ": " + why;
            if (reason.Length > 0)
                return false;
            view = new BoardView(name, boardMm, imagePx);
            return true;
        }
    }
}
