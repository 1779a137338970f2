using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Hands
{
    public sealed unsafe class PublishedHandTrackerTests
    {
        private const int Width = 64;
        private const int Height = 48;

        private static readonly PinholeCamera Camera = new PinholeCamera(50, 50, 31.5, 23.5, Width, Height);

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
        public void Process_ThingThatAppears_IsFoundAtItsPatchMedian()
        {
            var tracker = new PublishedHandTracker(Camera);
            Process(tracker, 0, 0);
            Square(20, 10, 9, 900);
            _frame.Depth.Bytes[(14 * Width + 24) * 2] = 0;
            _frame.Depth.Bytes[(14 * Width + 24) * 2 + 1] = 0;
            tracker.Process(_frame, _hands);
            Assert.That(_hands.Hands.Length, Is.EqualTo(1));
            HandObservation hand = _hands.Hands[0];
            Assert.That(hand.DepthSource, Is.EqualTo(DepthSource.Measured));
            Assert.That(hand.PalmMm.Z, Is.EqualTo(900));
            Assert.That(hand.PalmMm.X, Is.EqualTo((24 - 31.5) / 50 * 900).Within(1e-9));
            Assert.That(hand.PalmMm.Y, Is.EqualTo((14 - 23.5) / 50 * 900).Within(4));
        }

        [Test]
        public void Process_ThingThatKeepsStill_IsNotSeen()
        {
            var tracker = new PublishedHandTracker(Camera);
            Process(tracker, 0, 900);
            Process(tracker, 1, 900);
            Assert.That(_hands.Hands.Length, Is.Zero);
        }

        [Test]
        public void Process_ThingOutsideTheGate_IsNotSeen()
        {
            foreach (int z in new[] { 399, 2001 })
            {
                var tracker = new PublishedHandTracker(Camera);
                Process(tracker, 0, 0);
                Process(tracker, 1, z);
                Assert.That(_hands.Hands.Length, Is.Zero, "at " + z);
            }

            foreach (int z in new[] { 400, 2000 })
            {
                var tracker = new PublishedHandTracker(Camera);
                Process(tracker, 0, 0);
                Process(tracker, 1, z);
                Assert.That(_hands.Hands.Length, Is.EqualTo(1), "at " + z);
            }
        }

        [Test]
        public void Process_RingWithoutDepthInTheMiddle_AssumesFifteenHundred()
        {
            var tracker = new PublishedHandTracker(Camera);
            Process(tracker, 0, 0);
            Square(20, 10, 11, 900);
            Square(22, 12, 7, 0);
            tracker.Process(_frame, _hands);
            Assert.That(_hands.Hands.Length, Is.EqualTo(1));
            Assert.That(_hands.Hands[0].DepthSource, Is.EqualTo(DepthSource.Assumed));
            Assert.That(_hands.Hands[0].PalmMm.Z, Is.EqualTo(1500));
        }

        private void Process(PublishedHandTracker tracker, int index, int z)
        {
            _frame.Begin(index, index * 33_333);
            _frame.Depth.Reset(PixelFormat.Depth16, Width, Height, index * 33_333);
            _frame.Depth.Bytes.Clear();
            Square(20, 10, 9, z);
            tracker.Process(_frame, _hands);
        }

        private void Square(int left, int top, int side, int z)
        {
            for (int y = top; y < top + side; y++)
            {
                for (int x = left; x < left + side; x++)
                    ((ushort*)(_frame.Depth.Pixels + y * _frame.Depth.Stride))[x] = (ushort)z;
            }
        }
    }
}
