using System;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// With a network that always sees the same upright hand in the middle of its crop: what is looked at, what is believed, what
    /// stays as depth has it.
    /// </summary>
    public sealed class LandmarkHandTrackerTests
    {
        private const long FrameUs = 33_333;

        private static readonly PinholeCamera Camera = new PinholeCamera(504, 504, 319.5, 287.5, 640, 576);
        private static readonly Vector3D Palm = new Vector3D(100, -50, 1000);

        // x, y of an upright hand as shares of the crop, such that its landmarks lead back to the same region.
        private static readonly float[] Hand =
        {
            0.5135f, 0.8000f, 0.4190f, 0.7459f, 0.3515f, 0.6514f, 0.3110f, 0.5703f, 0.2705f, 0.5027f, 0.4325f, 0.4757f, 0.4055f, 0.3405f,
            0.3920f, 0.2595f, 0.3785f, 0.1919f, 0.5135f, 0.4486f, 0.5135f, 0.3000f, 0.5135f, 0.2054f, 0.5135f, 0.1378f, 0.5945f, 0.4622f,
            0.6080f, 0.3405f, 0.6215f, 0.2595f, 0.6215f, 0.1919f, 0.6620f, 0.5162f, 0.6890f, 0.4216f, 0.7160f, 0.3676f, 0.7295f, 0.3135f,
        };

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
        public void Process_HandThatDepthBearsOut_TakesItsPalmAndSide()
        {
            using HandLandmarkNetwork network = Network(3, 0.27f);
            var depth = new FixedTracker { Hand = Observation(new Vector3D(0, -1, 0)) };
            var tracker = new LandmarkHandTracker(depth, Camera, network);
            for (int i = 0; i < 5; i++)
                Process(tracker, i);
            HandObservation hand = _hands.Hands[0];
            Assert.That(tracker.TryGetLandmarks(7, out HandLandmarks landmarks), Is.True);
            Assert.That(hand.Side, Is.EqualTo(HandSide.Right));
            Assert.That(hand.PalmMm.Z, Is.EqualTo(Palm.Z));

            // Half way from depth's palm to the landmarks', for both are equally uncertain.
            Vector3D middle = (landmarks.PicturePx[0] + landmarks.PicturePx[5] + landmarks.PicturePx[9] + landmarks.PicturePx[13] + landmarks.PicturePx[17]) * 0.2;
            Vector3D seen = Camera.Unproject(middle.X - 0.5, middle.Y - 0.5, Palm.Z);
            Assert.That((hand.PalmMm - (Palm + seen) * 0.5).Length, Is.LessThan(0.01));
            Assert.That((hand.PalmMm - Palm).Length, Is.LessThan(30));
            Assert.That(hand.MuzzleMm.X, Is.EqualTo(Palm.X));
        }

        [Test]
        public void Process_FirstRegion_IsSizedByDepthAndTurnedByTheForearm()
        {
            using HandLandmarkNetwork network = Network(3, 0.27f);
            var tracker = new LandmarkHandTracker(new FixedTracker { Hand = Observation(new Vector3D(1, 0, 0)) }, Camera, network);
            Process(tracker, 0);
            Assert.That(tracker.TryGetLandmarks(7, out HandLandmarks landmarks), Is.True);

            // The region seen is the second one; the same landmarks in the first one lead to it.
            var first = new HandLandmarks();
            first.Set(new HandRegion(319.5 + 0.5 + 50.4, 287.5 + 0.5 - 25.2, 504 * 0.27, Math.PI / 2), landmarks.CropPx, new float[63], 1, 1);
            Assert.That(landmarks.Region.CenterXPx, Is.EqualTo(first.NextRegion.CenterXPx).Within(1e-3));
            Assert.That(landmarks.Region.CenterYPx, Is.EqualTo(first.NextRegion.CenterYPx).Within(1e-3));
            Assert.That(landmarks.Region.SidePx, Is.EqualTo(first.NextRegion.SidePx).Within(1e-3));
            Assert.That(landmarks.Region.RotationRad, Is.EqualTo(first.NextRegion.RotationRad).Within(1e-6));
        }

        [Test]
        public void Process_NoHandThere_StaysAsDepthHasIt() => AssertUntouched(Network(-3, 0.27f), Observation(new Vector3D(0, -1, 0)));

        [Test]
        public void Process_HandOfImpossibleSize_StaysAsDepthHasIt() => AssertUntouched(Network(3, 0.8f), Observation(new Vector3D(0, -1, 0)));

        [Test]
        public void Process_HandWithoutDepth_StaysAsItIs()
        {
            HandObservation hand = Observation(new Vector3D(0, -1, 0));
            hand.DepthSource = DepthSource.Bridged;
            AssertUntouched(Network(3, 0.27f), hand);
        }

        [Test]
        public void Process_NoPicture_StaysAsDepthHasIt()
        {
            using HandLandmarkNetwork network = Network(3, 0.27f);
            var depth = new FixedTracker { Hand = Observation(new Vector3D(0, -1, 0)) };
            Begin(0);
            _frame.Infrared.Clear();
            new LandmarkHandTracker(depth, Camera, network).Process(_frame, _hands);
            Assert.That(_hands.Hands[0].PalmMm.X, Is.EqualTo(Palm.X));
        }

        [TestCase(4, false)]
        [TestCase(5, true)]
        public void Process_ForearmTowardsTheCamera_NeedsRunsForFourRotations(int runs, bool isSeen)
        {
            using HandLandmarkNetwork network = Network(3, 0.27f);
            var tracker = new LandmarkHandTracker(new FixedTracker { Hand = Observation(new Vector3D(0, 0, -1)) }, Camera, network, new LandmarkHandSettings { MaxRunsPerFrame = runs });
            Process(tracker, 0);
            Assert.That(tracker.TryGetLandmarks(7, out _), Is.EqualTo(isSeen));
        }

        [Test]
        public void Process_Warm_AllocatesNothing()
        {
            using HandLandmarkNetwork network = Network(3, 0.27f);
            var tracker = new LandmarkHandTracker(new FixedTracker { Hand = Observation(new Vector3D(0, -1, 0)) }, Camera, network);
            int index = 0;
            Assert.That(Allocation.Of(() => Process(tracker, index++)), Is.Zero);
        }

        private static HandObservation Observation(Vector3D axis) => new HandObservation
        {
            TrackId = 7, PalmMm = Palm, MuzzleMm = Palm, AimDirection = axis, SigmaMm = 15, DepthSource = DepthSource.Measured,
        };

        private void AssertUntouched(HandLandmarkNetwork network, HandObservation observed)
        {
            using (network)
            {
                var tracker = new LandmarkHandTracker(new FixedTracker { Hand = observed }, Camera, network);
                for (int i = 0; i < 5; i++)
                    Process(tracker, i);
                Assert.That(_hands.Hands.Length, Is.EqualTo(1));
                Assert.That(_hands.Hands[0].PalmMm.X, Is.EqualTo(Palm.X));
                Assert.That(_hands.Hands[0].Side, Is.EqualTo(HandSide.Unknown));
                Assert.That(tracker.TryGetLandmarks(7, out _), Is.False);
            }
        }

        private void Begin(int index)
        {
            _frame.Begin(index, index * FrameUs);
            _frame.Depth.Reset(PixelFormat.Depth16, Camera.Width, Camera.Height, index * FrameUs);
            _frame.Infrared.Reset(PixelFormat.Infrared16, Camera.Width, Camera.Height, index * FrameUs);
        }

        private void Process(IHandTracker tracker, int index)
        {
            Begin(index);
            tracker.Process(_frame, _hands);
        }

        /// <summary>Reads its input, for form's sake, and answers with constants.</summary>
        /// <param name="presence">Before the sigmoid.</param>
        /// <param name="worldSideM">Metres that the crop's side is, by the world landmarks: those of the region where the hand is a hand's size.</param>
        private static HandLandmarkNetwork Network(float presence, float worldSideM)
        {
            var crop = new float[63];
            var world = new float[63];
            for (int i = 0; i < HandLandmarks.Count; i++)
            {
                for (int axis = 0; axis < 2; axis++)
                {
                    crop[3 * i + axis] = 224 * Hand[2 * i + axis];
                    world[3 * i + axis] = worldSideM * (Hand[2 * i + axis] - 0.5f);
                }
            }

            var builder = new TfLiteBuilder();
            int from = builder.Tensor(1, 224, 224, 3), mean = builder.Tensor(1, 3);
            builder.Operator(40, mean, new[] { from, builder.Integers(new[] { 1, 2 }, 2) }, (byte)0);
            int landmarks = Constant(builder, mean, crop), worlds = Constant(builder, mean, world);
            int there = builder.Tensor(1, 1), right = builder.Tensor(1, 1);
            builder.Operator(14, there, new[] { Constant(builder, mean, new[] { presence }) });
            builder.Operator(14, right, new[] { Constant(builder, mean, new[] { 3f }) });
            return HandLandmarkNetwork.Read(builder.Build(new[] { from }, landmarks, there, right, worlds), "test");
        }

        private static int Constant(TfLiteBuilder builder, int input, float[] values)
        {
            int to = builder.Tensor(1, values.Length);
            builder.Operator(9, to, new[] { input, builder.Constant(new float[3 * values.Length], values.Length, 3), builder.Constant(values, values.Length) }, (byte)0);
            return to;
        }

        private sealed class FixedTracker : IHandTracker
        {
            public HandObservation Hand { get; set; }

            public void Process(Frame frame, HandObservations observations)
            {
                observations.Begin(frame.Index, frame.Depth.TimeUs);
                observations.Add(Hand);
            }

            public void Reset()
            {
            }
        }
    }
}
