using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Host.Scoring;

namespace LaserTracking.Host.Studies.Clips
{
    /// <summary>Adds up how one case did over several clips.</summary>
    internal sealed class ClipTally
    {
        private readonly List<double> _errorsPx = new();
        private readonly List<string> _missed = new();
        private readonly List<string> _false = new();
        private int _shots;
        private int _rightColor;
        private int _firstFrame;

        public static string[] Columns { get; } = { "case", "found", "false", "colour right", "in first frame", "error px median", "p95" };

        public void Add(TruthClip clip, IReadOnlyList<ReportedShot> shots, Func<TruthShot, string> whyNot)
        {
            int[] taken = ShotMatcher.Match(clip, shots);
            _shots += clip.Shots.Count;
            for (int i = 0; i < taken.Length; i++)
            {
                ReportedShot reported = shots[i];
                if (taken[i] < 0)
                {
                    _false.Add(FormattableString.Invariant($"{clip.File} frame {reported.Frame} at {reported.PositionPx.X:F0},{reported.PositionPx.Y:F0} ({reported.Confidence:F2})"));
                    continue;
                }

                TruthShot shot = clip.Shots[taken[i]];
                _errorsPx.Add(ShotMatcher.DistancePx(shot, reported));
                if (shot.Color == null || shot.Color == reported.Color)
                    _rightColor++;
                if (reported.Frame <= shot.FirstVisibleFrame)
                    _firstFrame++;
            }

            foreach (int i in Enumerable.Range(0, clip.Shots.Count).Where(i => !taken.Contains(i)))
                _missed.Add(FormattableString.Invariant($"{clip.Shots[i].Id} frame {clip.Shots[i].FirstVisibleFrame} at {clip.Shots[i].PlacesPx[0].X:F0},{clip.Shots[i].PlacesPx[0].Y:F0}: {whyNot(clip.Shots[i])}"));
        }

        public void Write(string name, StudyTable table)
        {
            double[] sorted = _errorsPx.OrderBy(e => e).ToArray();
            double At(double share) => sorted.Length == 0 ? double.NaN : sorted[(int)(share * (sorted.Length - 1))];
            table.Add(name, new Proportion(_shots - _missed.Count, _shots), _false.Count, _rightColor, _firstFrame, At(0.5), At(0.95));
            if (_missed.Count > 0)
                table.Notes.Add(name + ", missed: " + string.Join("; ", _missed));
            if (_false.Count > 0)
                table.Notes.Add(name + ", false: " + string.Join("; ", _false));
        }
    }
}
