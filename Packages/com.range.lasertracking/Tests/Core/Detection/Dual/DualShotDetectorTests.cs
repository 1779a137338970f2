using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed class DualShotDetectorTests
    {
        [Test]
        public void Process_DefectivePixel_IsTooSmall()
        {
            var run = new DualRun();
            run.Play(2, (r, i) => r.Wall(60).InfraredBox(150, 150, 1, 1, 4000));
            Assert.That(run.Detections.Dots.Length, Is.Zero);
            Assert.That(run.Rejected.Exists(r => r.Reason == RejectionReason.TooSmall && r.Value == 1 && r.Limit == 3), Is.True);
        }

        [TestCase(40, 40)]
        [TestCase(60, 3)]
        [TestCase(3, 60)]
        public void Process_BrightThingInInfrared_IsNoDot(int width, int height)
        {
            var run = new DualRun();
            run.Play(2, (r, i) => r.Wall(60).InfraredBox(100, 100, width, height, 800));
            Assert.That(run.Detections.Dots.Length, Is.Zero);
            Assert.That(run.Rejected, Is.Not.Empty);
        }

        [Test]
        public void Process_DotOutsideTheScreen_IsRejectedForIt()
        {
            var run = new DualRun();
            run.Detector.SetScreenPolygon(new[] { new Vector2D(0, 0), new Vector2D(300, 0), new Vector2D(300, 359), new Vector2D(0, 359) });
            run.Play(5, (r, i) => r.Wall(60).GreenInBoth(400, 200));
            Assert.That(run.Shots, Is.Empty);
            Assert.That(run.WasRejected(RejectionReason.OutsideScreen, 400, 200), Is.True);
        }

        [Test]
        public void Process_InfraredMissingInSomeFrames_DotAtRestStaysFound()
        {
            var run = new DualRun();
            run.Play(4, (r, i) => r.Wall(60).GreenInBoth(200, 150));
            run.HasInfrared = false;
            for (int frame = 0; frame < 10; frame++)
            {
                run.Play(1, (r, i) => r.Wall(60).GreenInBoth(200, 150));
                Assert.That(run.Detections.Dots.Length, Is.EqualTo(1));
            }

            Assert.That(run.Shots.Count, Is.EqualTo(1));
        }

        [Test]
        public void Process_InfraredAlone_GivesInfraredPixelsAndAnUnknownColor()
        {
            var run = new DualRun { HasColor = false };
            run.Play(1, (r, i) => r.Wall(60).Infrared(200, 150));
            Assert.That(run.Detections.ImageWidthPx, Is.EqualTo(DualRun.Side));
            Assert.That(run.Detections.Dots.Length, Is.EqualTo(1));
            Assert.That((run.Detections.Dots[0].PositionPx - DualRun.ToInfrared(200, 150)).Length, Is.LessThan(0.1));
            Assert.That(run.Detections.Dots[0].Color, Is.EqualTo(LaserColor.Unknown));
        }

        [Test]
        public void Process_FrameWithoutAnyPicture_NamesNone()
        {
            var run = new DualRun { HasColor = false, HasInfrared = false };
            run.Play(1, (r, i) => r.Wall(60));
            Assert.That(run.Detections.ImageWidthPx, Is.Zero);
        }

        [Test]
        public void Process_PlaneHomography_CarriesPositionAndDoubt()
        {
            // The infrared camera sees a field shifted by 40 colour pixels.
            var shift = new Homography(new double[] { 2, 0, 40.5, 0, 1.125, 0.0625, 0, 0, 1 });
            var run = new DualRun(null, InfraredMapping.OfPlane(shift));
            run.Play(1, (r, i) => r.Wall(60).Infrared(200, 150));
            Dot dot = run.Detections.Dots[0];
            Assert.That((dot.PositionPx - new Vector2D(240, 150)).Length, Is.LessThan(0.2));
            Assert.That(dot.CovariancePx.Sigma, Is.InRange(0.5, 3));
        }

        [Test]
        public void Process_DotOverTexture_IsInfraredWhateverColorSaysThere()
        {
            var run = new DualRun();
            run.Play(2, (r, i) =>
            {
                r.Wall(60).Infrared(300, 200);
                r.Color.Box(303, 0, 200, 360, 200, 200, 60);
            });
            Assert.That(run.Detections.Dots.Length, Is.EqualTo(1));
            Assert.That(run.Detections.Dots[0].Color, Is.EqualTo(LaserColor.Infrared));
        }

        [Test]
        public void Process_TwoInfraredSpotsBesideOneGreenLight_DoNotShareIt()
        {
            var run = new DualRun(new DualDetectorSettings { MatchRadiusPx = 60 });
            run.Play(1, (r, i) => r.Wall(60).GreenInBoth(200, 150).Infrared(214, 150));
            Assert.That(run.Detections.Dots.Length, Is.EqualTo(2));
            Assert.That((run.Detections.Dots[0].PositionPx - run.Detections.Dots[1].PositionPx).Length, Is.EqualTo(14).Within(1));
            Assert.That(run.Detections.Dots[0].Color, Is.Not.EqualTo(run.Detections.Dots[1].Color));
        }

        [Test]
        public void Process_WithoutSearchingColor_OnlyInfraredSpotsCount()
        {
            var run = new DualRun(new DualDetectorSettings { SearchesColor = false });
            run.Play(6, (r, i) =>
            {
                r.Wall(60).GreenInBoth(200, 150);
                r.Color.GreenDot(400, 250, 1.5, 0.3);
            });
            Assert.That(run.Detections.Dots.Length, Is.EqualTo(1));
            Assert.That(run.Detections.Dots[0].PositionPx.X, Is.EqualTo(200).Within(1));
        }

        [Test]
        public void Process_GreenThingThatMoves_IsNoDotAtRest()
        {
            var run = new DualRun { HasInfrared = false };
            run.Play(40, (r, i) => r.Wall(60).Color.Box(40 + 6 * i, 100, 5, 5, 40, 250, 40));
            Assert.That(run.Shots.Count, Is.LessThanOrEqualTo(1));
        }

        [Test]
        public void Process_ThousandsOfBrightSpots_AreBoundedAndSaidSo()
        {
            var run = new DualRun();
            run.Play(1, (r, i) =>
            {
                r.Wall(60);
                for (int y = 4; y < DualRun.Side - 4; y += 20)
                {
                    for (int x = 4; x < DualRun.Side - 4; x += 20)
                        r.InfraredBox(x, y, 2, 2, 500);
                }
            });
            Assert.That(run.Detections.OverflowCount, Is.GreaterThan(0));
        }

        [Test]
        public void Process_OddAndTinySizes_AreRead()
        {
            foreach (int side in new[] { 1, 2, 7, 9, 33 })
            {
                var run = new DualRun();
                var image = new Imaging.Image();
                image.Reset(PixelFormat.Infrared16, side, side, 0);
                image.Bytes.Fill(255);
                run.Frame.Begin(0, 0);
                run.Frame.Infrared.CopyFrom(image);
                run.Frame.Color.Reset(PixelFormat.Bgra32, side, side, 0);
                run.Frame.Color.Bytes.Clear();
                for (int frame = 0; frame < 5; frame++)
                    Assert.DoesNotThrow(() => run.Detector.Process(run.Frame, run.Detections));
            }
        }

        [Test]
        public void Process_SizesThatChangeInMidStream_StartAfresh()
        {
            var run = new DualRun();
            run.Play(3, (r, i) => r.Wall(60).GreenInBoth(200, 150));
            using var other = new Capture.Frame();
            var builder = new FrameBuilder(320, 180);
            for (int i = 3; i < 8; i++)
            {
                builder.Wall(60, 60, 60).GreenDot(100, 70, 1.5, 0.5).Write(other, i, i * 33_333L, PixelFormat.Nv12);
                run.Detector.Process(other, run.Detections);
            }

            Assert.That(run.Detections.ImageWidthPx, Is.EqualTo(320));
            Assert.That(run.Detections.Dots.Length, Is.EqualTo(1));
            Assert.That((run.Detections.Dots[0].PositionPx - new Vector2D(100, 70)).Length, Is.LessThan(0.5));
        }

        [Test]
        public void Process_WarmFrameLoop_AllocatesNothing()
        {
            var run = new DualRun();
            run.Play(10, (r, i) => r.Wall(60).GreenInBoth(200, 150).Infrared(300, 100));
            Assert.That(Allocation.Of(() => run.Detector.Process(run.Frame, run.Detections)), Is.Zero);
        }

        [TestCase(double.NaN)]
        [TestCase(0)]
        [TestCase(1e9)]
        public void Constructor_SettingOutsideItsRange_IsRefusedByName(double value)
        {
            ArgumentException? error = Assert.Throws<ArgumentException>(() => new DualShotDetector(new DualDetectorSettings { MinInfraredRise = value }));
            Assert.That(error!.Message, Does.Contain(nameof(DualDetectorSettings.MinInfraredRise)));
        }
    }
}
