using LaserTracking.Capture;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Hands
{
    public sealed class SeenDepthTests
    {
        [Test]
        public void TowardsMm_AfterTheTrackerSawAFrame_IsWhatLiesInThatDirection()
        {
            using var frame = new Frame();
            var hands = new HandObservations();
            var tracker = new DepthHandTracker(SolidScene.Camera);
            new SolidScene { WallMm = 3500 }.Ellipsoid(new Vector3D(300, 100, 1500), new Vector3D(60, 60, 60)).Render(frame, 0, 0);
            tracker.Process(frame, hands);
            Assert.That(hands.Depth.IsPresent, Is.True);
            Assert.That(hands.Depth.TowardsMm(new Vector3D(300, 100, 1500)), Is.EqualTo(1440).Within(15));
            Assert.That(hands.Depth.TowardsMm(new Vector3D(600, 200, 3000)), Is.EqualTo(1440).Within(15), "whatever the distance asked for");
            Assert.That(hands.Depth.TowardsMm(new Vector3D(0, 100, 1500)), Is.EqualTo(3500));
        }

        [Test]
        public void TowardsMm_OutsideThePictureOrBehindTheCamera_IsZero()
        {
            using var frame = new Frame();
            var hands = new HandObservations();
            new SolidScene().Render(frame, 0, 0);
            new DepthHandTracker(SolidScene.Camera).Process(frame, hands);
            Assert.That(hands.Depth.TowardsMm(new Vector3D(3000, 0, 1500)), Is.Zero);
            Assert.That(hands.Depth.TowardsMm(new Vector3D(0, -3000, 1500)), Is.Zero);
            Assert.That(hands.Depth.TowardsMm(new Vector3D(0, 0, -1500)), Is.Zero);
        }

        [Test]
        public void IsPresent_FrameWithoutDepth_False()
        {
            using var frame = new Frame();
            var hands = new HandObservations();
            var tracker = new DepthHandTracker(SolidScene.Camera);
            new SolidScene().Render(frame, 0, 0);
            tracker.Process(frame, hands);
            frame.Begin(1, 33_000);
            tracker.Process(frame, hands);
            Assert.That(hands.Depth.IsPresent, Is.False);
            Assert.That(hands.Depth.TowardsMm(new Vector3D(0, 0, 1500)), Is.Zero);
        }
    }
}
