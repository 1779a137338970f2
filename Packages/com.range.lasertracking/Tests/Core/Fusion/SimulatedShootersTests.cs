using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Simulation;
using LaserTracking.Tracking;
using NUnit.Framework;

namespace LaserTracking.Fusion
{
    /// <summary>Depth pictures of a simulated range through hands and fusion; the dots come from the truth.</summary>
    public sealed class SimulatedShootersTests
    {
        [Test]
        [Category("Long")]
        public void Fuse_TwoShootersSideBySide_NearlyAllRightAndNoneWrong()
        {
            var scenario = new SimulationScenario { Name = "two shooters", Seed = 301, DurationS = 20 };
            scenario.Generator.ShotsPerMinute = 40;
            scenario.Shooters.Add(Shooter(-0.35, HandSide.Right, false, LaserColor.Green));
            scenario.Shooters.Add(Shooter(0.35, HandSide.Left, true, LaserColor.Green));
            var range = new SimulatedRange(scenario, SimulationScenes.Default());
            var named = new List<(int True, int Said)>();
            Run(range, named);
            var votes = new int[3, 3];
            int known = 0, right = 0;
            foreach ((int fired, int said) in named)
            {
                known += said > 0 ? 1 : 0;
                Assert.That(said, Is.LessThanOrEqualTo(2), "two people, two numbers");
                votes[said, fired]++;
            }

            for (int said = 1; said <= 2; said++)
                right += System.Math.Max(votes[said, 1], votes[said, 2]);
            Assert.That(named.Count, Is.GreaterThan(15));
            Assert.That(right, Is.GreaterThanOrEqualTo(0.9 * named.Count), $"{right} right of {named.Count}, {known - right} wrong");
            Assert.That(known - right, Is.Zero, "wrong");
        }

        private static ShooterSettings Shooter(double offsetXM, HandSide hand, bool twoHanded, LaserColor color)
        {
            var shooter = new ShooterSettings { OffsetXM = offsetXM, Hand = hand, TwoHanded = twoHanded };
            shooter.Laser.Color = color;
            return shooter;
        }

        private static void Run(SimulatedRange range, List<(int True, int Said)> named)
        {
            HandCamera camera = range.Calibration.HandCamera!;
            var tracker = new DepthHandTracker(camera);
            var fusion = new ShooterAssignment(camera);
            var hands = new HandObservations();
            using IFrameSource source = range.CreateDepthSource();
            using var frame = new Frame();
            bool hasFrame = source.TryRead(frame);
            foreach (TrueShot shot in range.Truth.Shots)
            {
                if (shot.FirstFrame < 0)
                    continue;
                long timeUs = range.Truth.ColorClockUs(range.Truth.ColorFrameTimeUs(shot.FirstFrame));
                while (hasFrame && frame.TimeUs <= timeUs)
                {
                    tracker.Process(frame, hands);
                    fusion.AddHands(hands);
                    hasFrame = source.TryRead(frame);
                }

                Vector2D place = shot.ScreenM;
                foreach (TrueDot dot in range.Truth.DotsOf(shot.FirstFrame))
                {
                    if (dot.ShotId == shot.Id)
                        place = range.Calibration.Screen.ToScreenM(dot.PositionPx);
                }

                FusedShot fused = fusion.Fuse(new Shot { TimeUs = timeUs, Dot = new Dot { Color = shot.Color } }, place);
                named.Add((shot.Shooter, fused.Shooter));
            }
        }
    }
}
