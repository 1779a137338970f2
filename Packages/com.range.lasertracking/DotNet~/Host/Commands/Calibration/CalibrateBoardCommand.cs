using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Linq;
using LaserTracking.Calibration;
using LaserTracking.Host.Calibration;
using LaserTracking.Host.Sources;

namespace LaserTracking.Host.Commands
{
    /// <summary>range calibrate board: one camera with its lens, from pictures of a checkerboard or stored corners.</summary>
    internal static class CalibrateBoardCommand
    {
        public static Command Create()
        {
            var images = new Option<string[]>("--images") { HelpName = "GLOB", Description = "Pictures of the board: names, a folder, or a pattern in quotes.", AllowMultipleArgumentsPerToken = true };
            var side = new Option<string>("--side") { HelpName = "SIDE", Description = "Which of stored pairs: left or right.", DefaultValueFactory = _ => "left" };
            var options = new BoardOptions();
            var output = new CalibrationOutput("camera.json");
            var command = new Command("board", "Determines a camera and its lens from pictures of a checkerboard, twenty tilted differently by custom.") { images, side };
            options.AddTo(command);
            output.AddTo(command);
            command.SetAction(parsed =>
            {
                string[] patterns = parsed.GetValue(images) ?? Array.Empty<string>();
                string? corners = parsed.GetValue(options.Corners);
                if (patterns.Length == 0 == (corners == null))
                    throw new InputException("calibrate board", corners == null ? "no pictures given" : "both pictures and stored corners given", "use either --images GLOB or --corners FILE");
                if (parsed.GetValue(side) is not ("left" or "right"))
                    throw new InputException("--side", $"there is no side \"{parsed.GetValue(side)}\"", "write left or right");
                output.Check(parsed, corners);
                LensModel model = options.Model(parsed);
                Board? board = options.Board(parsed);
                IReadOnlyList<string> notes = Array.Empty<string>();
                SeenBoards seen;
                if (corners != null)
                {
                    StoredCorners stored = StoredCorners.Open(corners, options.GivenSize(parsed), options.GivenSquareMm(parsed), board.Value);
                    seen = stored.Read(parsed.GetValue(side)!, options.ImageSize(parsed));
                    board = stored.Board;
                    notes = stored.Notes;
                }
                else
                {
                    List<string> files = PictureFile.Expand(patterns, "--images");
                    output.Check(parsed, files.ToArray());
                    seen = BoardSearch.Run(files, board.Value, options.KeepsAll(parsed));
                }

                BoardView[] views = seen.Views.OfType<BoardView>().ToArray();
                if (!CameraCalibrator.TryCalibrate(views, seen.Width, seen.Height, model, options.KeepsAll(parsed), out CameraCalibration? found, out string reason))
                    throw new InputException(corners ?? patterns[0], reason, "see './range help calibrate board'");
                double? heldOut = HeldOutError.OfCamera(found!.Views, seen.Width, seen.Height, model);
                if (options.Pictures(parsed) is string folder)
                    BoardPictures.Write(folder, found, seen, board?.Size);
                return output.Write(parsed, CalibrationReport.OfCamera(found, seen, options.ModelName(parsed), board, heldOut, notes));
            });
            return command;
        }
    }
}
