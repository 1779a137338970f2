using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;

namespace LaserTracking.Host.Studies.Measuring
{
    /// <summary>How far the moment when the light began lies from the reported time, in milliseconds and in reported deviations.</summary>
    internal sealed class TimingStudy : IStudy
    {
        public string Name => "timing";

        public string What => "when the light of simulated shots began against the reported time and its deviation (shutters, rolling shutter, frame rates)";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            var table = new StudyTable("Simulated shots: begin of the light minus reported time (mid-exposure of the dot's row in its first frame)",
                "range", "shots", "mean ms", "rms ms", "rms / reported", "within 1 sigma", "within 2 sigma");
            List<MeasuredShot> told = new(), untold = new();
            foreach (string name in MeasuredRange.Names.Where(options.Includes))
            {
                for (int seed = options.FirstSeed; seed <= options.LastSeed && !interrupted.IsCancellationRequested; seed++)
                {
                    options.Progress.Show(name + ", seed " + seed);
                    ShotCollector.Collect(MeasuredRange.Create(name, seed), told, untold, interrupted);
                }

                AddRow(table, name, told.Where(s => s.Range == name).ToList());
                AddRow(table, name + ", shutter not told", untold.Where(s => s.Range == name).ToList());
            }

            AddRow(table, "all", told);
            AddRow(table, "all, shutter not told", untold);
            table.Notes.Add("The begin is spread evenly over a frame interval: 58 % lie within one deviation of an even spread, all within two.");
            return table;
        }

        private static void AddRow(StudyTable table, string name, List<MeasuredShot> shots)
        {
            if (shots.Count == 0)
                return;
            double Relative(MeasuredShot s) => s.LateUs / Math.Max(1, s.Seen.TimeSigmaUs);
            Proportion Within(double deviations) => new(shots.Count(s => Math.Abs(Relative(s)) <= deviations), shots.Count);
            table.Add(name, shots.Count, shots.Average(s => s.LateUs) / 1000, Math.Sqrt(shots.Average(s => s.LateUs * s.LateUs)) / 1000,
                Math.Sqrt(shots.Average(s => Relative(s) * Relative(s))), Within(1), Within(2));
        }
    }
}
