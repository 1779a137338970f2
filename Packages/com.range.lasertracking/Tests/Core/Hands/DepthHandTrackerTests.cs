using System;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Hands
{
    public sealed class DepthHandTrackerTests
    {
        private const long FrameUs = 33_333;

        private Frame _frame = null!;
        private HandObservations _hands = null!;

        [SetUp]
        public void SetUp()
        {
            _frame = new Frame();
            _hands = new HandObservations();
        }

        [TearDown]
        public void TearDown() => _frame.Dispose();

        [Test]
        public void Process_StillAimingArmWithPistol_FindsPalmMuzzleAndAxis()
        {
            var fist = new Vector3D(-80, -60, 1150);
            var scene = new SolidScene { NoiseMm = 4 }.Body(0, 1750);
            Vector3D muzzle = scene.Arm(new Vector3D(-190, -60, 1720), fist, 140);
            HandObservation hand = Single(scene, new DepthHandTracker(SolidScene.Camera));
            Assert.That((hand.PalmMm - fist).Length, Is.LessThan(30), "palm " + hand.PalmMm);
            Assert.That((hand.MuzzleMm - muzzle).Length, Is.LessThan(30), "muzzle " + hand.MuzzleMm);
            Assert.That(hand.DepthSource, Is.EqualTo(DepthSource.Measured));
        }

        [Test]
        public void Process_ArmAtAnAngle_AxisWithinTenDegrees()
        {
            var shoulder = new Vector3D(-190, -60, 1720);
            var fist = new Vector3D(60, 40, 1200);
            var scene = new SolidScene { NoiseMm = 4 }.Body(0, 1750);
            scene.Arm(shoulder, fist, 140);
            HandObservation hand = Single(scene, new DepthHandTracker(SolidScene.Camera));
            double angle = Math.Acos(Vector3D.Dot(hand.AimDirection, (fist - shoulder).Normalized)) * 180 / Math.PI;
            Assert.That(angle, Is.LessThan(10), "axis " + hand.AimDirection);
        }

        [Test]
        public void Process_BodyWithoutRaisedArm_FindsNoHand()
        {
            new SolidScene { NoiseMm = 4 }.Body(0, 1600).Render(_frame, 0, 0);
            new DepthHandTracker(SolidScene.Camera).Process(_frame, _hands);
            Assert.That(_hands.Hands.Length, Is.Zero);
        }

        [Test]
        public void Process_RightArm_IsRightAfterAFewFrames()
        {
            Assert.That(SideAfterFrames(-190, -40, 60), Is.EqualTo(HandSide.Right));
            Assert.That(SideAfterFrames(190, 40, 60), Is.EqualTo(HandSide.Left));
        }

        [Test]
        public void Process_ArmHiddenBehindItsHand_SideUnknown()
        {
            // Along the line of sight: only the fist is seen, and a hand before the chest may be either one.
            Assert.That(SideAfterFrames(-190, -0.8 * 190, -40), Is.EqualTo(HandSide.Unknown));
        }

        [Test]
        public void Process_ArmWithoutABody_SideUnknown()
        {
            var scene = new SolidScene();
            scene.Arm(new Vector3D(0, 150, 1300), new Vector3D(-100, -20, 1000), 0);
            var tracker = new DepthHandTracker(SolidScene.Camera);
            for (int i = 0; i < 5; i++)
            {
                scene.Render(_frame, i, i * FrameUs);
                tracker.Process(_frame, _hands);
            }

            Assert.That(_hands.Hands.Length, Is.EqualTo(1));
            Assert.That(_hands.Hands[0].Side, Is.EqualTo(HandSide.Unknown));
        }

        [Test]
        public void Process_ThirtyPercentInvalidPixels_PalmHardlyMoves()
        {
            var fist = new Vector3D(-80, -60, 1150);
            var scene = new SolidScene { NoiseMm = 4, HoleShare = 0.3 }.Body(0, 1750);
            scene.Arm(new Vector3D(-190, -60, 1720), fist, 140);
            HandObservation hand = Single(scene, new DepthHandTracker(SolidScene.Camera));
            Assert.That((hand.PalmMm - fist).Length, Is.LessThan(30), "palm " + hand.PalmMm);
        }

        [Test]
        public void Process_TwoPeopleFortyCentimetresApart_KeepTheirTracksWhileMoving()
        {
            var tracker = new DepthHandTracker(SolidScene.Camera);
            int left = 0, right = 0;
            for (int i = 0; i < 12; i++)
            {
                double sway = 60 * Math.Sin(i * 0.6);
                var scene = new SolidScene { NoiseMm = 4 }.Body(-230, 1850).Body(230, 1800);
                scene.Arm(new Vector3D(-300, -60, 1830), new Vector3D(-200 + sway, -60, 1250), 140);
                scene.Arm(new Vector3D(150, -60, 1790), new Vector3D(200 + sway, -60, 1220 + sway), 140);
                scene.Render(_frame, i, i * FrameUs, i + 1);
                tracker.Process(_frame, _hands);
                Assert.That(_hands.Hands.Length, Is.EqualTo(2), "frame " + i);
                foreach (HandObservation hand in _hands.Hands.ToArray())
                {
                    ref int id = ref hand.PalmMm.X < sway ? ref left : ref right;
                    if (i == 0)
                        id = hand.TrackId;
                    Assert.That(hand.TrackId, Is.EqualTo(id), "frame " + i);
                }
            }

            Assert.That(left, Is.Not.EqualTo(right));
        }

        [Test]
        public void Process_FrameWithoutDepth_GivesNone()
        {
            _frame.Begin(3, 1234);
            new DepthHandTracker(SolidScene.Camera).Process(_frame, _hands);
            Assert.That(_hands.Hands.Length, Is.Zero);
            Assert.That(_hands.TimeUs, Is.EqualTo(1234));
        }

        [Test]
        public void Process_DepthAllZero_GivesNone()
        {
            new SolidScene { HoleShare = 1.1 }.Render(_frame, 0, 0);
            new DepthHandTracker(SolidScene.Camera).Process(_frame, _hands);
            Assert.That(_hands.Hands.Length, Is.Zero);
        }

        [Test]
        public void Process_OnceWarm_AllocatesNothing()
        {
            var scene = new SolidScene { NoiseMm = 4 }.Body(0, 1750);
            scene.Arm(new Vector3D(-190, -60, 1720), new Vector3D(-80, -60, 1150), 140);
            scene.Render(_frame, 0, 0);
            var tracker = new DepthHandTracker(SolidScene.Camera);
            tracker.Process(_frame, _hands);
            tracker.Process(_frame, _hands);
            long allocated = Allocation.Of(() =>
            {
                for (int i = 0; i < 5; i++)
                {
                    _frame.Depth.TimeUs += FrameUs;
                    tracker.Process(_frame, _hands);
                }
            });
            Assert.That(allocated, Is.Zero);
            Assert.That(_hands.Hands.Length, Is.EqualTo(1));
        }

        [Test]
        public void Constructor_GateTheWrongWayRound_IsRefused()
        {
            Assert.That(() => new DepthHandTracker(SolidScene.Camera, new DepthHandSettings { NearMm = 2000, FarMm = 400 }),
                Throws.ArgumentException);
        }

        private HandSide SideAfterFrames(double shoulderX, double fistX, double fistY)
        {
            var scene = new SolidScene { NoiseMm = 4 }.Body(0, 1750);
            scene.Arm(new Vector3D(shoulderX, -60, 1720), new Vector3D(fistX, fistY, 1150), 140);
            var tracker = new DepthHandTracker(SolidScene.Camera);
            for (int i = 0; i < 4; i++)
            {
                scene.Render(_frame, i, i * FrameUs);
                tracker.Process(_frame, _hands);
            }

            Assert.That(_hands.Hands.Length, Is.EqualTo(1));
            return _hands.Hands[0].Side;
        }

        private HandObservation Single(SolidScene scene, IHandTracker tracker)
        {
            scene.Render(_frame, 0, 0);
            tracker.Process(_frame, _hands);
            Assert.That(_hands.Hands.Length, Is.EqualTo(1));
            return _hands.Hands[0];
        }
    }
}
