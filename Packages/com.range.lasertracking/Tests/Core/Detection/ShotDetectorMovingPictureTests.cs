using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Simulation;
using LaserTracking.Tracking;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    /// <summary>Projected pictures that move, content unknown: what the projector can show is no shot, what it cannot show is one.</summary>
    public sealed class ShotDetectorMovingPictureTests
    {
        [TestCase(0.5)]
        [TestCase(1)]
        [TestCase(1.5)]
        [TestCase(2)]
        [TestCase(3)]
        [Category("Long")]
        public void Process_RimmedHeadComesFromBehindAnother_IsNoShot(double pxPerFrame)
        {
            foreach (int height in new[] { 6, 8, 11 })
            {
                var run = new DetectionRun();
                run.Play(0, 60, (b, i) => Head(b, 152 - Math.Max(0, i - 12) * pxPerFrame, height));
                Assert.That(run.Shots, Is.Empty, "height " + height);
            }
        }

        [TestCase(true)]
        [TestCase(false)]
        public void Process_FlashOnAMovingTarget_IsFoundWhereItIs(bool isGreen)
        {
            var run = new DetectionRun();
            run.Play(0, 30, (b, i) =>
            {
                Emerging(b, 140 - 3 * i, 100);
                if (i != 20)
                    return;
                if (isGreen)
                    b.GreenDot(88, 107, 1.5, 0.4);
                else
                    b.RedDot(88, 107, 1.5, 0.4);
            });
            Assert.That(run.Shots.Count, Is.EqualTo(1));
            Assert.That(run.Shots[0].FirstFrameIndex, Is.EqualTo(20));
            Assert.That((run.Shots[0].Dot.PositionPx - new Geometry.Vector2D(88, 107)).Length, Is.LessThan(1));
            Assert.That(run.Shots[0].Dot.Color, Is.EqualTo(isGreen ? LaserColor.Green : LaserColor.Red));
        }

        [Test]
        public void Process_LaserHeldOnWhileTargetsPassUnderIt_IsOneShot()
        {
            var run = new DetectionRun();
            run.Play(0, 90, (b, i) =>
            {
                Emerging(b, 160 - 2 * i, 100);
                if (i >= 20 && i < 70)
                    b.RedDot(100 + 0.4 * Math.Sin(i), 107 + 0.4 * Math.Cos(1.3 * i), 1.5, 0.4);
            });
            Assert.That(run.Shots.Count, Is.EqualTo(1));
        }

        [Test]
        [Category("Long")]
        public void Process_SimulatedMovingTargetsWithoutShots_GiveNoShot()
        {
            Assert.That(Simulate(new SimulationScenario { Seed = 5, DurationS = 8 }, out _), Is.Empty);
        }

        [TestCase(4)]
        [TestCase(8)]
        [Category("Long")]
        public void Process_SimulatedMovingTargetsInACompressedPicture_GiveNoShot(int seed)
        {
            var scenario = new SimulationScenario { Seed = seed, DurationS = 3 };
            scenario.Projector.Brightness = 0.42;
            scenario.ColorCamera.Format = Imaging.PixelFormat.Nv12;
            scenario.ColorCamera.JpegQuality = 74;
            scenario.ColorCamera.Gain = 0.55;
            scenario.ColorCamera.BlurPx = 0.5;
            Assert.That(Simulate(scenario, out _, 960), Is.Empty);
        }

        [Test]
        [Category("Long")]
        public void Process_SimulatedShotsOnMovingTargets_AreFound()
        {
            var scenario = new SimulationScenario { Seed = 6, DurationS = 6 };
            scenario.Shooters.Add(new ShooterSettings());
            string[] moving = { "Popper 3", "Paper 2", "Silhouette 2", "No-shoot 1" };
            for (int i = 0; i < 12; i++)
                scenario.Shots.Add(new ShotSettings { TimeS = 1 + 0.4 * i, Shooter = 1, PulseMs = 60, Target = moving[i % 4] });
            List<Shot> shots = Simulate(scenario, out SimulationTruth truth);
            Assert.That(shots.Count, Is.EqualTo(12));
            for (int i = 0; i < 12; i++)
            {
                Assert.That(shots[i].FirstFrameIndex, Is.InRange(truth.Shots[i].FirstFrame, truth.Shots[i].LastFrame), "shot " + i);
                Assert.That((shots[i].Dot.PositionPx - truth.Shots[i].FirstLightPx).Length, Is.LessThan(5), "shot " + i);
            }
        }

        /// <summary>A white target with a red rim slides to the left from behind a brown one; white elsewhere says how bright white is.</summary>
        private static void Emerging(FrameBuilder b, int left, int top) => b.Wall(50, 50, 50)
            .Box(20, 20, 40, 40, 190, 200, 205)
            .Box(left, top, 30, 40, 45, 40, 150)
            .Box(left + 1, top + 1, 28, 38, 190, 200, 205)
            .Box(140, 70, 90, 100, 40, 60, 90);

        /// <summary>A white head with a red rim in the corner between head and shoulder of the brown target that hides the rest of it.</summary>
        private static void Head(FrameBuilder b, double left, int height)
        {
            const float Rim = 1.5f;
            b.Wall(50, 50, 50).Box(20, 20, 40, 40, 190, 200, 205);
            for (int x = (int)left - 1; x < left + 30; x++)
            {
                // What the outline covers of a column of pixels, and what the white inside it does.
                float outline = (float)Math.Min(1, Math.Max(0, x + 1 - left)), white = (float)Math.Min(1, Math.Max(0, x + 1 - left - Rim));
                float blue = 50 + outline * -5 + white * 145, green = 50 + outline * -10 + white * 160, red = 50 + outline * 100 + white * 55;
                b.Box(x, 100 - height, 1, 40, blue, green, red);
                b.Box(x, 100 - height, 1, 1, 50 - 5 * outline, 50 - 10 * outline, 50 + 100 * outline);
            }

            b.Box(152, 100 - height - 6, 25, 40, 60, 100, 140).Box(110, 100, 100, 90, 60, 100, 140);
        }

        private static List<Shot> Simulate(SimulationScenario scenario, out SimulationTruth truth, int width = 640)
        {
            scenario.ColorCamera.Width = width;
            scenario.ColorCamera.Height = width * 9 / 16;
            scenario.DepthCamera.Enabled = false;
            var range = new SimulatedRange(scenario, SimulationScenes.Default());
            truth = range.Truth;
            var detector = new ShotDetector();
            var tracker = new ShotTracker();
            var detections = new Detections();
            var shots = new List<Shot>();
            using (IFrameSource source = range.CreateColorSource())
            using (var frame = new Frame())
            {
                while (source.TryRead(frame))
                {
                    detector.Process(frame, detections);
                    tracker.Process(detections);
                    shots.AddRange(tracker.Shots.ToArray());
                }
            }

            return shots;
        }
    }
}
