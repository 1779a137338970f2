using System;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    /// <summary>What the published dual filter is said to do, on drawn pictures as it was tested on.</summary>
    public sealed class DualFilterBehaviourTests
    {
        private static void ExpectDot(DualRun run, double x, double y, LaserColor color, double within = 1)
        {
            foreach (Dot dot in run.Detections.Dots)
            {
                if (dot.Color == color && (dot.PositionPx - new Vector2D(x, y)).Length <= within)
                    return;
            }

            string found = "";
            foreach (Dot dot in run.Detections.Dots)
                found += dot.Color + " " + dot.PositionPx + "; ";
            Assert.Fail($"no {color} dot at ({x}, {y}), but: {found}");
        }

        [Test]
        public void Process_DotThatWasThereFromTheBeginning_IsFoundInTheFirstFrame()
        {
            var run = new DualRun();
            run.Play(1, (r, i) => r.Wall(60).GreenInBoth(211.3, 150.7));
            ExpectDot(run, 211.3, 150.7, LaserColor.Green);
            Assert.That(run.Detections.Dots[0].IsConclusive, Is.True);
        }

        [Test]
        public void Process_DotAtRest_StaysFoundInEveryFrameAndIsOneShot()
        {
            var run = new DualRun();
            for (int frame = 0; frame < 60; frame++)
            {
                run.Play(1, (r, i) => r.Wall(60).GreenInBoth(211.3, 150.7));
                Assert.That(run.Detections.Dots.Length, Is.EqualTo(1), "frame " + frame);
            }

            Assert.That(run.Shots.Count, Is.EqualTo(1));
        }

        [Test]
        public void Process_GreenDotAtRestThatInfraredDoesNotShow_IsFoundInColorAlone()
        {
            var run = new DualRun();
            run.Play(3, (r, i) => r.Wall(60).Color.GreenDot(211.3, 150.7));
            ExpectDot(run, 211.3, 150.7, LaserColor.Green, 0.3);
            Assert.That(run.Shots.Count, Is.EqualTo(1));
        }

        [Test]
        public void Process_EmitterThatOnlyInfraredShows_IsInfrared()
        {
            var run = new DualRun();
            run.Play(2, (r, i) => r.Wall(60).Infrared(211.3, 150.7));
            ExpectDot(run, 211.3, 150.7, LaserColor.Infrared);
        }

        [TestCase("red", 60, 80, 900)]
        [TestCase("blue", 900, 60, 60)]
        [TestCase("white", 600, 600, 600)]
        [TestCase("yellow", 40, 700, 700)]
        public void Process_LightOfAnotherColor_IsRejectedForIt(string name, double blue, double green, double red)
        {
            var run = new DualRun();
            run.Play(5, (r, i) =>
            {
                r.Wall(60).Infrared(400, 200);
                r.Color.Dot(400, 200, 1.5, blue, green, red);
            });
            Assert.That(run.Detections.Dots.Length, Is.Zero, name);
            Assert.That(run.Shots, Is.Empty);
            Assert.That(run.WasRejected(RejectionReason.WrongColor, 400, 200), Is.True);
        }

        [TestCase("red", 60, 80, 900)]
        [TestCase("blue", 900, 60, 60)]
        [TestCase("white", 600, 600, 600)]
        [TestCase("yellow", 40, 700, 700)]
        public void Process_FlashOfAnotherColor_IsNoShot(string name, double blue, double green, double red)
        {
            var run = new DualRun();
            run.Play(6, (r, i) => r.Wall(60));
            run.Play(2, (r, i) => r.Wall(60).Color.Dot(400, 200, 1.5, blue, green, red));
            run.Play(4, (r, i) => r.Wall(60));
            Assert.That(run.Shots, Is.Empty, name);
        }

        [TestCase(30)]
        [TestCase(60)]
        [TestCase(100)]
        [TestCase(150)]
        [TestCase(200)]
        public void Process_AmbientLevel_DoesNotHideTheDot(double level)
        {
            var run = new DualRun();
            run.Play(2, (r, i) => r.Wall(level).GreenInBoth(333.4, 99.6));
            Assert.That(run.Detections.Dots.Length, Is.EqualTo(1));
            ExpectDot(run, 333.4, 99.6, LaserColor.Green);
        }

        [TestCase(30)]
        [TestCase(100)]
        [TestCase(200)]
        public void Process_AmbientLevel_DoesNotHideADotOfColorAlone(double level)
        {
            var run = new DualRun();
            run.Play(3, (r, i) => r.Wall(level).Color.GreenDot(333.4, 99.6, 1.5, 0.3));
            Assert.That(run.Detections.Dots.Length, Is.EqualTo(1));
            ExpectDot(run, 333.4, 99.6, LaserColor.Green);
        }

        [TestCase(30)]
        [TestCase(100)]
        [TestCase(200)]
        public void Process_EmptyWall_ShowsNothing(double level)
        {
            var run = new DualRun();
            for (int frame = 0; frame < 30; frame++)
            {
                run.Play(1, (r, i) => r.Wall(level));
                Assert.That(run.Detections.Dots.Length, Is.Zero);
                Assert.That(run.Detections.OverflowCount, Is.Zero, "noise makes no candidates");
            }
        }

        [TestCase(1, true)]
        [TestCase(3, true)]
        [TestCase(10, true)]
        [TestCase(10, false)]
        public void Process_SeveralDotsAtOnce_AreAllFound(int count, bool isGreen)
        {
            var run = new DualRun();
            Vector2D At(int i) => new Vector2D(60.3 + 53 * i, 60.8 + 61 * (i * 3 % 5));
            run.Play(1, (r, frame) =>
            {
                r.Wall(80);
                for (int i = 0; i < count; i++)
                {
                    if (isGreen)
                        r.GreenInBoth(At(i).X, At(i).Y);
                    else
                        r.Infrared(At(i).X, At(i).Y);
                }
            });
            Assert.That(run.Detections.Dots.Length, Is.EqualTo(count));
            for (int i = 0; i < count; i++)
                ExpectDot(run, At(i).X, At(i).Y, isGreen ? LaserColor.Green : LaserColor.Infrared);
        }

        [Test]
        public void Process_DotBesideARedLight_IsTheOnlyOneFound()
        {
            var run = new DualRun();
            run.Play(4, (r, i) =>
            {
                r.Wall(60).GreenInBoth(200, 150).Infrared(300, 150);
                r.Color.RedDot(300, 150, 1.5, 0.3);
            });
            Assert.That(run.Detections.Dots.Length, Is.EqualTo(1));
            ExpectDot(run, 200, 150, LaserColor.Green);
        }

        [Test]
        public void Process_DotThatMoves_IsFollowedAsOne()
        {
            var run = new DualRun();
            for (int frame = 0; frame < 20; frame++)
            {
                double x = 100 + 9.3 * frame, y = 200 - 4.1 * frame;
                run.Play(1, (r, i) => r.Wall(60).GreenInBoth(x, y));
                ExpectDot(run, x, y, LaserColor.Green);
            }

            Assert.That(run.Shots.Count, Is.EqualTo(1));
        }

        [Test]
        public void Process_DotThatGoesOut_IsGoneInThatFrame()
        {
            var run = new DualRun();
            run.Play(10, (r, i) => r.Wall(60).GreenInBoth(200, 150));
            run.Play(1, (r, i) => r.Wall(60));
            Assert.That(run.Detections.Dots.Length, Is.Zero);
        }

        [Test]
        public void Process_GreenFlashThatInfraredDoesNotShow_IsReportedInItsFirstFrame()
        {
            var run = new DualRun();
            run.Play(6, (r, i) => r.Wall(60));
            run.Play(1, (r, i) => r.Wall(60).Color.GreenDot(251.4, 177.2));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
            Assert.That(run.Shots[0].Dot.Color, Is.EqualTo(LaserColor.Green));
            Assert.That((run.Shots[0].Dot.PositionPx - new Vector2D(251.4, 177.2)).Length, Is.LessThan(0.3));
        }

        [Test]
        public void Process_FlashInBothPictures_IsOneShot()
        {
            var run = new DualRun();
            run.Play(6, (r, i) => r.Wall(60));
            run.Play(3, (r, i) => r.Wall(60).GreenInBoth(251.4, 177.2));
            run.Play(3, (r, i) => r.Wall(60));
            Assert.That(run.Shots.Count, Is.EqualTo(1));
        }

        [Test]
        public void Process_WhiteWallLightWithoutInfrared_IsNoDot()
        {
            var run = new DualRun();
            run.Play(20, (r, i) => r.Wall(60).Color.Dot(400, 200, 2, 600, 600, 600));
            Assert.That(run.Shots, Is.Empty);
        }

        [Test]
        public void Process_StrongInfraredAmbient_InSixteenBits_DoesNotHideTheDot()
        {
            var run = new DualRun { InfraredNoise = 60 };
            run.Play(2, (r, i) => r.Wall(100).InfraredBox(0, 0, DualRun.Side, DualRun.Side, 30000).Infrared(300, 200, 9000));
            ExpectDot(run, 300, 200, LaserColor.Infrared);
        }
    }
}
