using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Patterns
{
    public sealed class CheckerboardFinderTests
    {
        private BoardView _view = null!;

        [SetUp]
        public void SetUp() => _view = new BoardView(BoardView.NineBySix);

        [TearDown]
        public void TearDown() => _view.Dispose();

        [TestCase(9, 6)]
        [TestCase(6, 9)]
        [TestCase(8, 5)]
        [TestCase(4, 3)]
        [TestCase(13, 8)]
        public void TryFind_CleanPicturesOfAnyPose_GivesEveryCornerInOrder(int columns, int rows)
        {
            using var view = new BoardView(new BoardSize(columns, rows));
            var random = new Random(columns * 100 + rows);
            for (int i = 0; i < 8; i++)
            {
                view.Place(0.7 * (random.NextDouble() - 0.5), 0.7 * (random.NextDouble() - 0.5), 2 * Math.PI * random.NextDouble());
                view.Paint();
                Assert.That(view.TryFind(), Is.True, "pose " + i + ": " + view.Reason);
                Assert.That(view.Reason, Is.Empty);
                Assert.That(view.WorstPx, Is.LessThan(0.05), "pose " + i);
            }
        }

        [TestCase(0.95, 0)]
        [TestCase(0, -0.95)]
        [TestCase(0.7, 0.6)]
        [TestCase(-0.7, 0.6)]
        public void TryFind_BoardSeenFromTheSide_GivesEveryCornerInOrder(double tiltXRad, double tiltYRad)
        {
            for (int i = 0; i < 6; i++)
            {
                _view.Place(tiltXRad, tiltYRad, 0.5 * i, 1.1);
                _view.Paint();
                Assert.That(_view.TryFind(), Is.True, "turn " + i + ": " + _view.Reason);
                Assert.That(_view.WorstPx, Is.LessThan(0.15), "turn " + i);
            }
        }

        [TestCase(1.0, 2.0, 0.10)]
        [TestCase(1.0, 6.0, 0.25)]
        [TestCase(2.0, 2.0, 0.20)]
        [TestCase(3.0, 2.0, 0.45)]
        public void TryFind_BlurAndNoise_FindsTheBoardAndLosesLittle(double blurPx, double noise, double worstPx)
        {
            _view.Board.BlurPx = blurPx;
            _view.Board.Noise = noise;
            for (int i = 0; i < 6; i++)
            {
                _view.Board.Seed = i;
                _view.Place(0.25 - 0.1 * i, 0.35 - 0.12 * i, 0.5 * i);
                _view.Paint();
                Assert.That(_view.TryFind(), Is.True, "pose " + i + ": " + _view.Reason);
                Assert.That(_view.WorstPx, Is.LessThan(worstPx), "pose " + i);
            }
        }

        [TestCase(0.85, 25, 215)]
        [TestCase(0.0, 8, 34)]
        [TestCase(0.6, 100, 130)]
        public void TryFind_UnevenOrFaintLight_FindsTheBoard(double slope, double dark, double light)
        {
            _view.Board.LightSlope = slope;
            _view.Board.Dark = dark;
            _view.Board.Light = light;
            _view.Board.Noise = 1;
            _view.Paint(20);
            Assert.That(_view.TryFind(), Is.True, _view.Reason);
            Assert.That(_view.WorstPx, Is.LessThan(0.25));
        }

        [Test]
        public void TryFind_ReflexThatLeavesTheEdgesVisible_FindsTheBoard()
        {
            _view.Paint();
            _view.Board.Light = 150;
            _view.Board.GlareCenterPx = _view.Truth[22];
            _view.Board.Glare = 90;
            _view.Paint();
            Assert.That(_view.TryFind(), Is.True, _view.Reason);
            Assert.That(_view.WorstPx, Is.LessThan(0.05));
        }

        [Test]
        public void TryFind_ReflexThatBurnsCornersOut_SaysHowManyAreMissing()
        {
            _view.Paint();
            _view.Board.GlareCenterPx = _view.Truth[22];
            _view.Board.GlareRadiusPx = 12;
            _view.Board.Glare = 900;
            _view.Paint();
            Assert.That(_view.TryFind(), Is.False);
            Assert.That(_view.Reason, Does.Match("^9×6 corners found, 9×6 asked for; [0-9]+ of the 9×6 are hidden"));
        }

        [Test]
        public void TryFind_HalfTheBoardOutside_SaysWhatIsSeen()
        {
            _view.Place(0, 0, 0);
            _view.Shift(9.8, 0);
            _view.Paint();
            Assert.That(_view.TryFind(), Is.False);
            Assert.That(_view.Reason, Does.Match("^[4-6]×6 corners found, 9×6 asked for.*; the board reaches the picture's edge$"));
        }

        [TestCase(8, 6, "9×6 corners found, 8×6 asked for")]
        [TestCase(9, 5, "9×6 corners found, 9×5 asked for")]
        [TestCase(10, 7, "9×6 corners found, 10×7 asked for")]
        [TestCase(4, 4, "9×6 corners found, 4×4 asked for")]
        [TestCase(5, 9, "6×9 corners found, 5×9 asked for")]
        public void TryFind_AnotherSizeAskedFor_SaysWhatIsThere(int columns, int rows, string reason)
        {
            _view.Paint();
            Assert.That(_view.TryFind(new BoardSize(columns, rows)), Is.False);
            Assert.That(_view.Reason, Is.EqualTo(reason));
        }

        [Test]
        public void TryFind_AskedTheOtherWayRound_GivesTheSameCornersInColumns()
        {
            _view.Paint();
            Assert.That(_view.TryFind(), Is.True);
            var turned = new Vector2D[54];
            Assert.That(_view.Finder.TryFind(_view.Picture, new BoardSize(6, 9), turned, out string reason), Is.True, reason);
            Assert.That(turned, Is.EquivalentTo(_view.Corners));
            AssertClockwise(turned, 6);
        }

        [Test]
        public void TryFind_MirroredPicture_IsABoardReadClockwise()
        {
            _view.Paint();
            using var mirrored = new Image();
            mirrored.Reset(PixelFormat.Gray8, BoardView.Width, BoardView.Height, 0);
            for (int y = 0; y < BoardView.Height; y++)
            for (int x = 0; x < BoardView.Width; x++)
                mirrored.Bytes[y * mirrored.Stride + x] = _view.Picture.Bytes[y * _view.Picture.Stride + BoardView.Width - 1 - x];
            Assert.That(_view.TryFind(mirrored), Is.True, _view.Reason);
            AssertClockwise(_view.Corners, 9);
            for (int row = 0; row < 6; row++)
            for (int column = 0; column < 9; column++)
            {
                Vector2D expected = _view.Truth[(5 - row) * 9 + column], found = _view.Corners[row * 9 + column];
                Assert.That((found - new Vector2D(BoardView.Width - 1 - expected.X, expected.Y)).Length, Is.LessThan(0.05));
            }
        }

        [TestCase(8, 6)]
        [TestCase(7, 5)]
        [TestCase(6, 6)]
        [TestCase(5, 5)]
        public void TryFind_BoardThatHalfATurnDoesNotChange_StartsWithTheColumnThatRunsDown(int columns, int rows)
        {
            using var view = new BoardView(new BoardSize(columns, rows));
            for (int i = 0; i < 8; i++)
            {
                view.Place(0.1, 0.2, 0.3 + i * Math.PI / 4);
                view.Paint();
                Assert.That(view.TryFind(), Is.True, view.Reason);
                AssertClockwise(view.Corners, columns);
                Vector2D column = view.Corners[(rows - 1) * columns] - view.Corners[0];
                Assert.That(column.Y, Is.GreaterThan(0), "turn " + i);
                if (columns == rows && columns % 2 == 0)
                    Assert.That(column.Y, Is.GreaterThan(Math.Abs(column.X)), "turn " + i);
            }
        }

        [Test]
        public void TryFind_TwoBoardsInClutter_GivesTheOneAskedFor()
        {
            using var other = new BoardView(new BoardSize(5, 4));
            other.Place(0.1, 0.1, -0.2, 0.45);
            other.Shift(-5.2, 3.2);
            _view.Place(0.2, -0.2, 0.15, 0.62);
            _view.Shift(2.4, -1.1);
            HostilePictures.Clutter(_view.Picture, BoardView.Width, BoardView.Height, 3);
            _view.PaintOver();
            other.Picture.CopyFrom(_view.Picture);
            other.PaintOver();
            Assert.That(_view.TryFind(other.Picture), Is.True, _view.Reason);
            Assert.That(_view.WorstPx, Is.LessThan(0.1));
            Assert.That(other.TryFind(), Is.True, other.Reason);
            Assert.That(other.WorstPx, Is.LessThan(0.15));
        }

        [TestCase(PixelFormat.Bgra32)]
        [TestCase(PixelFormat.Nv12)]
        [TestCase(PixelFormat.Yuy2)]
        [TestCase(PixelFormat.Infrared16)]
        [TestCase(PixelFormat.Gray8)]
        public void TryFind_EveryFormatWithPaddedRows_GivesTheSameCorners(PixelFormat format)
        {
            _view.Paint();
            using var picture = new Image();
            TestPlanes.Fill(picture, _view.Picture, format, 64);
            Assert.That(_view.TryFind(picture), Is.True, _view.Reason);
            Assert.That(_view.WorstPx, Is.LessThan(0.05));
        }

        [Test]
        public void TryFind_OddPartOfThePicture_GivesTheSameCorners()
        {
            _view.Place(0.2, 0.2, 0.1, 0.8);
            _view.Paint();
            using var part = new Image();
            part.Reset(PixelFormat.Gray8, 397, 295, 0, 411);
            for (int y = 0; y < part.Height; y++)
                _view.Picture.Bytes.Slice((y + 3) * _view.Picture.Stride + 1, part.Width).CopyTo(part.Bytes.Slice(y * part.Stride));
            Assert.That(_view.TryFind(part), Is.True, _view.Reason);
            for (int i = 0; i < 54; i++)
                Assert.That((_view.Corners[i] + new Vector2D(1, 3) - _view.Truth[i]).Length, Is.LessThan(0.05));
        }

        [TestCaseSource(typeof(HostilePictures), nameof(HostilePictures.Names))]
        public void TryFind_PictureWithoutABoard_IsRefused(string name)
        {
            using var picture = new Image();
            HostilePictures.Draw(name, picture);
            foreach (BoardSize size in new[] { new BoardSize(9, 6), new BoardSize(4, 3), new BoardSize(3, 3) })
            {
                Assert.That(_view.Finder.TryFind(picture, size, new Vector2D[size.Count], out string reason), Is.False, name + " " + size);
                Assert.That(reason, Does.Contain(size + " ").And.Not.Contain("\n"));
            }
        }

        [Test]
        public void TryFind_EverySmallSize_IsRefused()
        {
            using var picture = new Image();
            var corners = new Vector2D[9];
            for (int height = 1; height < 24; height++)
            for (int width = 1; width < 24; width++)
            {
                picture.Reset(PixelFormat.Gray8, width, height, 0);
                for (int i = 0; i < picture.SizeBytes; i++)
                    picture.Bytes[i] = (byte)((i % width / 5 + i / width / 5) % 2 * 255);
                Assert.That(_view.Finder.TryFind(picture, new BoardSize(3, 3), corners, out _), Is.False, width + "×" + height);
            }
        }

        [Test]
        public void TryFind_ArgumentsThatMakeNoSense_Throw()
        {
            using var picture = new Image();
            var corners = new Vector2D[54];
            Assert.Throws<ArgumentException>(() => _view.Finder.TryFind(picture, BoardView.NineBySix, corners, out _));
            picture.Reset(PixelFormat.Depth16, 64, 64, 0);
            Assert.Throws<ArgumentException>(() => _view.Finder.TryFind(picture, BoardView.NineBySix, corners, out _));
            _view.Paint();
            Assert.Throws<ArgumentException>(() => _view.Finder.TryFind(_view.Picture, BoardView.NineBySix, new Vector2D[53], out _));
            Assert.Throws<ArgumentException>(() => _view.Finder.TryFind(_view.Picture, default, corners, out _));
        }

        [Test]
        public void TryFind_Warm_AllocatesNothing()
        {
            _view.Paint();
            _view.TryFind();
            Assert.That(Allocation.Of(() => _view.Finder.TryFind(_view.Picture, BoardView.NineBySix, _view.Corners, out _)), Is.Zero);
        }

        private static void AssertClockwise(Vector2D[] corners, int columns) =>
            Assert.That(Vector2D.Cross(corners[1] - corners[0], corners[columns] - corners[0]), Is.GreaterThan(0));
    }
}
