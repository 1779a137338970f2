using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Calibration;
using LaserTracking.Geometry;
using LaserTracking.Host.Sources;
using LaserTracking.Host.Terminal;
using LaserTracking.Imaging;
using LaserTracking.Patterns;

namespace LaserTracking.Host.Calibration
{
    /// <summary>Finds the board in the pictures of one camera, and the pictures that are too blurred to measure with.</summary>
    internal static class BoardSearch
    {
        // Sharp pictures of one camera differ by a third in the width of their edges, with distance and focus.
        private const double BlurredFactor = 2;
        private const double SharpEnoughPx = 4;
        private const int FewestToCompare = 5;

        /// <param name="files">The pictures.</param>
        /// <param name="board">What to find.</param>
        /// <param name="keepsAll">Also blurred ones.</param>
        /// <exception cref="InputException">A picture cannot be read or has another size than the first, or none shows the board.</exception>
        public static SeenBoards Run(IReadOnlyList<string> files, Board board, bool keepsAll)
        {
            using var reader = new PictureFile();
            using var finder = new CheckerboardFinder();
            using var progress = new ProgressLine();
            using var gray = new Image();
            var edgeWidths = new double[files.Count];
            Vector2D[] boardMm = board.CornersMm();
            SeenBoards? seen = null;
            for (int i = 0; i < files.Count; i++)
            {
                progress.Show(FormattableString.Invariant($"looking for the board: {i + 1} of {files.Count} …"));
                Image picture = reader.Read(files[i]);
                seen ??= new SeenBoards(UniqueNames.Of(files), files.ToArray(), picture.Width, picture.Height);
                if (picture.Width != seen.Width || picture.Height != seen.Height)
                    throw new InputException(files[i], $"is {picture.Width}×{picture.Height}, {seen.Names[0]} is {seen.Width}×{seen.Height}", "use pictures of one camera in one mode");
                var corners = new Vector2D[board.Size.Count];
                if (finder.TryFind(picture, board.Size, corners, out string reason))
                {
                    BoardView.TryCreate(seen.Names[i], boardMm, corners, out BoardView? view, out reason);
                    seen.Views[i] = view;
                    GrayConversion.ToGray(picture, gray);
                    edgeWidths[i] = EdgeWidth.MedianPx(gray, board.Size, corners);
                }

                seen.Reasons[i] = reason;
            }

            if (seen!.Views.All(view => view == null))
                throw new InputException(files[0], seen.Reasons[0] + (files.Count > 1 ? FormattableString.Invariant($", and no board in the other {files.Count - 1} pictures either") : string.Empty),
                    "check --board: it counts inner corners, where four squares meet");
            if (!keepsAll)
                LeaveOutBlurred(seen, edgeWidths);
            return seen;
        }

        private static void LeaveOutBlurred(SeenBoards seen, double[] edgeWidths)
        {
            double[] found = edgeWidths.Where(width => width > 0).Order().ToArray();
            if (found.Length < FewestToCompare)
                return;
            double median = found[found.Length / 2];
            for (int i = 0; i < edgeWidths.Length; i++)
            {
                if (edgeWidths[i] <= Math.Max(SharpEnoughPx, BlurredFactor * median))
                    continue;
                seen.Views[i] = null;
                seen.Reasons[i] = FormattableString.Invariant($"blurred: its edges are {edgeWidths[i]:F1} px wide where {median:F1} px is usual");
            }
        }
    }
}
