using System;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Simulation;
using NUnit.Framework;

namespace LaserTracking.Patterns
{
    public sealed class ScreenPatternFinderTests
    {
        private static readonly Vector2D[] Keystone = { new Vector2D(52, 40), new Vector2D(418, 68), new Vector2D(402, 290), new Vector2D(75, 268) };

        [Test]
        public void Find_BothBoards_LieWhereTheyWereDrawn()
        {
            using var view = new ProjectedView(480, 320, Keystone);
            ScreenPatternView seen = view.Look(0, 1, 2, 3);
            Assert.That((seen.First.Length, seen.Second.Length, seen.CellsDown, seen.IsMirrored), Is.EqualTo((120, 144, 9, false)));
            AssertPlaces(view, seen.First, 118, 0.12);
            AssertPlaces(view, seen.Second, 140, 0.12);
        }

        [TestCase(1)]
        [TestCase(2)]
        [TestCase(3)]
        [Category("Long")]
        public void Find_TurnedProjector_KeepsIdentities(int quarterTurns)
        {
            Vector2D[] corners = { new Vector2D(30, 20), new Vector2D(350, 20), new Vector2D(350, 340), new Vector2D(30, 340) };
            using var view = new ProjectedView(380, 360, corners.Select((_, i) => corners[(i + quarterTurns) % 4]).ToArray());
            ScreenPatternView seen = view.Look(0, 1, 2, 3);
            Assert.That(seen.IsMirrored, Is.False);
            AssertPlaces(view, seen.First, 110, 0.2);
        }

        [Test]
        public void Find_ThroughTheBackOfTheScreen_IsMirrored()
        {
            using var view = new ProjectedView(480, 320, Keystone[1], Keystone[0], Keystone[3], Keystone[2]);
            ScreenPatternView seen = view.Look(0, 1, 2, 3);
            Assert.That(seen.IsMirrored, Is.True);
            AssertPlaces(view, seen.First, 118, 0.12);
        }

        [TestCase(1, 0, 3, 2)]
        [TestCase(2, 3, 0, 1)]
        [TestCase(0, 0, 1, 1, 2, 2, 3, 3)]
        [Category("Long")]
        public void Find_InAnyOrder_FindsBoth(params int[] pictures)
        {
            using var view = new ProjectedView(480, 320, Keystone);
            ScreenPatternView seen = view.Look(pictures);
            AssertPlaces(view, seen.First, 115, 0.15);
            AssertPlaces(view, seen.Second, 135, 0.15);
        }

        [TestCase(0)]
        [TestCase(1)]
        public void Find_SinglePicture_WillDo(int picture)
        {
            using var view = new ProjectedView(480, 320, Keystone);
            AssertPlaces(view, view.Look(picture).First, 110, 0.2);
        }

        [Test]
        public void Find_RoomFullOfThings_CancelsThem()
        {
            using var view = new ProjectedView(480, 320, Keystone)
            {
                // Posters with checks of their own, a window, a lamp's spot.
                Room = (x, y) => 20 + ((x / 13 + y / 11 & 1) != 0 ? 50 : 0) + 60 * Math.Exp(-((x - 150) * (x - 150) + (y - 90) * (y - 90)) / 5000.0),
            };
            ScreenPatternView seen = view.Look(0, 1, 2, 3);
            AssertPlaces(view, seen.First, 115, 0.15);
            AssertPlaces(view, seen.Second, 135, 0.15);
        }

        [Test]
        public void Find_SomebodyInFront_IsLeftOutAndSaid()
        {
            using var view = new ProjectedView(480, 320, Keystone) { IsHidden = (x, y) => Math.Abs(x - 240) < 40 && y > 110 };
            ScreenPatternView seen = view.Look(0, 1, 2, 3);
            AssertPlaces(view, seen.First, 85, 0.15);
            foreach (ScreenPoint point in seen.First.Concat(seen.Second))
            {
                Vector2D px = view.ToImagePx(point.Place);
                if (Math.Abs(px.X - 240) < 34 && px.Y > 116)
                    Assert.That(point.State, Is.Not.EqualTo(ScreenPointState.Measured), px.ToString());
            }
        }

        [Test]
        public void Find_ScreenPartlyOutOfThePicture_KnowsWhatLiesOutside()
        {
            using var view = new ProjectedView(300, 320, Keystone);
            ScreenPatternView seen = view.Look(0, 1, 2, 3);
            AssertPlaces(view, seen.First, 60, 0.15);
            Assert.That(seen.First.Where(p => view.ToImagePx(p.Place).X > 300).Select(p => p.State), Is.All.EqualTo(ScreenPointState.OutOfPicture));
        }

