using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using LaserTracking.Calibration;
using LaserTracking.Geometry;
using LaserTracking.Host.Sources;
using LaserTracking.Host.Terminal;
using LaserTracking.Imaging;
using LaserTracking.Patterns;

namespace LaserTracking.Host.Calibration
{
    /// <summary>Finds the board in the pictures of one camera.</summary>
    internal static class BoardSearch
    {
        /// <exception cref="InputException">A picture cannot be read or has another size than the first, or none shows the board.</exception>
        public static SeenBoards Run(IReadOnlyList<string> files, Board board)
        {
            using var reader = new PictureFile();
            using var finder = new CheckerboardFinder();
            using var progress = new ProgressLine();
            Vector2D[] boardMm = board.CornersMm();
            SeenBoards? seen = null;
            for (int i = 0; i < files.Count; i++)
            {
                progress.Show(FormattableString.Invariant($"looking for the board: {i + 1} of {files.Count} …"));
                Image picture = reader.Read(files[i]);
                seen ??= new SeenBoards(files.Select(file => Path.GetFileName(file)).ToArray(), files.ToArray(), picture.Width, picture.Height);
                if (picture.Width != seen.Width || picture.Height != seen.Height)
                    throw new InputException(files[i], $"is {picture.Width}×{picture.Height}, {seen.Names[0]} is {seen.Width}×{seen.Height}", "use pictures of one camera in one mode");
                var corners = new Vector2D[board.Size.Count];
                if (finder.TryFind(picture, board.Size, corners, out string reason))
                {
                    BoardView.TryCreate(seen.Names[i], boardMm, corners, out BoardView? view, out reason);
                    seen.Views[i] = view;
                }

                seen.Reasons[i] = reason;
            }

            if (seen!.Views.All(view => view == null))
                throw new InputException(files[0], seen.Reasons[0] + (files.Count > 1 ? FormattableString.Invariant($", and no board in the other {files.Count - 1} pictures either") : string.Empty),
                    "check --board: it counts inner corners, where four squares meet");
            return seen;
        }
    }
}
