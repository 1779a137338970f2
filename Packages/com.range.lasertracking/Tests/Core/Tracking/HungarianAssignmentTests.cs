using System;
using NUnit.Framework;

namespace LaserTracking.Tracking
{
    public sealed class HungarianAssignmentTests
    {
        [Test]
        public void Solve_RandomMatricesOfAllShapes_EqualsTheBestOfAllPermutations()
        {
            var random = new Random(5);
            var solver = new HungarianAssignment(6);
            for (int trial = 0; trial < 400; trial++)
            {
                int rows = random.Next(1, 6), columns = random.Next(1, 6);
                var cost = new double[rows * columns];
                for (int i = 0; i < cost.Length; i++)
                    cost[i] = trial % 2 == 0 ? random.Next(0, 5) : random.NextDouble() - 0.5;
                var chosen = new int[rows];
                double total = solver.Solve(cost, rows, columns, chosen);
                double sum = 0;
                int used = 0, count = 0;
                for (int i = 0; i < rows; i++)
                {
                    if (chosen[i] < 0)
                        continue;
                    Assert.That(used & (1 << chosen[i]), Is.Zero, "a column twice");
                    used |= 1 << chosen[i];
                    count++;
                    sum += cost[i * columns + chosen[i]];
                }

                Assert.That(count, Is.EqualTo(Math.Min(rows, columns)));
                Assert.That(sum, Is.EqualTo(total).Within(1e-9));
                Assert.That(total, Is.EqualTo(Best(cost, rows, columns, 0, 0, Math.Max(0, rows - columns))).Within(1e-9));
            }
        }

        [Test]
        public void Solve_NothingToAssign_IsZero()
        {
            var chosen = new int[2];
            Assert.That(new HungarianAssignment(3).Solve(new double[0], 2, 0, chosen), Is.Zero);
            Assert.That(chosen, Is.EqualTo(new[] { -1, -1 }));
        }

        [Test]
        public void Solve_NotANumber_CountsAsForbidden()
        {
            var chosen = new int[2];
            new HungarianAssignment(2).Solve(new[] { double.NaN, 3, 1, double.PositiveInfinity }, 2, 2, chosen);
            Assert.That(chosen, Is.EqualTo(new[] { 1, 0 }));
        }

        [Test]
        public void Solve_MoreThanTheCapacity_IsRefused()
        {
            Assert.That(() => new HungarianAssignment(2).Solve(new double[9], 3, 3, new int[3]), Throws.InstanceOf<ArgumentException>());
        }

        private static double Best(double[] cost, int rows, int columns, int row, int used, int skips)
        {
            if (row == rows)
                return 0;
            double best = skips > 0 ? Best(cost, rows, columns, row + 1, used, skips - 1) : double.MaxValue;
            for (int j = 0; j < columns; j++)
            {
                if ((used & (1 << j)) == 0)
                    best = Math.Min(best, cost[row * columns + j] + Best(cost, rows, columns, row + 1, used | 1 << j, skips));
            }

            return best;
        }
    }
}
