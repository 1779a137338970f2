using System.CommandLine;

namespace LaserTracking.Host.Commands
{
    /// <summary>The list of all commands: the only place that knows them all.</summary>
    internal static class RangeCommands
    {
        public static RootCommand Create()
        {
            var root = new RootCommand("Laser-shot training on a projected screen: from camera frames to scored hits.")
            {
                DemoCommand.Create(),
                ReplayCommand.Create(),
                RecordCommand.Create(),
                SendCommand.Create(),
                ReceiveCommand.Create(),
                InfoCommand.Create(),
                ExtractCommand.Create(),
                ExplainCommand.Create(),
                ScoreCommand.Create(),
                TrackCommand.Create(),
                ScoreTracksCommand.Create(),
                CalibrateCommand.Create(),
                HandsCommand.Create(),
                ModelsCommand.Create(),
                StudyCommand.Create(),
                TrainCommand.Create(),
                AdviseCommand.Create(),
                BenchCommand.Create(),
                TestCommand.Create(),
                DoctorCommand.Create(),
            };
            root.Add(HelpCommand.Create(root));
            return root;
        }
    }
}
