using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Kernels;
using NUnit.Framework;

namespace LaserTracking.Hands
{
    public sealed class WeaponTipTests
    {
        private static readonly Vector3D Rear = new Vector3D(-100, 0, 1500);
        private static readonly Vector3D End = new Vector3D(0, 0, 1350);

        [Test]
        public void IsCovered_SomethingNearerAhead_True()
        {
            Assert.That(IsCovered(Slide().Capsule(new Vector3D(35, -200, 700), new Vector3D(35, 200, 700), 33)), Is.True);
        }

        [Test]
        public void IsCovered_NothingAhead_False()
        {
            Assert.That(IsCovered(Slide()), Is.False);
        }

        [Test]
        public void IsCovered_SomethingNearerBehindTheEnd_False()
        {
            // Another arm crosses before this one's wrist: the weapon itself is in sight.
            Assert.That(IsCovered(Slide().Capsule(new Vector3D(-60, -200, 700), new Vector3D(-60, 200, 700), 33)), Is.False);
        }

        private static SolidScene Slide() => new SolidScene { NoiseMm = 4 }.Capsule(Rear, End, 15);

        private static bool IsCovered(SolidScene scene)
        {
            using var frame = new Frame();
            scene.Render(frame, 0, 0);
            var grid = new DepthGrid(SolidScene.Camera, new DepthHandSettings(), KernelRunner.Plain);
            grid.Fill(frame.Depth);
            return WeaponTip.IsCovered(grid, (End - Rear).Normalized, End);
        }
    }
}
