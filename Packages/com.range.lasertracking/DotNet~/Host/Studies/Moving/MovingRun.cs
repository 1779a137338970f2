using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Host.Scoring;
using LaserTracking.Simulation;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Studies.Moving
{
    /// <summary>One detector over one simulated session: its shots, and how often the resting dots were seen.</summary>
    internal sealed class MovingRun
    {
        /// <summary>A tracked dot within this of the true one is that dot, px at 640.</summary>
        private const double DotTolerancePx = 4;

        private readonly SimulationTruth _truth;
        private readonly ShotDetector _detector;
        private readonly ShotTracker _tracker = new();
        private readonly Detections _detections = new();

        public MovingRun(SimulatedRange range, ExpectedView? expected)
        {
            _truth = range.Truth; _ex = expected;
            _detector = new ShotDetector(null, expected);
            _detector.SetScreenPolygon(range.Calibration.Screen.CornersPx);
        }

        public List<ReportedShot> Shots { get; } = new();

        public int DotsSeen { get; private set; }

        public int DotsShown { get; private set; }

        /// <summary>Frames after the quiet beginning, and those of them in which the expected view was relied on.</summary>
        public int Frames { get; private set; }

        public int TrustedFrames { get; private set; }

        /// <summary>Largest difference between measured and true delay while it was relied on, µs.</summary>
        public double WorstDelayErrorUs { get; private set; }

        public void Process(Frame frame, double trueDelayUs)
        {
            _detector.Process(frame, _detections);
            _tracker.Process(_detections);
            if (Environment.GetEnvironmentVariable("DBG") != null && _detections.Prediction == PredictionState.Trusted)
            foreach (Shot shot in _tracker.Shots)
            {
                bool isTrue = false;
                foreach (TrueDot dot in _truth.DotsOf(shot.FirstFrameIndex)) isTrue |= (dot.PositionPx - shot.Dot.PositionPx).Length < 6;
                if (isTrue) continue;
                foreach (Candidate c in _detector.Candidates)
                    if (Math.Abs(c.CenterX - shot.Dot.PositionPx.X) < 6 && Math.Abs(c.CenterY - shot.Dot.PositionPx.Y) < 6)
                        Console.Error.WriteLine(FormattableString.Invariant($"DBG {frame.Index} ({c.CenterX:F0},{c.CenterY:F0}) exp={c.IsAboveExpected} plane={c.Plane} rise={c.PeakRise} rel={c.PeakRelativeRise} area={c.Area} comp={c.Compactness:F2} el={c.LongSigma/c.ShortSigma:F1} ring={c.RingShare:F2} ringl={c.RingLevel:F2} concl={c.IsConclusive} reason={c.Reason} viv={c.Vividness:F2} gc={c.GreenCoherence:F2} {Dump(frame, c)}"));
            }
            foreach (Shot shot in _tracker.Shots)
                Shots.Add(new ReportedShot(shot.FrameIndex, shot.Dot.PositionPx, null));
            if (_truth.ColorFrameTimeUs(frame.Index) < MovingScenario.QuietS * 1e6)
                return;
            Frames++;
            if (_detections.Prediction == PredictionState.Trusted)
            {
                TrustedFrames++;
                WorstDelayErrorUs = Math.Max(WorstDelayErrorUs, Math.Abs(_detections.PredictedDelayUs!.Value - trueDelayUs));
            }

            foreach (TrueDot dot in _truth.DotsOf(frame.Index))
            {
                // The frames in which the light goes on and off show it for part of their exposure only.
                TrueShot shot = _truth.Shots[dot.ShotId - 1];
                if (frame.Index == shot.FirstFrame || frame.Index == shot.LastFrame)
                    continue;
                DotsShown++;
                int was = DotsSeen;
                foreach (TrackedDot tracked in _tracker.Dots)
                {
                    if ((tracked.Dot.PositionPx - dot.PositionPx).Length > DotTolerancePx)
                        continue;
                    DotsSeen++;
                    break;
                }
                if (was == DotsSeen && Environment.GetEnvironmentVariable("DBG") != null && _ex != null)
                {
                    Console.Error.WriteLine(FormattableString.Invariant($"LOST {frame.Index} at ({dot.PositionPx.X:F0},{dot.PositionPx.Y:F0}) peak {dot.Peak:F2} state {_detections.Prediction}"));
                    foreach (Candidate c in _detector.Candidates)
                        if (Math.Abs(c.CenterX - dot.PositionPx.X) < 12 && Math.Abs(c.CenterY - dot.PositionPx.Y) < 12)
                            Console.Error.WriteLine(FormattableString.Invariant($"  C ({c.CenterX:F0},{c.CenterY:F0}) exp={c.IsAboveExpected} rise={c.PeakRise} rel={c.PeakRelativeRise} area={c.Area} comp={c.Compactness:F2} el={c.LongSigma/c.ShortSigma:F1} ring={c.RingShare:F2} concl={c.IsConclusive} reason={c.Reason} {c.Value:F1} {Dump(frame, c)}"));
                }
            }
        }

        private unsafe string Dump(Frame f, Candidate c)
        {
            if (_ex == null) return "";
            return _ex.Dump(c.SeedX, c.SeedY, (((uint*)f.Color.Pixels)[c.SeedY * f.Color.Width + c.SeedX]));
        }
        private ExpectedView? _ex;

        /// <summary>Counts found and false shots; flashes between two exposures or too faint for any detector are nobody's.</summary>
        public void Score(int width, double minPeak, out int found, out int all, out int wrong)
        {
            var places = new Dictionary<int, List<Vector2D>>();
            var peaks = new Dictionary<int, double>();
            for (int frame = 0; frame < _truth.ColorFrameCount; frame++)
            {
                foreach (TrueDot dot in _truth.DotsOf(frame))
                {
                    if (!places.TryGetValue(dot.ShotId, out List<Vector2D>? list))
                        places[dot.ShotId] = list = new List<Vector2D>();
                    list.Add(dot.PositionPx);
                    peaks[dot.ShotId] = Math.Max(peaks.GetValueOrDefault(dot.ShotId), dot.Peak);
                }
            }

            TrueShot[] seen = _truth.Shots.Where(s => s.FirstFrame >= 0).ToArray();
            var clip = new TruthClip("", width, seen.Select(s => new TruthShot(s.Id.ToString(System.Globalization.CultureInfo.InvariantCulture), null, s.FirstFrame, s.LastFrame, places[s.Id])).ToList());
            int[] match = ShotMatcher.Match(clip, Shots);
            if (Environment.GetEnvironmentVariable("DBG") != null)
                for (int i = 0; i < seen.Length; i++)
                    if (!match.Contains(i) && peaks[seen[i].Id] >= minPeak) Console.Error.WriteLine(FormattableString.Invariant($"MISS frames {seen[i].FirstFrame}-{seen[i].LastFrame} at {seen[i].FirstLightPx} peak {peaks[seen[i].Id]:F2} {seen[i].Color}"));
            wrong = match.Count(m => m < 0);
            found = match.Count(m => m >= 0 && peaks[seen[m].Id] >= minPeak);
            all = seen.Count(s => peaks[s.Id] >= minPeak);
        }
    }
}
