using System;
using NUnit.Framework;

namespace LaserTracking.Detection
{
    public sealed unsafe class CellBlendTests
    {
        [TestCase(128, 0)]
        [TestCase(1, 132)]
        public void Column_VectorAndScalar_AreEqual(double factor, double start)
        {
            const int Width = 61, Height = 47;
            double[] cells = Cells(index => 3 * Math.Sin(index * 12.9898) * Math.Sin(index * 78.233) * (factor > 1 ? 1 : 100));
            Assert.That(Levels(cells, Width, Height, factor, start, true), Is.EqualTo(Levels(cells, Width, Height, factor, start, false)));
        }

        [Test]
        public void Column_OfNumbersThatRiseEvenly_RisesEvenlyBetweenTheMiddlesOfTheCells()
        {
            // Blue by the column, green by the row, red by both: four pixels a cell.
            double[] cells = Cells(index => (index % 3 == 1 ? 0 : index / 3 % ScreenGrid.Columns) + (index % 3 == 0 ? 0 : index / 3 / ScreenGrid.Columns));
            const int Width = 4 * ScreenGrid.Columns, Height = 4 * ScreenGrid.Rows;
            uint[] levels = Levels(cells, Width, Height, 2, 50, false);
            for (int y = 2; y < Height - 4; y++)
            {
                for (int x = 2; x < Width - 4; x++)
                {
                    double column = 2 * ((x + 0.5) / 4 - 0.5), row = 2 * ((y + 0.5) / 4 - 0.5);
                    uint pixel = levels[y * Width + x];
                    Assert.That((double)(pixel & 255), Is.EqualTo(50 + column).Within(0.51));
                    Assert.That((double)(pixel >> 8 & 255), Is.EqualTo(50 + row).Within(0.51));
                    Assert.That((double)(pixel >> 16), Is.EqualTo(50 + column + row).Within(0.51));
                }
            }
        }

        [Test]
        public void Place_BesideTheMiddlesOfTheOuterCells_StaysBetweenThem()
        {
            Assert.That(CellBlend.Place(0, 640, ScreenGrid.Columns), Is.Zero);
            Assert.That(CellBlend.Place(639, 640, ScreenGrid.Columns), Is.LessThan(ScreenGrid.Columns - 1).And.GreaterThan(ScreenGrid.Columns - 1.01));
        }

        private static double[] Cells(Func<int, double> number)
        {
            var cells = new double[CellBlend.Length];
            for (int i = 0; i < 3 * ScreenGrid.CellCount; i++)
                cells[i] = number(i);
            return cells;
        }

        private static uint[] Levels(double[] cells, int width, int height, double factor, double start, bool useVectors)
        {
            var levels = new uint[width * height];
            var rows = new double[height];
            for (int y = 0; y < height; y++)
                rows[y] = CellBlend.Place(y, height, ScreenGrid.Rows);
            fixed (double* numbers = cells, places = rows)
            fixed (uint* target = levels)
            {
                for (int x = 0; x < width; x++)
                    CellBlend.Column(numbers, CellBlend.Place(x, width, ScreenGrid.Columns), places, height, factor, start, target + x, width, useVectors);
            }

            return levels;
        }
    }
}
