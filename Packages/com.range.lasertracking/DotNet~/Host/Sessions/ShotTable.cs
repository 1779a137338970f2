using System;
using System.Collections.Generic;
using System.Globalization;
using System.IO;
using System.Linq;
using LaserTracking.Session;
using Spectre.Console;

namespace LaserTracking.Host.Sessions
{
    /// <summary>What a session found, for people at a terminal.</summary>
    internal static class ShotTable
    {
        private const int Width = 140;
        private const int MaximumRows = 200;

        public static void Print(SessionRecorder session, SessionPlan plan)
        {
            IAnsiConsole console = AnsiConsole.Create(new AnsiConsoleSettings { Out = new AnsiConsoleOutput(Console.Out) });
            console.Profile.Width = Width;
            ShotEvent[] shots = session.ShotsByTime();
            if (shots.Length > 0)
                console.Write(Table(shots.Take(MaximumRows), session.StartTimeUs, plan));
            if (shots.Length > MaximumRows)
                console.WriteLine($"… and {shots.Length - MaximumRows} more");
            console.WriteLine(Summary(session, shots, plan));
            foreach (HealthEvent advice in session.Health.Where(h => h.Kind == HealthKind.Advice))
                console.WriteLine("seen here: " + advice.Text);
            foreach (HealthEvent health in session.Health.Where(h => h.Kind != HealthKind.Advice).Take(5))
                console.WriteLine($"health, frame {health.FrameIndex}: {health.Text}");
        }

        private static Table Table(IEnumerable<ShotEvent> shots, long startUs, SessionPlan plan)
        {
            bool hasScreen = plan.Calibration != null, hasShooters = plan.HandCamera != null, hasScene = plan.Scene != null;
            Table table = new Table().Border(TableBorder.Simple);
            table.AddColumns("shot", "time s", "frame", "x px", "y px", "colour", "conf");
            if (hasScreen)
                table.AddColumns("x m", "y m", "± mm");
            if (hasShooters)
                table.AddColumns("shooter", "p");
            if (hasScene)
                table.AddColumns("target", "zone", "points", "score");
            foreach (ShotEvent e in shots)
            {
                var cells = new List<string>
                {
                    Text(e.Shot.Id), Text((e.Shot.TimeUs - startUs) * 1e-6, "F3"), Text(e.Shot.FrameIndex),
                    Text(e.Shot.Dot.PositionPx.X, "F1"), Text(e.Shot.Dot.PositionPx.Y, "F1"),
                    e.Shot.Dot.Color.ToString().ToLowerInvariant(), Text(e.Shot.Dot.Confidence, "F2"),
                };
                if (hasScreen)
                    cells.AddRange(new[] { Text(e.ScreenM.X, "F3"), Text(e.ScreenM.Y, "F3"), Text(e.ScreenCovarianceMm2.Sigma, "F1") });
                if (hasShooters)
                    cells.AddRange(e.Shooter > 0 ? new[] { Text(e.Shooter), Text(e.ShooterProbability, "F2") } : new[] { "unknown", string.Empty });
                if (hasScene)
                    cells.AddRange(e.HasHit ? new[] { e.Hit.Target, e.Hit.Zone, Text(e.Hit.Points), Text(e.Hit.Score, "F1") } : new[] { "miss", string.Empty, string.Empty, string.Empty });
                table.AddRow(cells.Select(Markup.Escape).ToArray());
            }

            return table;
        }

        private static string Summary(SessionRecorder session, ShotEvent[] shots, SessionPlan plan)
        {
            SessionEnd end = session.Summary;
            string text = FormattableString.Invariant($"{shots.Length} shots in {end.SecondsMedia:F1} s ({end.Frames} frames, {end.Dropped} without a picture)");
            if (plan.Scene != null)
                text += FormattableString.Invariant($", {shots.Count(s => s.HasHit && s.Hit.Points >= 0)} hits, {shots.Count(s => s.HasHit && s.Hit.Points < 0)} on no-shoots, {shots.Sum(s => s.HasHit ? s.Hit.Points : 0)} points");
            if (plan.SecondsWall != null)
                return text;
            return text + FormattableString.Invariant($"; took {end.SecondsWall:F1} s, {end.SecondsMedia / Math.Max(1e-3, end.SecondsWall):F1} times real time");
        }

        private static string Text(double value, string format) => value.ToString(format, CultureInfo.InvariantCulture);

        private static string Text(int value) => value.ToString(CultureInfo.InvariantCulture);
    }
}
