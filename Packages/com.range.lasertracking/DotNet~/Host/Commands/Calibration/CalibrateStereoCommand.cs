using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Linq;
using LaserTracking.Calibration;
using LaserTracking.Host.Calibration;
using LaserTracking.Host.Sources;

namespace LaserTracking.Host.Commands
{
    /// <summary>range calibrate stereo: two cameras beside each other, from pictures of one board by both at once or stored corners.</summary>
    internal static class CalibrateStereoCommand
    {
        public static Command Create()
        {
            var left = new Option<string[]>("--left") { HelpName = "GLOB", Description = "Pictures of camera 0: names, a folder, or a pattern in quotes.", AllowMultipleArgumentsPerToken = true };
            var right = new Option<string[]>("--right") { HelpName = "GLOB", Description = "As many of camera 1, in the same order, each taken at the same moment.", AllowMultipleArgumentsPerToken = true };
            var free = new Option<bool>("--free-intrinsics") { Description = "Seek both cameras' own numbers again together with how they stand to each other." };
            var options = new BoardOptions();
            var output = new CalibrationOutput("stereo.json");
            var command = new Command("stereo", "Determines two cameras and how they stand to each other: x_right = R x_left + T.") { left, right, free };
            options.AddTo(command);
            output.AddTo(command);
            command.SetAction(parsed =>
            {
                string[] leftPatterns = parsed.GetValue(left) ?? Array.Empty<string>(), rightPatterns = parsed.GetValue(right) ?? Array.Empty<string>();
                string? corners = parsed.GetValue(options.Corners);
                if (corners == null ? leftPatterns.Length == 0 || rightPatterns.Length == 0 : leftPatterns.Length + rightPatterns.Length > 0)
                    throw new InputException("calibrate stereo", corners == null ? "pictures of both cameras are needed" : "both pictures and stored corners given", "use either --left GLOB --right GLOB or --corners FILE");
                output.Check(parsed, corners);
                LensModel model = options.Model(parsed);
                Board? board = options.Board(parsed);
                IReadOnlyList<string> notes = Array.Empty<string>();
                (SeenBoards Left, SeenBoards Right) seen;
                if (corners != null)
                {
                    StoredCorners stored = StoredCorners.Open(corners, options.GivenSize(parsed), options.GivenSquareMm(parsed), board.Value);
                    if (!stored.HasPairs)
                        throw new InputException(corners, "holds views of one camera", "give a file with \"pairs\", or use './range calibrate board'");
                    seen = (stored.Read("left", options.ImageSize(parsed)), stored.Read("right", options.ImageSize(parsed)));
                    board = stored.Board;
                    notes = stored.Notes;
                }
                else
                {
                    List<string> leftFiles = PictureFile.Expand(leftPatterns, "--left"), rightFiles = PictureFile.Expand(rightPatterns, "--right");
                    output.Check(parsed, leftFiles.Concat(rightFiles).ToArray());
                    seen = Search(leftFiles, rightFiles, board.Value, options.KeepsAll(parsed));
                }

                string source = corners ?? leftPatterns[0];
                StereoSession session = StereoSession.Run(seen.Left, seen.Right, model, parsed.GetValue(free), options.KeepsAll(parsed), source);
                double? heldOut = HeldOutError.OfPairs(session.Both.Pairs, session.Left.Camera, session.Right.Camera, model);
                if (options.Pictures(parsed) is string folder)
                    BoardPictures.Write(folder, session, seen.Left, seen.Right, board?.Size);
                return output.Write(parsed, CalibrationReport.OfStereo(session.Left, session.Right, session.Both, session.Missing, options.ModelName(parsed), board, heldOut, notes));
            });
            return command;
        }

        private static (SeenBoards Left, SeenBoards Right) Search(List<string> left, List<string> right, Board board, bool keepsAll)
        {
            if (left.Count != right.Count)
                throw new InputException("calibrate stereo", $"{left.Count} pictures of the left camera, {right.Count} of the right", "each picture needs its partner, in the same order");
            return (BoardSearch.Run(left, board, keepsAll), BoardSearch.Run(right, board, keepsAll));
        }
    }
}
