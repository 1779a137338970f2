using System.CommandLine;

namespace LaserTracking.Host.Commands
{
    /// <summary>range calibrate: one file a subcommand.</summary>
    internal static class CalibrateCommand
    {
        public static Command Create() => new("calibrate", "Determines the screen, a camera or two cameras, and checks them.")
        {
            CalibratePatternCommand.Create(),
            CalibrateScreenCommand.Create(),
            CalibrateVerifyCommand.Create(),
            CalibratePlaneCommand.Create(),
            CalibrateBoardCommand.Create(),
            CalibrateStereoCommand.Create(),
            CalibrateMappingCommand.Create(),
            CalibrateHistoryCommand.Create(),
            CalibrateSimulateCommand.Create(),
        };
    }
}
