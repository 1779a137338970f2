using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Patterns
{
    public sealed class SaddlePointFinderTests
    {
        private readonly SaddlePointFinder _finder = new SaddlePointFinder();
        private readonly Image _picture = new Image();

        [OneTimeTearDown]
        public void TearDown() => _picture.Dispose();

        [TestCase(40.0, 35.0, 0.0, 1.5708)]
        [TestCase(40.3, 35.8, 0.4, 1.9)]
        [TestCase(39.5, 34.5, 0.9, 1.6)]
        [TestCase(41.7, 36.1, 2.2, 3.0)]
        public void Find_TwoCrossingEdges_GivesPlaceEdgesAndContrast(double x, double y, double angleA, double angleB)
        {
            DrawCrossing(new Vector2D(x, y), angleA, angleB, 60, 180);
            ReadOnlySpan<SaddlePoint> points = _finder.Find(_picture);
            Assert.That(points.Length, Is.EqualTo(1));
            SaddlePoint point = points[0];
            Assert.That((point.PositionPx - new Vector2D(x, y)).Length, Is.LessThan(0.3));
            Assert.That(Math.Abs(Vector2D.Cross(point.EdgeA, Direction(angleA))), Is.LessThan(0.12));
            Assert.That(Math.Abs(Vector2D.Cross(point.EdgeB, Direction(angleB))), Is.LessThan(0.12));
            Assert.That(Vector2D.Cross(point.EdgeA, point.EdgeB), Is.GreaterThan(0));
            Assert.That(point.Contrast, Is.InRange(60, 120));
            Assert.That(point.Quality, Is.GreaterThan(0.97));
        }

        [Test]
        public void Find_LightAndDarkExchanged_ExchangesTheEdges()
        {
            DrawCrossing(new Vector2D(40, 35), 0.3, 1.7, 60, 180);
            SaddlePoint one = _finder.Find(_picture)[0];
            DrawCrossing(new Vector2D(40, 35), 0.3, 1.7, 180, 60);
            SaddlePoint other = _finder.Find(_picture)[0];
            Assert.That(Math.Abs(Vector2D.Cross(one.EdgeA, other.EdgeB)), Is.LessThan(0.05));
            Assert.That(Math.Abs(Vector2D.Cross(one.EdgeB, other.EdgeA)), Is.LessThan(0.05));
        }

        [Test]
        public void Find_EdgesLinesSpotsAndLoneSquares_AreNoSaddles()
        {
            _picture.Reset(PixelFormat.Gray8, 160, 120, 0);
            _picture.Bytes.Fill(200);
            for (int y = 0; y < 120; y++)
            for (int x = 0; x < 160; x++)
            {
                bool isDark = (x > 20 && x < 50 && y > 20 && y < 50)
                    || (x - 100) * (x - 100) + (y - 35) * (y - 35) < 300
                    || (y > 80 && y < 84)
                    || x + y > 240;
                if (isDark)
                    _picture.Bytes[y * _picture.Stride + x] = 20;
            }

            Assert.That(_finder.Find(_picture).Length, Is.Zero);
        }

        [Test]
        public void Find_Board_GivesEveryCornerAmongItsPoints()
        {
            using var view = new BoardView(BoardView.NineBySix);
            view.Paint();
            var points = new List<SaddlePoint>(_finder.Find(view.Picture).ToArray());
            foreach (Vector2D corner in view.Truth)
                Assert.That(points.Exists(point => (point.PositionPx - corner).Length < 0.5), Is.True, corner.ToString());
        }

        [Test]
        public void TryFindNear_PlaceBesideACorner_FindsItWithinReachOnly()
        {
            DrawCrossing(new Vector2D(40, 35), 0.3, 1.7, 100, 104);
            Assert.That(_finder.Find(_picture).Length, Is.Zero, "too faint to be found unasked");
            Assert.That(_finder.TryFindNear(new Vector2D(41.5, 34), 4, out SaddlePoint point), Is.True);
            Assert.That((point.PositionPx - new Vector2D(40, 35)).Length, Is.LessThan(1));
            Assert.That(_finder.TryFindNear(new Vector2D(60, 34), 4, out _), Is.False);
            Assert.That(_finder.TryFindNear(new Vector2D(-3, double.NaN), 4, out _), Is.False);
        }

        [Test]
        public void Find_AnotherFormat_Throws()
        {
            using var picture = new Image();
            Assert.Throws<ArgumentException>(() => _finder.Find(picture));
            picture.Reset(PixelFormat.Bgra32, 64, 64, 0);
            Assert.Throws<ArgumentException>(() => _finder.Find(picture));
        }

        [Test]
        public void Find_NoiseOfTheWorstKind_KeepsToItsRoom()
        {
            var random = new Random(4);
            _picture.Reset(PixelFormat.Gray8, 800, 600, 0);
            for (int i = 0; i < _picture.SizeBytes; i++)
                _picture.Bytes[i] = (byte)(random.Next(2) * 255);
            Assert.That(_finder.Find(_picture).Length, Is.LessThanOrEqualTo(SaddlePointFinder.MaximumPoints));
        }

        [TestCase(0.0, 0.0)]
        [TestCase(0.4, -0.3)]
        [TestCase(-1.2, 0.9)]
        public void TryRefine_StartNearTheCorner_EndsOnIt(double offX, double offY)
        {
            var truth = new Vector2D(40.37, 35.81);
            DrawCrossing(truth, 0.5, 1.8, 60, 180);
            var start = new SaddlePoint(truth + new Vector2D(offX, offY), Direction(0.6), Direction(1.7), 90, 1);
            Assert.That(SaddlePointRefiner.TryRefine(_picture, start, 7, out SaddlePoint refined), Is.True);
            Assert.That((refined.PositionPx - truth).Length, Is.LessThan(0.02));
            Assert.That(refined.Contrast, Is.EqualTo(120).Within(6));
            Assert.That(refined.Quality, Is.GreaterThan(0.99));
        }

        [Test]
        public void CornerRefiner_StartNearTheCorner_EndsOnItWithoutKnowingItsEdges()
        {
            var truth = new Vector2D(40.37, 35.81);
            DrawCrossing(truth, 0.5, 1.8, 60, 180);
            var corner = new Vector2D(41.2, 35.1);
            Assert.That(CornerRefiner.TryRefine(_picture, CornerRefiner.HalfWindow(30), ref corner), Is.True);
            Assert.That((corner - truth).Length, Is.LessThan(0.1));
            var outside = new Vector2D(2, 35);
            Assert.That(CornerRefiner.TryRefine(_picture, 5, ref outside), Is.False);
            _picture.Bytes.Fill(100);
            Assert.That(CornerRefiner.TryRefine(_picture, 5, ref corner), Is.False);
        }

        [Test]
        public void TryRefine_WithoutACorner_Refuses()
        {
            _picture.Reset(PixelFormat.Gray8, 80, 70, 0);
            _picture.Bytes.Fill(100);
            var start = new SaddlePoint(new Vector2D(40, 35), Direction(0), Direction(1.57), 90, 1);
            Assert.That(SaddlePointRefiner.TryRefine(_picture, start, 7, out _), Is.False, "flat");
            DrawCrossing(new Vector2D(40, 35), 0, 1.57, 180, 60);
            Assert.That(SaddlePointRefiner.TryRefine(_picture, start, 7, out _), Is.False, "light and dark the other way round");
            foreach (Vector2D outside in new[] { new Vector2D(3, 35), new Vector2D(40, 66), new Vector2D(-50, 1000), new Vector2D(double.NaN, 35) })
                Assert.That(SaddlePointRefiner.TryRefine(_picture, new SaddlePoint(outside, Direction(0), Direction(1.57), 90, 1), 7, out _), Is.False, outside.ToString());
        }

        private static Vector2D Direction(double angleRad) => new Vector2D(Math.Cos(angleRad), Math.Sin(angleRad));

        /// <summary>Clockwise from edge A to edge B it is dark; every pixel is the mean of 8×8 places.</summary>
        private void DrawCrossing(Vector2D center, double angleA, double angleB, double dark, double light)
        {
            const int samples = 8;
            Vector2D a = Direction(angleA), b = Direction(angleB);
            _picture.Reset(PixelFormat.Gray8, 80, 70, 0);
            for (int y = 0; y < 70; y++)
            for (int x = 0; x < 80; x++)
            {
                double sum = 0;
                for (int i = 0; i < samples * samples; i++)
                {
                    var place = new Vector2D(x - 0.5 + (i % samples + 0.5) / samples, y - 0.5 + (i / samples + 0.5) / samples);
                    sum += Vector2D.Cross(a, place - center) * Vector2D.Cross(b, place - center) < 0 ? dark : light;
                }

                _picture.Bytes[y * _picture.Stride + x] = (byte)Math.Round(sum / (samples * samples));
            }
        }
    }
}
