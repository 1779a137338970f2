using System;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Tracking
{
    public sealed class ShotTrackerTests
    {
        private readonly Detections _detections = new Detections();
        private ShotTracker _tracker = new ShotTracker();
        private long _intervalUs;

        [SetUp]
        public void NewTracker()
        {
            _tracker = new ShotTracker();
            _intervalUs = 33_333;
        }

        [Test]
        public void Process_ConclusiveDotOverThreeFrames_IsOneShotAtItsFirstPlace()
        {
            Frame(0);
            Frame(1, Dot(100, 100, true));
            Assert.That(_tracker.Shots.Length, Is.EqualTo(1));
            Shot shot = _tracker.Shots[0];
            Frame(2, Dot(118, 105, true));
            Assert.That(_tracker.Shots.Length, Is.EqualTo(0));
            Assert.That(_tracker.Dots.Length, Is.EqualTo(1));
            Assert.That(_tracker.Dots[0].TrackId, Is.EqualTo(shot.TrackId));
            Frame(3, Dot(136, 110, true));
            Assert.That(_tracker.Shots.Length, Is.EqualTo(0));
            Assert.That(shot.Dot.PositionPx, Is.EqualTo(new Vector2D(100, 100)));
            Assert.That(shot.TimeSigmaUs, Is.EqualTo(33333 / Math.Sqrt(6)).Within(1), "any shutter");
        }

        [Test]
        public void Process_FaintFirstLightFifteenPixelsAway_IsLinkedAndGivesTheFirstFrame()
        {
            Frame(0);
            Frame(1, Dot(100, 100, false));
            Assert.That(_tracker.Shots.Length, Is.EqualTo(0));
            Frame(2, Dot(112, 109, true));
            Assert.That(_tracker.Shots.Length, Is.EqualTo(1));
            Assert.That(_tracker.Shots[0].FirstFrameIndex, Is.EqualTo(1));
            Assert.That(_tracker.Shots[0].FrameIndex, Is.EqualTo(2));
            Assert.That(_tracker.Shots[0].Dot.PositionPx.X, Is.EqualTo(100));
        }

        [Test]
        public void Process_InconclusiveDotThatVanishesSharply_CountsOneFrameLater()
        {
            Frame(0);
            Frame(1, Dot(100, 100, false));
            Frame(2);
            Assert.That(_tracker.Shots.Length, Is.EqualTo(1));
            Assert.That(_tracker.Shots[0].FrameIndex, Is.EqualTo(2));
            Assert.That(_tracker.Shots[0].LastFrameIndex, Is.EqualTo(1));
        }

        [Test]
        public void Process_InconclusiveDotThatLeavesSomethingBehind_IsNotConfirmed()
        {
            Frame(0);
            Frame(1, Dot(100, 100, false));
            Begin(2);
            _detections.Reject(new RejectedCandidate { PositionPx = new Vector2D(102, 100), Reason = RejectionReason.NotIsolated });
            _tracker.Process(_detections);
            Assert.That(_tracker.Shots.Length, Is.EqualTo(0));
            Assert.That(_tracker.Rejected.Length, Is.EqualTo(1));
            Assert.That(_tracker.Rejected[0].Reason, Is.EqualTo(RejectionReason.NotConfirmed));
        }

        [Test]
        public void Process_InconclusiveDotThatStays_IsNotConfirmed()
        {
            Frame(0);
            int shots = 0, rejected = 0;
            for (int i = 1; i < 15; i++)
            {
                Frame(i, Dot(100, 100, false, i == 1));
                shots += _tracker.Shots.Length;
                rejected += _tracker.Rejected.Length;
            }

            Assert.That(shots, Is.EqualTo(0));
            Assert.That(rejected, Is.GreaterThan(0));
        }

        [Test]
        public void Process_DoubleTapAtOneSpot_AreTwoShotsOfOneTrack()
        {
            Frame(0);
            Frame(1, Dot(100, 100, true));
            int track = _tracker.Shots[0].TrackId;
            Frame(2);
            Frame(3);
            Frame(4, Dot(101, 100, true));
            Assert.That(_tracker.Shots.Length, Is.EqualTo(1));
            Assert.That(_tracker.Shots[0].Id, Is.EqualTo(2));
            Assert.That(_tracker.Shots[0].TrackId, Is.EqualTo(track));
        }

        [Test]
        public void Process_DotMissedForOneFrame_IsNoNewShot()
        {
            Frame(0);
            Frame(1, Dot(100, 100, true));
            Frame(2);
            Frame(3, Dot(101, 100, true, false));
            Assert.That(_tracker.Shots.Length, Is.EqualTo(0));
            Assert.That(_tracker.Dots.Length, Is.EqualTo(1));
        }

        [Test]
        public void Process_TwoDotsThatSwapPlacesInTheList_KeepTheirTracks()
        {
            Frame(0);
            Frame(1, Dot(100, 100, true), Dot(120, 100, true));
            Assert.That(_tracker.Shots.Length, Is.EqualTo(2));
            int left = _tracker.Shots[0].TrackId;
            Frame(2, Dot(123, 101, true, false), Dot(99, 100, true, false));
            Assert.That(_tracker.Shots.Length, Is.EqualTo(0));
            foreach (TrackedDot dot in _tracker.Dots)
                Assert.That(dot.TrackId == left, Is.EqualTo(dot.Dot.PositionPx.X < 110));
        }

        [Test]
        public void Process_HeldDotsThatCross_KeepTheirNumbersAndAreNoNewShots()
        {
            Frame(0);
            for (int frame = 1; frame < 40; frame++)
            {
                Dot right = Dot(100 + 4 * frame, 100, true, frame == 1), left = Dot(258 - 4 * frame, 102, true, frame == 1);
                Frame(frame, frame % 2 == 0 ? new[] { left, right } : new[] { right, left });
                Assert.That(_tracker.Shots.Length, Is.EqualTo(frame == 1 ? 2 : 0));
                foreach (TrackedDot dot in _tracker.Dots)
                    Assert.That(dot.TrackId, Is.EqualTo(dot.Dot.PositionPx.Y < 101 ? 1 : 2), "frame " + frame);
            }
        }

        [Test]
        public void Process_HeldDotThatJerks_KeepsTheNumberOfItsShot()
        {
            Frame(0);
            for (int frame = 1; frame < 20; frame++)
            {
                Frame(frame, Dot(frame < 10 ? 100 : 130, 100, true, frame == 1));
                Assert.That(_tracker.Dots[0].TrackId, Is.EqualTo(1), "frame " + frame);
            }
        }

        [TestCase(15)]
        [TestCase(30)]
        public void Process_LaserHeldOnAndSwungAcrossThePicture_IsOneShot(int framesPerSecond)
        {
            _intervalUs = 1_000_000 / framesPerSecond;
            Frame(0);
            int shots = 0;
            for (int frame = 1; frame < 3 * framesPerSecond; frame++)
            {
                // Swings of 280 px to either side in 0.7 s: 2500 px a second in the middle, half of which each frame smears.
                double Place(double at) => 320 + 280 * Math.Sin(2 * Math.PI * (at - 1) / framesPerSecond / 0.7);
                double way = (Place(frame + 0.25) - Place(frame - 0.25)) * 30 / framesPerSecond;
                Frame(frame, Smeared(Place(frame), 100, way));
                shots += _tracker.Shots.Length;
            }

            Assert.That(shots, Is.EqualTo(1));
        }

        [Test]
        public void Process_LaserSwungTooFastForAnySmear_IsNoNewShotOnceItsWayIsKnown()
        {
            Frame(0);
            int shots = 0;
            for (int frame = 1; frame < 11; frame++)
            {
                Frame(frame, Dot(50 * frame, 100 + frame * frame / 2, true));
                shots += _tracker.Shots.Length;
            }

            Assert.That(shots, Is.EqualTo(2), "the first and the second place might be those of two lasers");
        }

        [TestCase(LaserColor.Green, LaserColor.Red, 2)]
        [TestCase(LaserColor.Green, LaserColor.Unknown, 1)]
        [TestCase(LaserColor.Green, LaserColor.Green, 1)]
        public void Process_FlashNearAnotherInTheNextFrame_IsAShotOfItsOwnIfItsColorIsAnother(LaserColor first, LaserColor second, int shots)
        {
            Dot before = Dot(100, 100, true), after = Dot(120, 100, true);
            before.Color = first;
            after.Color = second;
            Frame(0);
            Frame(1, before);
            Frame(2, after);
            Assert.That(_tracker.Shots.Length, Is.EqualTo(shots - 1));
        }

        [Test]
        public void Process_DotThatSmearsTheWayItWentAndLooksOfAnotherColor_IsNoNewShot()
        {
            Dot before = Smeared(100, 100, 8), after = Smeared(120, 100, 8);
            before.Color = LaserColor.Green;
            after.Color = LaserColor.Red;
            Frame(0);
            Frame(1, before);
            Frame(2, after);
            Assert.That(_tracker.Shots.Length, Is.EqualTo(0));
        }

        [TestCase(8, 0)]
        [TestCase(20, 1)]
        public void Process_LightThatBeginsAfterADarkFrame_IsAShotOfItsOwnUnlessAtTheSameSpot(double apartPx, int shots)
        {
            _intervalUs = 16_667;
            Frame(0);
            Frame(1, Dot(100, 100, true));
            Frame(2);
            Frame(3, Dot(100 + apartPx, 100, true));
            Assert.That(_tracker.Shots.Length, Is.EqualTo(shots));
        }

        [TestCase(7, 5, true)]
        [TestCase(30, 10, true)]
        [TestCase(30, 11, false)]
        [TestCase(60, 20, true)]
        [TestCase(60, 21, false)]
        [TestCase(120, 40, true)]
        public void Process_InconclusiveDotOfSomeFrames_IsAShotUpToTheSameDurationAtEveryRate(int framesPerSecond, int frames, bool isShot)
        {
            _intervalUs = 1_000_000 / framesPerSecond;
            Frame(0);
            int shots = 0;
            for (int frame = 1; frame <= frames + 1; frame++)
            {
                Frame(frame, frame <= frames ? new[] { Dot(100, 100, false, frame == 1) } : new Dot[0]);
                shots += _tracker.Shots.Length;
            }

            Assert.That(shots, Is.EqualTo(isShot ? 1 : 0));
        }

        [Test]
        public void Finish_WaitingDot_IsNotConfirmed()
        {
            Frame(0);
            Frame(1, Dot(100, 100, false));
            _tracker.Finish();
            Assert.That(_tracker.Shots.Length, Is.EqualTo(0));
            Assert.That(_tracker.Rejected.Length, Is.EqualTo(1));
        }

        [Test]
        public void Process_MoreDotsThanRoom_NeitherFailsNorAllocates()
        {
            var crowd = new Detections(4000);
            int index = 0;
            Assert.That(Allocation.Of(() => Crowd(crowd, index++)), Is.EqualTo(0));
        }

        [Test]
        public void Constructor_BadSetting_NamesIt()
        {
            ArgumentException? error = Assert.Throws<ArgumentException>(() => new ShotTracker(new ShotTrackerSettings { LinkRadiusPx = double.NaN }));
            Assert.That(error!.Message, Does.Contain("LinkRadiusPx"));
        }

        private static Dot Dot(double x, double y, bool conclusive, bool onset = true) =>
            new Dot { PositionPx = new Vector2D(x, y), IsConclusive = conclusive, IsOnset = onset };

        /// <summary>Of a round dot of 2 px that moved along x while the shutter was open.</summary>
        private static Dot Smeared(double x, double y, double wayPx)
        {
            Dot dot = Dot(x, y, true);
            dot.ShapePx = new Covariance2D(4 + wayPx * wayPx / 12, 0, 4);
            return dot;
        }

        private void Begin(int index)
        {
            _detections.Begin(index, index * _intervalUs);
            _detections.ImageWidthPx = 640;
        }

        private void Frame(int index, params Dot[] dots)
        {
            Begin(index);
            foreach (Dot dot in dots)
                _detections.Add(dot);
            _tracker.Process(_detections);
        }

        private void Crowd(Detections crowd, int index)
        {
            crowd.Begin(index, index * 33333L);
            crowd.ImageWidthPx = 640;
            for (int i = 0; i < 4000; i++)
                crowd.Add(Dot(i % 63 * 10, i / 63 * 10, i % 2 == 0));
            _tracker.Process(crowd);
        }
    }
}
