using System;
using System.Collections.Generic;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Patterns
{
    public sealed class ScreenPatternTests
    {
        [TestCase(1920, 1080, 9, 120, 144)]
        [TestCase(1280, 800, 10, 135, 160)]
        [TestCase(1024, 768, 12, 165, 192)]
        [TestCase(1366, 768, 9, 120, 144)]
        public void Boards_OfUsualProjectors_HaveEnoughPoints(int width, int height, int down, int first, int second)
        {
            var pattern = new ScreenPattern(width, height);
            Assert.That((pattern.Board(0).CellsDown, pattern.Board(1).Count, pattern.Board(2).Count), Is.EqualTo((down, first, second)));
            Assert.That(first, Is.GreaterThanOrEqualTo(ScreenCalibrator.LeastPoints));
        }

        [TestCase(159, 90)]
        [TestCase(1920, 600)]
        [TestCase(1000, 1000)]
        [TestCase(0, 0)]
        [TestCase(int.MaxValue, int.MaxValue)]
        public void Pattern_OfAnImpossibleSize_IsRefused(int width, int height)
        {
            Assert.That(ScreenPattern.CanDraw(width, height), Is.False);
            Assert.That(() => new ScreenPattern(width, height), Throws.InstanceOf<ArgumentOutOfRangeException>());
        }

        [TestCase(640, 360)]
        [TestCase(683, 384)]
        [Category("Long")]
        public void Draw_PictureAndItsInverse_AreTogetherWhite(int width, int height)
        {
            var pattern = new ScreenPattern(width, height);
            using Image picture = new Image(), inverse = new Image();
            for (int i = 0; i < ScreenPattern.Pictures; i += 2)
            {
                pattern.Draw(i, picture);
                pattern.Draw(i + 1, inverse);
                double sum = 0;
                for (int k = 0; k < picture.Bytes.Length; k++)
                {
                    // Light, not levels, adds up.
                    double light = Math.Pow(picture.Bytes[k] / 255.0, 2.2) + Math.Pow(inverse.Bytes[k] / 255.0, 2.2);
                    Assert.That(light, Is.EqualTo(1).Within(0.01));
                    sum += Math.Pow(picture.Bytes[k] / 255.0, 2.2) / picture.Bytes.Length;
                }

                Assert.That(sum, Is.EqualTo(0.5).Within(0.03), "half of it is white: automatic exposure stays where it is");
            }
        }

        [Test]
        public void Codes_OfAllBoardsInAllPositions_AreFarApart()
        {
            // A part of 6 × 6 cells anywhere on one board against every place on every board in every way.
            var boards = new List<ScreenBoard>();
            for (int down = ScreenBoard.LeastCellsDown; down <= ScreenBoard.MostCellsDown; down++)
            {
                boards.Add(new ScreenBoard(down, false));
                boards.Add(new ScreenBoard(down, true));
            }

            int worst = 0;
            ScreenBoard wide = boards[6];
            Assert.That(wide.CellsDown, Is.EqualTo(9));
            for (int place = 0; place < 6; place++)
            {
                int u = place % 3 * 4, v = place / 3;
                foreach (ScreenBoard board in boards)
                {
                    for (int way = 0; way < 8; way++)
                    {
                        for (int j = 0; j + 6 <= board.Rows - 1; j++)
                        {
                            for (int i = 0; i + 6 <= board.Columns - 1; i++)
                            {
                                if (board == wide && way == 0 && i == u && j == v)
                                    continue;
                                worst = Math.Max(worst, Agreements(wide, u, v, board, i, j, way));
                            }
                        }
                    }
                }
            }

            Assert.That(worst, Is.LessThanOrEqualTo(32), "of 36 dots, at least four differ everywhere else");
        }

        private static int Agreements(ScreenBoard a, int u, int v, ScreenBoard b, int i, int j, int way)
        {
            int agreements = 0;
            for (int k = 0; k < 36; k++)
            {
                int x = k % 6, y = k / 6, s = way < 4 ? x : 5 - x;
                (int p, int q) = (way & 3) switch { 0 => (s, y), 1 => (5 - y, s), 2 => (5 - s, 5 - y), _ => (y, 5 - s) };
                agreements += a.HasDot(u + x, v + y) == b.HasDot(i + p, j + q) ? 1 : 0;
            }

            return agreements;
        }
    }
}