        [Test]
        [Category("Long")]
        public void Find_CameraMovedBetweenPictures_SaysHowFar()
        {
            using var before = new ProjectedView(480, 320, Keystone);
            using var after = new ProjectedView(480, 320, Keystone.Select(c => c + new Vector2D(6, -3)).ToArray());
            using var finder = new ScreenPatternFinder();
            for (int i = 0; i < 3; i++)
                finder.Add(before.Draw(i));
            finder.Add(after.Draw(3));
            Vector2D moved = finder.Find().MovedPx;
            Assert.That(moved.Length, Is.EqualTo(new Vector2D(6, -3).Length).Within(1));
            Assert.That(before.Look(0, 1, 2, 3).MovedPx.Length, Is.LessThan(0.1));
        }

        [Test]
        public void Find_NoPattern_FindsNone()
        {
            using var finder = new ScreenPatternFinder();
            using var image = new Image();
            var random = new Random(3);
            for (int i = 0; i < 4; i++)
            {
                image.Reset(PixelFormat.Gray8, 320, 200, 0);
                for (int k = 0; k < image.Bytes.Length; k++)
                    image.Bytes[k] = (byte)(k % 320 / 20 + k / 6400 + i & 1) == 0 ? (byte)random.Next(40, 60) : (byte)random.Next(120, 140);
                finder.Add(image);
            }

            ScreenPatternView seen = finder.Find();
            Assert.That((seen.First.Length, seen.Second.Length, seen.CellsDown), Is.EqualTo((0, 0, 0)), "a plain checkerboard is not ours");
        }

        [Test]
        public void Add_OtherSizesAndFormats_AreLeftOut()
        {
            using var finder = new ScreenPatternFinder();
            using var image = new Image();
            Assert.That(finder.Find().CellsDown, Is.Zero, "without any frame");
            Assert.That(finder.Add(image), Is.False);
            foreach ((PixelFormat format, int width, int height, bool isTaken) in new[]
            {
                (PixelFormat.Gray8, 63, 64, false), (PixelFormat.Depth16, 64, 64, false), (PixelFormat.Nv12, 66, 64, true), (PixelFormat.Yuy2, 66, 64, true),
                (PixelFormat.Bgra32, 66, 64, true), (PixelFormat.Bgra32, 66, 65, false), (PixelFormat.Infrared16, 66, 64, false),
            })
            {
                image.Reset(format, width, height, 0);
                image.Bytes.Clear();
                Assert.That(finder.Add(image), Is.EqualTo(isTaken), format + " " + width);
            }

            Assert.That(finder.Find().CellsDown, Is.Zero);
        }

        [Test]
        [Category("Long")]
        public void Find_SimulatedRoomWithLensAndPerson_CalibratesWithinAMillimetre()
        {
            var scenario = new SimulationScenario { Seed = 4, DurationS = 0.5 };
            scenario.DepthCamera.Enabled = false;
            scenario.Projector.Content = ProjectedContent.Calibration;
            scenario.Projector.PatternHoldMs = 120;
            scenario.Projector.Width = 640;
            scenario.Projector.Height = 360;
            scenario.ColorCamera.Width = 640;
            scenario.ColorCamera.Height = 360;
            scenario.ColorCamera.LensK1 = -0.15;
            scenario.Room.Obstacles.Add(new ObstacleSettings { TopM = new Vector2D(1.1, 1.0) });
            var range = new SimulatedRange(scenario, SimulationScenes.Default());
            using var finder = new ScreenPatternFinder();
            using var frame = new Capture.Frame();
            using Capture.IFrameSource source = range.CreateColorSource();
            while (source.TryRead(frame))
                finder.Add(frame.Color);
            ScreenCalibration found = new ScreenCalibrator(range.Scene.ScreenSizeM, 5).Calibrate(finder.Find());
            Assert.That(found.Refusals, Is.Empty);
            Assert.That(found.IsLensFound, Is.True);
            for (int i = 0; i < 35; i++)
            {
                var place = new Vector2D(i % 7 * 3.2 / 6, i / 7 * 1.8 / 4);
                Vector2D px = range.Calibration.Screen.ToImagePx(place);
                Assert.That((found.Screen!.ToScreenM(px) - place).Length * 1000, Is.LessThan(2), place.ToString());
            }
        }

        private static void AssertPlaces(ProjectedView view, ScreenPoint[] points, int least, double tolerancePx)
        {
            ScreenPoint[] measured = points.Where(p => p.State == ScreenPointState.Measured).ToArray();
            Assert.That(measured, Has.Length.GreaterThanOrEqualTo(least));
            double[] off = measured.Select(p => (p.ImagePx - view.ToImagePx(p.Place)).Length).OrderBy(d => d).ToArray();
            Assert.That(off[off.Length / 2], Is.LessThan(tolerancePx / 2));
            Assert.That(off[off.Length - 1], Is.LessThan(3 * tolerancePx));
        }
    }
}
