using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Linq;
using System.Threading;
using System.Threading.Tasks;
using LaserTracking.Detection;
using LaserTracking.Host.Studies;
using LaserTracking.Host.Studies.Clips;
using LaserTracking.Host.Studies.Evidence;
using LaserTracking.Host.Terminal;

namespace LaserTracking.Host.Commands
{
    /// <summary>range train: learns the curves by which the default detector weighs candidates, and says how well they tell dots from the rest.</summary>
    internal static class TrainCommand
    {
        public static Command Create()
        {
            var seeds = new Option<string>("--seeds") { HelpName = "A..B", Description = "Simulated ranges to learn from, by seed; A also draws the pasted dots.", DefaultValueFactory = _ => StudyCommand.DefaultSeeds };
            var only = new Option<string?>("--only") { HelpName = "TEXT", Description = "Learn only from the cases whose names contain this: those of the studies clips-stress and pasted-dots, and " + CandidateSet.SimulationCase + "." };
            var write = new Option<string?>("--write") { HelpName = "FILE", Description = "Where to write the curves, as the C# file that the detector is built with." };
            var unseen = new Option<bool>("--unseen") { Description = "Plays each recorded clip, as it is and stressed, by curves that were learned without it: what to expect of footage nobody has seen." };
            var json = new Option<bool>("--json") { Description = "Prints JSON instead of a table, one document for each." };
            var command = new Command("train", "Learns how the detector weighs candidates, and prints how well that tells dots from the rest.") { seeds, only, write, unseen, json };
            command.SetAction((parsed, interrupted) =>
                Task.FromResult(Run(parsed.GetValue(seeds)!, parsed.GetValue(only), parsed.GetValue(write), parsed.GetValue(unseen), parsed.GetValue(json), interrupted)));
            return command;
        }

        private static int Run(string seeds, string? only, string? file, bool withUnseen, bool asJson, CancellationToken interrupted)
        {
            (int first, int last) = StudyCommand.ParseSeeds(seeds);
            if (file != null && Path.GetDirectoryName(Path.GetFullPath(file)) is { } folder && !Directory.Exists(folder))
                throw new InputException(file, "its folder does not exist", "name a file in a folder that exists");

            // What is missing is said before minutes of learning.
            ClipSet? unseen = withUnseen ? ClipSet.Open() : null;
            EvidenceTraining training;
            var tables = new List<StudyTable>();
            using (var progress = new ProgressLine())
            {
                var options = new StudyOptions(first, last, progress, only);
                training = EvidenceTraining.Run(CandidateSet.Collect(options, interrupted), options, interrupted);
                tables.Add(EvidenceTable.Of(training));
                if (unseen != null)
                    tables.Add(ClipStressStudy.Run(unseen, clip => SettingsWithout(training, clip), options, interrupted));
            }

            foreach (StudyTable table in tables)
            {
                if (asJson)
                    Console.WriteLine(table.ToJson());
                else
                    table.Print(Console.Out);
            }

            if (interrupted.IsCancellationRequested)
                return ExitCodes.Interrupted;
            if (file != null)
                WriteCurves(file, training);
            return ExitCodes.Done;
        }

        /// <summary>The clips are the first groups.</summary>
        private static ShotDetectorSettings? SettingsWithout(EvidenceTraining training, int clip) =>
            training.Without.TryGetValue(clip, out BoostedCurves? others) ? new ShotDetectorSettings { Evidence = others.ToEvidence(training.Set.Measures) } : null;

        private static void WriteCurves(string file, EvidenceTraining training)
        {
            try
            {
                File.WriteAllText(file, CurveFileWriter.Write(training.Curves, training.Set.Measures.Select(m => (m.What, m.Reason)).ToArray()));
            }
            catch (Exception e) when (e is IOException or UnauthorizedAccessException)
            {
                throw new InputException(file, "cannot be written", "check its name and rights");
            }
        }
    }
}
