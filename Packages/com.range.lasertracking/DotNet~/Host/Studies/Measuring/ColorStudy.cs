using System.Collections.Generic;
using System.Linq;
using System.Threading;
using LaserTracking.Detection;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Studies.Measuring
{
    /// <summary>Whether simulated shots are given their laser's colour: right, unknown or wrong.</summary>
    internal sealed class ColorStudy : IStudy
    {
        private static readonly LaserColor[] Colors = { LaserColor.Green, LaserColor.Red, LaserColor.Infrared };

        private static readonly string[] Ranges =
        {
            "720p30", "480p30 NV12, rolling", "480p15 YUY2, open shutter", "720p30 JPEG", "720p30 dim lasers", "720p30 strong lasers", "480p30 over-exposed", "480p30 far over-exposed",
        };

        public string Name => "colors";

        public string What => "colour of simulated shots: right, unknown, wrong (green, red and infrared lasers, over-exposed pictures, coarse chroma)";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            var table = new StudyTable("Simulated shots found, by their laser's colour", "range and laser", "found", "right", "unknown", "wrong");
            var all = new List<MeasuredShot>();
            foreach (string range in Ranges.Where(options.Includes))
            {
                foreach (LaserColor color in Colors)
                {
                    var shots = new List<MeasuredShot>();
                    for (int seed = options.FirstSeed; seed <= options.LastSeed && !interrupted.IsCancellationRequested; seed++)
                    {
                        options.Progress.Show(range + ", " + color + ", seed " + seed);
                        SimulationScenario scenario = MeasuredRange.Create(range, seed);
                        foreach (ShooterSettings shooter in scenario.Shooters)
                        {
                            shooter.Laser.Color = color;

                            // A colour camera's filter stops nearly all infrared: only strong emitters are seen at all.
                            if (color == LaserColor.Infrared)
                                shooter.Laser.PowerMw *= 20;
                        }

                        ShotCollector.Collect(scenario, shots, null, interrupted);
                    }

                    AddRow(table, range + ", " + color.ToString().ToLowerInvariant(), shots);
                    all.AddRange(shots);
                }
            }

            AddRow(table, "all", all);
            table.Notes.Add("Infrared lasers are 20 times as strong. In a colour picture they are white: unknown is the right answer as long as there is no infrared picture.");
            return table;
        }

        private static void AddRow(StudyTable table, string name, List<MeasuredShot> shots)
        {
            int right = shots.Count(s => s.IsColorRight), unknown = shots.Count(s => s.IsColorUnknown);
            table.Add(name, shots.Count, new Proportion(right, shots.Count), new Proportion(unknown, shots.Count), new Proportion(shots.Count - right - unknown, shots.Count));
        }
    }
}
