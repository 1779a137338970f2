using System;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.OpenCv;
using LaserTracking.Patterns;
using NUnit.Framework;
using OpenCvSharp;
using OpenCvStandIn;

namespace LaserTracking.Unity
{
    /// <summary>OpenCV's board corners in our order, over OpenCvSharp's stand-in, which gives the true ones as OpenCV might.</summary>
    public sealed class BoardFinderTests
    {
        private readonly OpenCvBoardFinder _finder = new OpenCvBoardFinder();

        [SetUp]
        public void Reset()
        {
            FakeWebcam.Reset();
            FakeBoard.Problem = null!;
        }

        [TestCase(9, 6)]
        [TestCase(6, 9)]
        [TestCase(8, 6)]
        [TestCase(5, 3)]
        public void TryFind_WhateverCornerOpenCvBeginsAt_GivesTheOrderOfOurFinder(int columns, int rows)
        {
            using var view = new BoardView(new BoardSize(columns, rows));
            for (int turn = 0; turn < 6; turn++)
            {
                view.Place(0.2, -0.3, turn);
                view.Paint();
                Assert.That(view.TryFind(), Is.True, view.Reason);
                foreach ((bool isMirrored, bool isTurned) in new[] { (false, false), (false, true), (true, false), (true, true) })
                {
                    FakeBoard.Corners = Shuffled(view.Truth, columns, isMirrored, isTurned);
                    var corners = new Vector2D[columns * rows];
                    Assert.That(_finder.TryFind(view.Picture, view.Board.Size, corners, out string reason), Is.True, reason);
                    Assert.That(corners.Zip(view.Corners, (a, b) => (a - b).Length).Max(), Is.LessThan(0.1), $"turn {turn}, {isMirrored}, {isTurned}");
                }
            }

            Assert.That(FakeBoard.Seen, Is.EqualTo(Enumerable.Range(0, BoardView.Height).SelectMany(y => view.Picture.Bytes.Slice(y * view.Picture.Stride, BoardView.Width).ToArray())));
            Assert.That(FakeWebcam.MatsAlive, Is.Zero);
        }

        [Test]
        public void TryFind_NoBoardOrARefusal_SaysWhy()
        {
            using var view = new BoardView(BoardView.NineBySix);
            view.Paint();
            FakeBoard.Corners = new Point2f[3];
            var corners = new Vector2D[54];
            Assert.That(_finder.TryFind(view.Picture, BoardView.NineBySix, corners, out string reason), Is.False);
            Assert.That(reason, Is.EqualTo("OpenCV finds no board of 9×6 inner corners"));
            FakeBoard.Problem = new OpenCVException("assertion failed.\nmore");
            Assert.That(_finder.TryFind(view.Picture, BoardView.NineBySix, corners, out reason), Is.False);
            Assert.That(reason, Is.EqualTo("OpenCV refuses the picture (assertion failed)"));
            Assert.Throws<ArgumentException>(() => _finder.TryFind(view.Picture, BoardView.NineBySix, new Vector2D[3], out _));
            Assert.That(FakeWebcam.MatsAlive, Is.Zero);
        }

        private static Point2f[] Shuffled(Vector2D[] truth, int columns, bool isMirrored, bool isTurned)
        {
            Point2f[] corners = truth.Select(corner => new Point2f((float)corner.X, (float)corner.Y)).ToArray();
            if (isMirrored)
            {
                for (int row = 0; row < corners.Length; row += columns)
                    Array.Reverse(corners, row, columns);
            }

            if (isTurned)
                Array.Reverse(corners);
            return corners;
        }
    }
}
