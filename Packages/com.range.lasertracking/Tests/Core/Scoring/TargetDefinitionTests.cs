using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Scoring
{
    public sealed class TargetDefinitionTests
    {
        [Test]
        public void TargetDefinition_ZoneAt_GivesTheFirstThatHoldsThePoint()
        {
            Assert.That(TestScenes.Rings.ZoneAt(new Vector2D(0.05, 0.05)), Is.EqualTo(0));
            Assert.That(TestScenes.Rings.ZoneAt(new Vector2D(0.1, 0)), Is.EqualTo(0));
            Assert.That(TestScenes.Rings.ZoneAt(new Vector2D(0.1, 0.1)), Is.EqualTo(1));
            Assert.That(TestScenes.Rings.ZoneAt(new Vector2D(0.45, 0.45)), Is.EqualTo(-1));
        }

        [Test]
        public void TargetZone_Shapes_HoldWhatTheyShow()
        {
            var center = new Vector2D(1, 2);
            var size = new Vector2D(2, 1);
            var none = new Vector2D[0];
            var ellipse = new TargetZone("e", 1, ZoneShape.Ellipse, center, size, none);
            var rectangle = new TargetZone("r", 1, ZoneShape.Rectangle, center, size, none);
            var corner = new Vector2D(1.9, 2.4);
            Assert.That(ellipse.Contains(corner), Is.False);
            Assert.That(rectangle.Contains(corner), Is.True);
            Assert.That(ellipse.Contains(new Vector2D(2, 2)), Is.True);
            Assert.That(rectangle.Contains(new Vector2D(2.01, 2)), Is.False);

            // An L: the notch is outside.
            var polygon = new TargetZone("p", 1, ZoneShape.Polygon, default, default, new[]
            {
                new Vector2D(0, 0), new Vector2D(2, 0), new Vector2D(2, 1), new Vector2D(1, 1), new Vector2D(1, 2), new Vector2D(0, 2),
            });
            Assert.That(polygon.Contains(new Vector2D(0.5, 1.5)), Is.True);
            Assert.That(polygon.Contains(new Vector2D(1.5, 1.5)), Is.False);
            Assert.That(polygon.Contains(new Vector2D(2, 0.5)), Is.True);
        }

        [Test]
        public void TargetZone_Senseless_IsRefused()
        {
            var none = new Vector2D[0];
            Assert.That(() => new TargetZone("z", 1, ZoneShape.Ellipse, default, new Vector2D(1, 0), none), Throws.ArgumentException);
            Assert.That(() => new TargetZone("z", 1, ZoneShape.Polygon, default, default, new Vector2D[2]), Throws.ArgumentException);
            Assert.That(() => new TargetDefinition("t", TargetKind.Silhouette, new Vector2D(1, 1), new TargetZone[0]), Throws.ArgumentException);
        }
    }
}
