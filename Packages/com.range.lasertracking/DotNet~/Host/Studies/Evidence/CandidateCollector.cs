using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Host.Scoring;

namespace LaserTracking.Host.Studies.Evidence
{
    /// <summary>Runs the detector over one recording and keeps what it weighed; says afterwards, from the truth, what each one was.</summary>
    internal sealed class CandidateCollector
    {
        private const double DotPx = 5;
        private const double NearPx = 40;

        /// <summary>Before and after a shot what is near it is neither a dot nor none.</summary>
        private const int FramesBefore = 1;
        private const int FramesAfter = 3;

        /// <summary>What was lit before is judged by memory, not by evidence.</summary>
        private const float MinFreshness = 0.5f;

        /// <summary>Curves learned from fainter ones too found fewer shots on the clips: what is faint and no dot is too much like what is.</summary>
        private static readonly float MinRise = (float)new ShotDetectorSettings().FaintRise;

        private readonly ShotDetector _detector = new() { Trace = new DetectionTrace() };
        private readonly Detections _detections = new();
        private readonly List<(int Frame, Vector2D PositionPx, float[] Features, double LogOdds)> _weighed = new();

        /// <summary>What the features are called and are reasons for, in the order of <see cref="DotFeature"/>; empty before the first candidate.</summary>
        public TestOutcome[] Measures { get; private set; } = [];

        /// <param name="frame">The next frame.</param>
        /// <param name="shiftPx">By how much its picture was displaced on purpose; taken off again.</param>
        public void Process(Frame frame, Vector2D shiftPx)
        {
            _detector.Process(frame, _detections);
            DetectionTrace trace = _detector.Trace!;
            foreach (ExaminedCandidate candidate in trace.Candidates)
            {
                ReadOnlySpan<TestOutcome> evidence = trace.EvidenceOf(candidate);
                if (evidence.IsEmpty || evidence[(int)DotFeature.Freshness].Value < MinFreshness || evidence[(int)DotFeature.Rise].Value < MinRise)
                    continue;
                var features = new float[evidence.Length];
                double logOdds = trace.BaseLogOdds;
                for (int i = 0; i < features.Length; i++)
                {
                    features[i] = (float)evidence[i].Value;
                    logOdds += evidence[i].LogOdds;
                }

                if (Measures.Length == 0)
                    Measures = evidence.ToArray();
                _weighed.Add((frame.Index, candidate.PositionPx - shiftPx, features, logOdds));
            }
        }

        /// <param name="caseIndex">Where it comes from.</param>
        /// <param name="group">Its clip or simulation.</param>
        /// <param name="shots">The true ones.</param>
        /// <param name="neither">Shots too weak to be seen: what lies near them is left out.</param>
        public IEnumerable<WeighedCandidate> Label(int caseIndex, int group, IReadOnlyList<TruthShot> shots, IReadOnlyList<TruthShot> neither)
        {
            foreach ((int frame, Vector2D at, float[] features, double logOdds) in _weighed)
            {
                int nearest = -1;
                double distance = DotPx;
                for (int i = 0; i < shots.Count; i++)
                {
                    double away = shots[i].FirstVisibleFrame <= frame && frame <= shots[i].LastVisibleFrame ? Distance(shots[i], at) : double.PositiveInfinity;
                    if (away >= distance)
                        continue;
                    distance = away;
                    nearest = i;
                }

                if (nearest < 0 && shots.Concat(neither).Any(s => frame >= s.FirstVisibleFrame - FramesBefore && frame <= s.LastVisibleFrame + FramesAfter && Distance(s, at) < NearPx))
                    continue;
                CandidateLabel label = nearest < 0 ? CandidateLabel.NoDot : shots[nearest].FirstVisibleFrame == frame ? CandidateLabel.FirstDot : CandidateLabel.LaterDot;
                yield return new WeighedCandidate(caseIndex, group, label, nearest, features, logOdds);
            }
        }

        private static double Distance(TruthShot shot, Vector2D at) => shot.PlacesPx.Min(place => (place - at).Length);
    }
}
