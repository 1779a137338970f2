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
            _truth = range.Truth;
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
                foreach (TrackedDot tracked in _tracker.Dots)
                {
                    if ((tracked.Dot.PositionPx - dot.PositionPx).Length > DotTolerancePx)
                        continue;
                    DotsSeen++;
                    break;
                }
            }
        }

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
            wrong = match.Count(m => m < 0);
            found = match.Count(m => m >= 0 && peaks[seen[m].Id] >= minPeak);
            all = seen.Count(s => peaks[s.Id] >= minPeak);
        }
    }
}
