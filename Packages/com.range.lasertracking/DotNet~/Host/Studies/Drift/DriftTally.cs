using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;
using System.Text.RegularExpressions;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Health;
using LaserTracking.Session;

namespace LaserTracking.Host.Studies.Drift
{
    /// <summary>What the drift watch says of the sessions of one row.</summary>
    internal sealed partial class DriftTally
    {
        public const double InTimeS = 5;

        /// <summary>How far what is said may be off, px and share; more where a creep may be in the midst of being said.</summary>
        private const double OffPx = 0.5, OffShare = 0.1, OffGradualPx = 1.5;

        private readonly List<double> _afterS = new();
        private int _sessions, _moving, _false, _named, _right, _unclear;

        /// <summary>Sessions that did not go as they should, with what was said.</summary>
        public List<string> Failures { get; } = new();

        public static string[] Columns => ["case", "sessions", "called moved without need", "moved: noticed in 5 s", "way and length right", "s after, median", "s after, most", "sessions called unclear"];

        /// <summary>Plays a session to one monitor for each of its rows.</summary>
        public static void Play(DriftSession session, IReadOnlyDictionary<string, DriftTally> rows)
        {
            var recorders = new List<(SessionRecorder Recorder, PictureMonitor Monitor, DriftTally Tally, bool IsKnown)>();
            foreach ((string row, Vector2D[]? outlinePx) in session.Watches)
            {
                if (!rows.TryGetValue(row, out DriftTally? tally))
                    continue;
                var recorder = new SessionRecorder();
                var monitor = new PictureMonitor(recorder);
                if (outlinePx != null)
                    monitor.SetScreenPolygon(outlinePx);
                recorders.Add((recorder, monitor, tally, outlinePx != null));
            }

            int width = 640;
            if (recorders.Count == 0)
                return;
            foreach (Frame frame in session.Frames)
            {
                width = frame.Color.Width;
                foreach ((_, PictureMonitor monitor, _, _) in recorders)
                    monitor.Process(frame);
            }

            foreach ((SessionRecorder recorder, _, DriftTally tally, bool isKnown) in recorders)
                tally.Add(session, recorder.Health, 640.0 / width, isKnown);
        }

        private void Add(DriftSession session, IReadOnlyList<HealthEvent> health, double scale, bool isKnown)
        {
            HealthEvent[] moved = health.Where(h => h.Kind == HealthKind.CameraMoved).ToArray(), after = moved.Where(h => h.TimeUs >= session.FromS * 1e6).ToArray();
            bool isFalse = moved.Length > after.Length, isUnclear = health.Any(h => h.Kind == HealthKind.MotionUnclear);
            _sessions++;
            _false += isFalse ? 1 : 0;
            _unclear += isUnclear ? 1 : 0;
            bool isNamed = false, isRight = false;
            if (session.Moves)
            {
                double wait = after.Length == 0 ? double.PositiveInfinity : after[0].TimeUs / 1e6 - session.DueS;
                isNamed = wait <= InTimeS;
                if (isNamed)
                    _afterS.Add(wait);

                // Without a screen each part is counted from the one before.
                Vector2D said = after.Length == 0 ? default : isKnown ? Shift(after[^1].Text) : after.Aggregate(default(Vector2D), (sum, h) => sum + Shift(h.Text));
                isRight = after.Length > 0 && (said * scale - session.MovedPx).Length <= (session.IsGradual ? OffGradualPx : OffPx) + OffShare * session.MovedPx.Length;
                _moving++;
                _named += isNamed ? 1 : 0;
                _right += isRight ? 1 : 0;
            }

            if (isFalse || (session.Moves && !(isNamed && isRight)))
            {
                string truth = session.Moves ? FormattableString.Invariant($"moved by ({session.MovedPx.X:F1}, {session.MovedPx.Y:F1}) px from {session.FromS:F1} s") : "not moved";
                string said = string.Join("; ", health.Where(h => h.Kind is HealthKind.CameraMoved or HealthKind.MotionUnclear).Select(h =>
                    FormattableString.Invariant($"{(h.Kind == HealthKind.CameraMoved ? "moved" : "unclear")} {ShiftText().Match(h.Text).Value} at {h.TimeUs / 1e6:F1} s")));
                Failures.Add($"{session.Name}{(isKnown ? ", screen known" : "")}: {truth}; said: {(said.Length > 0 ? said : "nothing")}");
            }
        }

        public void Write(string row, StudyTable table)
        {
            _afterS.Sort();
            table.Add(row, _sessions, new Proportion(_false, _sessions), new Proportion(_named, _moving), new Proportion(_right, _moving),
                _afterS.Count == 0 ? double.NaN : _afterS[_afterS.Count / 2], _afterS.Count == 0 ? double.NaN : _afterS[^1], _unclear);
        }

        public bool HasSessions => _sessions > 0;

        /// <summary>The displacement that a text gives in brackets; none for a turn.</summary>
        private static Vector2D Shift(string text)
        {
            Match match = ShiftText().Match(text);
            return match.Success ? new Vector2D(Number(match.Groups[1].Value), Number(match.Groups[2].Value)) : default;
        }

        private static double Number(string text) => double.Parse(text, CultureInfo.InvariantCulture);

        [GeneratedRegex(@"\(([-+]?[0-9.]+), ([-+]?[0-9.]+)\)")]
        private static partial Regex ShiftText();
    }
}
