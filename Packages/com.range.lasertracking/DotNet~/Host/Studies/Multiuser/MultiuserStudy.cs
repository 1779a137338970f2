using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using LaserTracking.Session;

namespace LaserTracking.Host.Studies.Multiuser
{
    /// <summary>Several people fire at once: who is named, from where, along which line.</summary>
    internal sealed class MultiuserStudy : IStudy
    {
        private const int MaxNamed = 30;

        public string Name => "multiuser";

        public string What => "1 to 6 shooters, at once, crossing, hidden, with camera 1 late or lossy: shooter right, wrong, unknown; muzzle, palm, direction; calibration of shooter_p";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            MultiuserCase[] cases = MultiuserCase.All.Where(c => options.Includes(c.Name)).ToArray();
            var table = new StudyTable(FormattableString.Invariant($"seeds {options.FirstSeed}…{options.LastSeed}, 30 s each, one colour for all lasers, about 40 shots a minute and shooter"), MultiuserTally.Columns);
            var named = new List<(double Said, bool IsTrue)>();
            MultiuserTally[] tallies = cases.Select(_ => new MultiuserTally()).ToArray();
            for (int seed = options.FirstSeed; seed <= options.LastSeed; seed++)
            {
                for (int i = 0; i < cases.Length && !interrupted.IsCancellationRequested; i++)
                {
                    options.Progress.Show(FormattableString.Invariant($"seed {seed}, {cases[i].Name}"));
                    var run = new MultiuserRun(cases[i], seed);
                    run.Process(interrupted);
                    if (interrupted.IsCancellationRequested)
                        break;
                    tallies[i].Add(run);
                    NameWrong(table, cases[i], seed, run);
                }
            }

            for (int i = 0; i < cases.Length; i++)
            {
                if (tallies[i].Shots.Count == 0)
                    continue;
                tallies[i].Write(cases[i].Name, table);
                if (tallies[i].Reasons() is { Length: > 0 } reasons)
                    table.Notes.Add(FormattableString.Invariant($"not right, {cases[i].Name}: {reasons}"));
                if (tallies[i].Clocks() is { Length: > 0 } clocks)
                    table.Notes.Add(FormattableString.Invariant($"camera 1's clock, {cases[i].Name}: {clocks}"));
                named.AddRange(tallies[i].Shots.Where(s => s.IsNamed).Select(s => (s.Said.ShooterProbability, s.IsRight)));
            }

            table.Notes.InsertRange(0, CalibrationCurve.Describe(named).Concat(SaidPalm.Describe(tallies.SelectMany(t => t.Palms).ToArray())));
            table.Notes.Add("dots from the truth but for \"whole pipeline\"; right: numbers stand for people one to one; switches: a person's number differs from their last named shot; swaps: a hand's number goes over to another person's weapon hand, among palms that are stated, looked at ten times a second; MOTA and IDF1 of dots under their shooter's number");
            table.Notes.Add("muzzle where forearm, hand and muzzle are in view and the shooter is right; palms that are stated, of raised weapon hands in view, all hands and palms matched one to one within 0.3 m; withheld: found, but hidden or maybe another's; intervals 95 % (Wilson)");
            return table;
        }

        private static void NameWrong(StudyTable table, MultiuserCase situation, int seed, MultiuserRun run)
        {
            foreach (NamedShot shot in run.Shots.Where(s => s.IsNamed && !s.IsRight))
            {
                if (table.Notes.Count < MaxNamed)
                    table.Notes.Add(FormattableString.Invariant($"wrong: {situation.Name}, seed {seed}, {shot.Fired.SceneTimeUs / 1e6:F2} s at {shot.Fired.ScreenM.X:F2},{shot.Fired.ScreenM.Y:F2} m: person {shot.Fired.Shooter} taken for {shot.Meant} (number {shot.Said.Shooter}) with {shot.Said.ShooterProbability:F3}, {shot.WhyNot}"));
            }
        }
    }
}
