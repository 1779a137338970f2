using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Session
{
    public sealed class GroupStatisticsTests
    {
        [Test]
        public void Of_Rectangle_GivesTheTextbookMeasures()
        {
            // Corners of a 6 by 8 rectangle about (1, 2): every radius 5, diagonal 10, SD √(4·9/3) and √(4·16/3).
            GroupStatistics group = GroupStatistics.Of(new[] { new Vector2D(-2, -2), new Vector2D(4, -2), new Vector2D(4, 6), new Vector2D(-2, 6) });
            Assert.That(group.Center, Is.EqualTo(new Vector2D(1, 2)));
            Assert.That(group.MeanRadius, Is.EqualTo(5).Within(1e-12));
            Assert.That(group.MedianRadius, Is.EqualTo(5).Within(1e-12));
            Assert.That(group.ExtremeSpread, Is.EqualTo(10).Within(1e-12));
            Assert.That(group.StandardDeviation.X, Is.EqualTo(3.4641016151377544).Within(1e-12));
            Assert.That(group.StandardDeviation.Y, Is.EqualTo(4.6188021535170058).Within(1e-12));
        }

        [Test]
        public void Of_OneOrNoPoint_HasNoSpread()
        {
            GroupStatistics one = GroupStatistics.Of(new[] { new Vector2D(3, 4) });
            Assert.That(one.Center, Is.EqualTo(new Vector2D(3, 4)));
            Assert.That(one.MeanRadius + one.ExtremeSpread + one.StandardDeviation.Length, Is.EqualTo(0));
            Assert.That(GroupStatistics.Of(new Vector2D[0]).Count, Is.EqualTo(0));
        }
    }
}
