using System;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Tracking
{
    public sealed class DotTrackerTests
    {
        private const long FrameUs = 33_333;
        private const double WidthPx = 1920;
        private readonly int[] _ids = new int[DotTracker.MaxDots * 2];
        private DotTracker _tracker = new DotTracker();
        private long _timeUs;

        [SetUp]
        public void Begin()
        {
            _tracker = new DotTracker();
            _timeUs = 0;
        }

        [Test]
        public void Process_LightSeenOnce_HasNoNumber_SeenTwice_HasOne()
        {
            Assert.That(Next(new Vector2D(100, 100))[0], Is.Zero);
            Assert.That(Next(new Vector2D(105, 100))[0], Is.EqualTo(1));
        }

        [Test]
        public void Process_MinHitsOne_NumbersAtOnce()
        {
            _tracker = new DotTracker(new DotTrackerSettings { MinHits = 1 });
            Assert.That(Next(new Vector2D(100, 100), new Vector2D(900, 100)), Is.EqualTo(new[] { 1, 2 }));
        }

        [Test]
        public void Process_FastTremblingDots_KeepTheirNumbers()
        {
            for (int frame = 0; frame < 200; frame++)
            {
                int[] ids = Next(Way(0, frame), Way(1, frame), Way(2, frame));
                if (frame > 0)
                    Assert.That(ids, Is.EqualTo(new[] { 1, 2, 3 }), "frame " + frame);
            }
        }

        [Test]
        public void Process_DotsThatCross_KeepTheirNumbers()
        {
            for (int frame = 0; frame < 60; frame++)
            {
                var right = new Vector2D(100 + 12 * frame, 500 + 2 * Math.Sin(frame));
                var left = new Vector2D(808 - 12 * frame, 505 + 2 * Math.Cos(frame));
                int[] ids = frame % 2 == 0 ? Next(right, left) : Next(left, right);
                if (frame > 0)
                    Assert.That(ids[frame % 2 == 0 ? 0 : 1], Is.EqualTo(1), "frame " + frame);
            }
        }

        [TestCase(1)]
        [TestCase(3)]
        [TestCase(8)]
        [TestCase(15)]
        [TestCase(24)]
        public void Process_DotHiddenWhileAnotherGoesOn_ComesBackWithItsNumber(int hidden)
        {
            for (int frame = 0; frame < 30; frame++)
                Next(Way(0, frame), Way(1, frame));
            for (int frame = 30; frame < 30 + hidden; frame++)
                Assert.That(Next(Way(1, frame)), Is.EqualTo(new[] { 2 }));
            for (int frame = 30 + hidden; frame < 40 + hidden; frame++)
            {
                int[] ids = Next(Way(0, frame), Way(1, frame));
                if (frame > 30 + hidden)
                    Assert.That(ids, Is.EqualTo(new[] { 1, 2 }));
            }
        }

        [Test]
        public void Process_TwoHiddenDots_ComeBackAsThemselves()
        {
            for (int frame = 0; frame < 30; frame++)
                Next(Way(0, frame), Way(1, frame));
            _timeUs += 10 * FrameUs;
            Next(Way(1, 40), Way(0, 40));
            Assert.That(Next(Way(1, 41), Way(0, 41)), Is.EqualTo(new[] { 2, 1 }));
        }

        [Test]
        public void Process_HiddenForLongerThanTheMemory_IsANewDot()
        {
            for (int frame = 0; frame < 30; frame++)
                Next(new Vector2D(500, 500));
            _timeUs += 1_100_000;
            Next(new Vector2D(500, 500));
            Assert.That(Next(new Vector2D(500, 500))[0], Is.EqualTo(2));
        }

        [Test]
        public void Process_FlashElsewhereHalfASecondAfterAFlash_IsANewDot()
        {
            _tracker = new DotTracker(new DotTrackerSettings { MinHits = 1 });
            Assert.That(Next(new Vector2D(500, 500))[0], Is.EqualTo(1));
            _timeUs += 500_000;
            Assert.That(Next(new Vector2D(700, 500))[0], Is.EqualTo(2), "where a laser went of which one flash was seen nobody knows");
        }

        [Test]
        public void Process_StrayLightWhileADotIsHidden_DoesNotTakeItsNumber()
        {
            for (int frame = 0; frame < 30; frame++)
                Next(Way(0, frame));
            for (int frame = 30; frame < 40; frame++)
                Assert.That(Next(frame == 35 ? Way(0, frame) + new Vector2D(70, 50) : new Vector2D(double.NaN, 0))[0], Is.Zero);
            Next(Way(0, 40));
            Assert.That(Next(Way(0, 41))[0], Is.EqualTo(1));
        }

        [Test]
        public void Process_HandThatJerksFromRest_KeepsItsNumberWhereJumpsAreAllowed()
        {
            _tracker = new DotTracker(new DotTrackerSettings { JumpRadiusPx = 40 });
            for (int frame = 0; frame < 30; frame++)
                Next(new Vector2D(500, 500), new Vector2D(900, 500));
            for (int frame = 1; frame < 6; frame++)
                Assert.That(Next(new Vector2D(500 + 70 * frame, 500 - 50 * frame), new Vector2D(900, 500)), Is.EqualTo(new[] { 1, 2 }), "frame " + frame);
        }

        [TestCase(1920, 8)]
        [TestCase(1920, 15)]
        [TestCase(1920, 30)]
        [TestCase(640, 30)]
        [TestCase(1280, 60)]
        [TestCase(3840, 120)]
        public void Process_OtherPicturesAndRates_MakeNoDifference(int width, int framesPerSecond)
        {
            for (int frame = 0; frame < 2 * framesPerSecond; frame++)
            {
                _tracker.Process(frame * 1_000_000L / framesPerSecond, new[] { Way(0, frame * 30.0 / framesPerSecond) * (width / WidthPx), Way(1, frame * 30.0 / framesPerSecond) * (width / WidthPx) }, width, _ids);
                if (frame > 0)
                    Assert.That((_ids[0], _ids[1]), Is.EqualTo((1, 2)), "frame " + frame);
            }
        }

        [Test]
        public void Process_TimesThatStandStillOrRunBack_DoNoHarm()
        {
            long[] times = { 0, 33_333, 33_333, 10_000, long.MaxValue / 4, 0, long.MinValue / 4, 5 };
            foreach (long time in times)
            {
                _tracker.Process(time, new[] { new Vector2D(300, 300) }, WidthPx, _ids);
                Assert.That(_ids[0], Is.InRange(0, times.Length));
            }
        }

        [Test]
        public void Process_DotsThatAreNoNumbers_HaveNone()
        {
            Next(new Vector2D(double.NaN, 1), new Vector2D(300, 300), new Vector2D(1, double.NegativeInfinity));
            Assert.That(Next(new Vector2D(double.NaN, 1), new Vector2D(300, 300), new Vector2D(1, double.NegativeInfinity)), Is.EqualTo(new[] { 0, 1, 0 }));
        }

        [Test]
        public void Process_MoreThanTheRoom_IsBoundedAndSaysSo()
        {
            var random = new Random(4);
            var many = new Vector2D[10_000];
            var ids = new int[many.Length];
            for (int frame = 0; frame < 20; frame++)
            {
                for (int i = 0; i < many.Length; i++)
                    many[i] = new Vector2D(random.NextDouble() * WidthPx, random.NextDouble() * 1080);
                _tracker.Process(frame * FrameUs, many, WidthPx, ids);
                Assert.That(_tracker.IgnoredDots, Is.GreaterThanOrEqualTo(many.Length - DotTracker.MaxDots));
                Assert.That(ids[DotTracker.MaxDots..], Is.All.Zero);
            }
        }

        [Test]
        public void Process_AnyDots_NeverGivesTwoOfAFrameOneNumber()
        {
            var random = new Random(6);
            for (int frame = 0; frame < 400; frame++)
            {
                var dots = new Vector2D[random.Next(0, 12)];
                for (int i = 0; i < dots.Length; i++)
                    dots[i] = new Vector2D(random.Next(0, 120), random.Next(0, 120));
                int[] ids = Next(dots);
                for (int i = 0; i < ids.Length; i++)
                {
                    for (int j = 0; j < i; j++)
                        Assert.That(ids[i] > 0 && ids[i] == ids[j], Is.False);
                }
            }
        }

        [Test]
        public void Process_OnceWarm_AllocatesNothing()
        {
            var dots = new Vector2D[8];
            int frame = 0;
            Assert.That(Allocation.Of(() =>
            {
                for (int i = 0; i < 50; i++, frame++)
                {
                    for (int d = 0; d < dots.Length; d++)
                        dots[d] = Way(d, frame);
                    _tracker.Process(frame * FrameUs, dots.AsSpan(0, 8 - frame / 10 % 3), WidthPx, _ids);
                }
            }), Is.Zero);
        }

        [Test]
        public void Settings_OutsideTheirRange_AreRefused()
        {
            Assert.That(() => new DotTracker(new DotTrackerSettings { MinHits = 0 }), Throws.ArgumentException);
            Assert.That(() => new DotTracker(new DotTrackerSettings { TremorPx = double.NaN }), Throws.ArgumentException);
            Assert.That(() => new DotTracker(new DotTrackerSettings { MemoryUs = -1 }), Throws.ArgumentException);
        }

        /// <summary>Slow sweeps of up to 10 px a frame with 3 px of tremor at 7 Hz; each number its own.</summary>
        private static Vector2D Way(int number, double frame)
        {
            double turn = 0.02 * frame * (1 + 0.3 * number) + 2 * number, tremor = 2 * Math.PI * 7 * frame / 30 + number;
            return new Vector2D(400 + 130 * number + 300 * Math.Cos(turn) + 3 * Math.Sin(tremor), 540 + 200 * Math.Sin(turn) + 3 * Math.Cos(1.1 * tremor));
        }

        private int[] Next(params Vector2D[] dots)
        {
            _timeUs += FrameUs;
            _tracker.Process(_timeUs, dots, WidthPx, _ids);
            return _ids.AsSpan(0, dots.Length).ToArray();
        }
    }
}
