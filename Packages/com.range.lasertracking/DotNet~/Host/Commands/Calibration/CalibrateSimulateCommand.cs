using System.CommandLine;
using System.Text;
using LaserTracking.Host.Sessions;
using LaserTracking.Host.Studies.Calibration;

namespace LaserTracking.Host.Commands
{
    /// <summary>range calibrate simulate: stored corners of a session that never was, to try the other commands without a camera.</summary>
    internal static class CalibrateSimulateCommand
    {
        private const int MostViews = 200;

        public static Command Create()
        {
            var seed = new Option<int>("--seed") { HelpName = "N", Description = "The same seed gives the same cameras and boards.", DefaultValueFactory = _ => 1 };
            var views = new Option<int>("--views") { HelpName = "N", Description = "Number of pairs.", DefaultValueFactory = _ => 20 };
            var noise = new Option<double>("--noise") { HelpName = "PX", Description = "Standard deviation of each corner.", DefaultValueFactory = _ => 0.2 };
            var output = new Option<string>("--out") { HelpName = "FILE", Description = "The stored corners to write.", DefaultValueFactory = _ => "corners.json" };
            var command = new Command("simulate", "Writes the corners of a simulated session with two cameras, for --corners.") { seed, views, noise, output };
            command.SetAction(parsed =>
            {
                int count = parsed.GetValue(views);
                if (count < 1 || count > MostViews)
                    throw new InputException("--views", $"must be 1 to {MostViews}", "write it as 20");
                if (!(parsed.GetValue(noise) >= 0 && parsed.GetValue(noise) <= 10))
                    throw new InputException("--noise", "must be 0 to 10 px", "write it as 0.2");
                var boards = new SimulatedBoards(parsed.GetValue(seed));
                using var file = new ResultFile(parsed.GetValue(output)!);
                file.Stream.Write(Encoding.UTF8.GetBytes(boards.Format(boards.Pairs(count, parsed.GetValue(noise)))));
                file.Commit();
                return ExitCodes.Done;
            });
            return command;
        }
    }
}
