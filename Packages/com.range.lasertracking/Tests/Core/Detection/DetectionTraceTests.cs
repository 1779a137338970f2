using System;
using System.Collections.Generic;
using System.Text;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Simulation;
using LaserTracking.Tracking;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed class DetectionTraceTests
    {
        [Test]
        public void Trace_OfDrawnFrames_GivesEveryRejectionItsFailedTest()
        {
            var reasons = new SortedSet<RejectionReason>();
            var detector = new ShotDetector { Trace = new DetectionTrace() };
            var run = new DetectionRun(detector);
            var random = new Random(3);
            for (int i = 0; i < 80; i++)
            {
                run.Play(i, 1, (b, n) => Draw(b, n, random));
                Check(detector.Trace, run.Detections, reasons);
            }

            Assert.That(reasons, Is.SupersetOf(new[] { RejectionReason.TooFaint, RejectionReason.TooLarge, RejectionReason.NotIsolated, RejectionReason.CutByEdge }));
        }

        [Test]
        public void Trace_OfTheSimulatedRange_GivesEveryRejectionItsFailedTest()
        {
            SimulationScenario scenario = SimulationExamples.Small(3);
            scenario.Generator.ShotsPerMinute = 200;
            var range = new SimulatedRange(scenario, SimulationScenes.Default());
            var detector = new ShotDetector { Trace = new DetectionTrace() };
            detector.SetScreenPolygon(range.Calibration.Screen.CornersPx);
            var detections = new Detections();
            var reasons = new SortedSet<RejectionReason>();
            int dots = 0;
            using (IFrameSource source = range.CreateColorSource())
            using (var frame = new Frame())
            {
                while (source.TryRead(frame))
                {
                    detector.Process(frame, detections);
                    Check(detector.Trace, detections, reasons);
                    dots += detections.Dots.Length;
                }
            }

            Assert.That(dots, Is.GreaterThan(5));
            Assert.That(reasons, Is.Not.Empty);
        }

        [Test]
        public void Trace_OrNone_FindsTheSame()
        {
            Assert.That(Transcript(new DetectionTrace()), Is.EqualTo(Transcript(null)));
        }

        [Test]
        public void Trace_WithASpot_AllocatesNothing()
        {
            var detector = new ShotDetector { Trace = new DetectionTrace { Spot = new SpotTrace(new Vector2D(100, 100)) } };
            var run = new DetectionRun(detector);
            var frames = new Frame[6];
            for (int i = 0; i < frames.Length; i++)
            {
                frames[i] = new Frame();
                Draw(run.Builder, i, new Random(i));
                run.Builder.Write(frames[i], i, i * run.IntervalUs);
            }

            Assert.That(Allocation.Of(() =>
            {
                foreach (Frame frame in frames)
                    detector.Process(frame, run.Detections);
            }), Is.EqualTo(0));
        }

        [Test]
        public void Trace_MoreCandidatesThanRoom_CountsThem()
        {
            var trace = new DetectionTrace(2);
            var run = new DetectionRun(new ShotDetector { Trace = trace });
            run.Play(0, 8, (b, i) => b.Wall(40, 40, 40));
            run.Play(8, 1, (b, i) => b.Wall(40, 40, 40).GreenDot(40, 40).GreenDot(120, 40).GreenDot(200, 40).GreenDot(40, 120).GreenDot(120, 120));
            Assert.That(trace.Candidates.Length, Is.EqualTo(2));
            Assert.That(trace.OverflowCount, Is.GreaterThanOrEqualTo(3));
            Assert.Throws<ArgumentOutOfRangeException>(() => new DetectionTrace(0));
        }

        [Test]
        public void Spot_WhereNothingRises_HasAColdTile()
        {
            SpotTrace spot = Look(new Vector2D(40, 200), out _);
            Assert.That(spot.IsSearched, Is.True);
            Assert.That(spot.IsLit, Is.False);
            Assert.That(spot.Smallest.IsTileExamined, Is.False);
            Assert.That(spot.Smallest.TileOnset, Is.LessThanOrEqualTo(spot.Smallest.TileGate));
        }

        [Test]
        public void Spot_OnADot_SeesItsRiseAndThatItIsLit()
        {
            SpotTrace spot = Look(new Vector2D(101, 119), out Dot dot);
            Assert.That(spot.IsLit, Is.True);
            Assert.That(spot.Smallest.IsTileExamined, Is.True);
            Assert.That(spot.Smallest.Rise, Is.GreaterThan(0.8));
            Assert.That((spot.Smallest.PeakPx - dot.PositionPx).Length, Is.LessThan(3));
            int middle = spot.Radius * spot.Side + spot.Radius;
            Assert.That(spot.Now[middle] & 0xFF00, Is.GreaterThan(spot.Before[middle] & 0xFF00));
            Assert.That(spot.Rise(true)[middle], Is.GreaterThan(150));
            Assert.That(spot.Envelope(true)[middle], Is.InRange(80, 110));
        }

        [TestCase(-5, 0)]
        [TestCase(double.NaN, 0)]
        public void Spot_NoPlace_IsRefused(double x, double y) => Assert.Throws<ArgumentException>(() => new SpotTrace(new Vector2D(x, y)));

        [Test]
        public void Spot_OutsideThePicture_SeesNothing()
        {
            var detector = new ShotDetector { Trace = new DetectionTrace { Spot = new SpotTrace(new Vector2D(5000, 5000)) } };
            new DetectionRun(detector).Play(0, 6, (b, i) => b.Wall(90, 100, 110));
            Assert.That(detector.Trace.Spot!.Smallest.Level, Is.EqualTo(0));
            Assert.That(detector.Trace.Spot.Largest.IsTileExamined, Is.False);
        }

        private static SpotTrace Look(Vector2D at, out Dot dot)
        {
            var spot = new SpotTrace(at);
            var run = new DetectionRun(new ShotDetector { Trace = new DetectionTrace { Spot = spot } });
            run.Play(0, 8, (b, i) => b.Wall(90, 100, 110));
            run.Play(8, 1, (b, i) => b.Wall(90, 100, 110).GreenDot(100, 120));
            dot = run.Detections.Dots[0];
            return spot;
        }

        /// <summary>Things that move, sparks, faint and strong dots, streaks, a dot at the edge.</summary>
        private static void Draw(FrameBuilder b, int i, Random random)
        {
            b.Wall(90, 100, 110).Box(5 * i % 300, 30, 40, 50, 230, 230, 230);
            for (int n = 0; n < 8; n++)
                b.Box(random.Next(320), random.Next(120, 240), 1 + random.Next(3), 1 + random.Next(3), 160, 160, 160);
            if (i % 9 == 0)
                b.GreenDot(20 + random.Next(280), 100 + random.Next(120), 2, 0.02 + random.NextDouble());
            if (i % 11 == 0)
                b.GreenStreak(200, 200, 230, 215);
            if (i % 13 == 0)
                b.GreenDot(0, 150, 4, 0.1);
        }

        private static void Check(DetectionTrace trace, Detections detections, SortedSet<RejectionReason> reasons)
        {
            Assert.That(trace.FrameIndex, Is.EqualTo(detections.FrameIndex));
            int dots = 0;
            foreach (ExaminedCandidate candidate in trace.Candidates)
            {
                int failures = CheckTests(trace.TestsOf(candidate), candidate);
                if (candidate.Reason == RejectionReason.None)
                {
                    Assert.That(failures, Is.EqualTo(0));
                    Assert.That(detections.Dots[candidate.DotIndex].PositionPx, Is.EqualTo(candidate.PositionPx));
                    dots++;
                    continue;
                }

                reasons.Add(candidate.Reason);
                Assert.That(failures, Is.InRange(1, 2), "one test fails, and a fading light may be named instead");
            }

            Assert.That(dots, Is.EqualTo(detections.Dots.Length));
            foreach (RejectedCandidate rejected in detections.Rejected)
            {
                Assert.That(rejected.Reason, Is.Not.EqualTo(RejectionReason.None));
                Assert.That(double.IsNaN(rejected.Value) || double.IsInfinity(rejected.Value) || double.IsNaN(rejected.Limit), Is.False, rejected.Reason.ToString());
            }
        }

        [Test]
        public void Trace_OfAWeighedDot_GivesEveryFeatureAndTheirSum()
        {
            var trace = new DetectionTrace();
            var run = new DetectionRun(new ShotDetector { Trace = trace });
            run.Play(0, 8, (b, i) => b.Wall(90, 100, 110));
            run.Play(8, 1, (b, i) => b.Wall(90, 100, 110).GreenDot(100, 120));
            ExaminedCandidate dot = default;
            foreach (ExaminedCandidate candidate in trace.Candidates)
                dot = candidate.DotIndex == 0 ? candidate : dot;
            ReadOnlySpan<TestOutcome> evidence = trace.EvidenceOf(dot);
            Assert.That(evidence.Length, Is.EqualTo(Enum.GetValues(typeof(DotFeature)).Length));
            double sum = trace.BaseLogOdds;
            foreach (TestOutcome feature in evidence)
                sum += feature.LogOdds;
            TestOutcome last = default;
            foreach (TestOutcome test in trace.TestsOf(dot))
                last = test.IsEvidence ? test : last;
            Assert.That(last.Value, Is.EqualTo(sum).Within(1e-6));
            Assert.That(last.Limit, Is.EqualTo(new ShotDetectorSettings().MinLogOdds - CandidateJudge.NewLightLogOdds), "in a calm picture what no displacement explains counts, too");
            Assert.That(evidence[(int)DotFeature.Freshness].Value, Is.EqualTo(1).Within(0.3));
        }

        private static int CheckTests(ReadOnlySpan<TestOutcome> tests, in ExaminedCandidate candidate)
        {
            int failures = 0;
            TestOutcome last = default;
            foreach (TestOutcome test in tests)
            {
                Assert.That(test.What, Is.Not.Empty);
                if (!double.IsNaN(test.Limit))
                {
                    bool isMet = test.IsMinimum ? test.Value >= test.Limit : test.Value <= test.Limit;
                    Assert.That(test.IsPassed, Is.EqualTo(isMet), test.What + " " + test.Value + " against " + test.Limit);
                }

                if (test.Reason == RejectionReason.None || test.IsPassed)
                    continue;
                failures++;
                last = test;
            }

            Assert.That(last.Reason, Is.EqualTo(candidate.Reason));
            if (candidate.Reason != RejectionReason.None)
            {
                Assert.That(last.Value, Is.EqualTo(candidate.Value));
                Assert.That(last.Limit, Is.EqualTo(candidate.Limit));
            }

            return failures;
        }

        private static string Transcript(DetectionTrace? trace)
        {
            var run = new DetectionRun(new ShotDetector { Trace = trace });
            var random = new Random(5);
            var text = new StringBuilder();
            for (int i = 0; i < 30; i++)
            {
                run.Play(i, 1, (b, n) => Draw(b, n, random));
                foreach (Dot dot in run.Detections.Dots)
                    text.Append(dot.PositionPx).Append(dot.Confidence).Append(dot.IsConclusive).Append('\n');
                foreach (RejectedCandidate rejected in run.Detections.Rejected)
                    text.Append(rejected.PositionPx).Append(rejected.Reason).Append(rejected.Value).Append('\n');
            }

            foreach (Shot shot in run.Shots)
                text.Append(shot.Id).Append(shot.FrameIndex).Append('\n');
            return text.ToString();
        }
    }
}
