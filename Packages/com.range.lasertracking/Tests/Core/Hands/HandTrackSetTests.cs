using System;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Kernels;
using NUnit.Framework;

namespace LaserTracking.Hands
{
    public sealed class HandTrackSetTests
    {
        private const long FrameUs = 33_333;

        private DepthGrid _grid = null!;
        private HandTrackSet _tracks = null!;
        private HandObservations _hands = null!;

        [SetUp]
        public void SetUp()
        {
            var settings = new DepthHandSettings();
            using var frame = new Frame();
            new SolidScene { WallMm = 3500 }.Render(frame, 0, 0);
            _grid = new DepthGrid(SolidScene.Camera, settings, KernelRunner.Plain);
            _grid.Fill(frame.Depth);
            _tracks = new HandTrackSet(settings);
            _hands = new HandObservations();
        }

        [Test]
        public void Update_OwnHandHiddenAndANeighboursNear_NumberIsNotTaken()
        {
            int own = Update(0, Fit(0, 1))[0].TrackId;
            int neighbours = Update(1, Fit(100, 2))[0].TrackId;
            Assert.That(neighbours, Is.Not.EqualTo(own));
            HandObservation[] both = Update(2, Fit(70, 2), Fit(40, 1));
            Assert.That(NumberOf(both, 1), Is.EqualTo(own));
            Assert.That(NumberOf(both, 2), Is.EqualTo(neighbours));
        }

        [Test]
        public void Update_HandsExchangePlaces_NumbersStayWithTheirPeople()
        {
            HandObservation[] before = Update(0, Fit(0, 1), Fit(60, 2));
            HandObservation[] after = Update(1, Fit(60, 1), Fit(0, 2));
            Assert.That(NumberOf(after, 1), Is.EqualTo(NumberOf(before, 1)));
            Assert.That(NumberOf(after, 2), Is.EqualTo(NumberOf(before, 2)));
        }

        [Test]
        public void Update_PersonKnownOnlyLater_NumberStays()
        {
            int number = Update(0, Fit(0, 0))[0].TrackId;
            Assert.That(Update(1, Fit(10, 3))[0].TrackId, Is.EqualTo(number));
            Assert.That(Update(2, Fit(20, 0))[0].TrackId, Is.EqualTo(number));
            Assert.That(Update(3, Fit(30, 3))[0].TrackId, Is.EqualTo(number));
        }

        [Test]
        public void Update_ArmTakenForAnothersForAFewFrames_NumberAndPersonStay()
        {
            int number = 0;
            for (int i = 0; i < 5; i++)
                number = Update(i, Fit(20 * i, 1))[0].TrackId;
            for (int i = 5; i < 10; i++)
            {
                HandObservation hand = Update(i, Fit(20 * i, 2))[0];
                Assert.That((hand.TrackId, hand.PersonId), Is.EqualTo((number, 1)), "frame " + i);
            }

            HandObservation anothers = Update(10, Fit(200, 2))[0];
            Assert.That(anothers.PersonId, Is.EqualTo(2), "for good it is the other's");
            Assert.That(anothers.TrackId, Is.Not.EqualTo(number));
        }

        [Test]
        public void Update_HandFartherOffThanAnArmCanMoveIt_IsAnother([Values(110, 150)] double jumpMm)
        {
            int number = 0;
            for (int i = 0; i < 3; i++)
                number = Update(i, Fit(20 * i, 1))[0].TrackId;
            Assert.That(Update(3, Fit(60 + jumpMm, 1))[0].TrackId, Is.Not.EqualTo(number));
        }

        [Test]
        public void Update_HandStopsFromFullSpeed_NumberStays()
        {
            int number = 0;
            for (int i = 0; i < 4; i++)
                number = Update(i, Fit(80 * i, 1))[0].TrackId;
            Assert.That(Update(4, Fit(240, 1))[0].TrackId, Is.EqualTo(number));
        }

        [Test]
        public void TryHolder_WeaponThatWasSomebodysAFrameAgo_IsTheirsForAsLongAsItHadBeen()
        {
            for (int i = 0; i < 4; i++)
                Update(i, Armed(20 * i, 1, 1));
            for (int i = 4; i < 8; i++)
            {
                Assert.That(_tracks.TryHolder(Armed(20 * i, 2, 2).MuzzleMm, i * FrameUs, out int holder), Is.True, "frame " + i);
                Assert.That(holder, Is.EqualTo(1));
                Update(i, Armed(20 * i, 1, 2));
            }

            Assert.That(_tracks.TryHolder(Armed(160, 2, 2).MuzzleMm, 8 * FrameUs, out _), Is.False);
        }

        [Test]
        public void Update_HandComesBackAfterAGap_PalmIsWithheldUntilItsPersonIsSure()
        {
            for (int i = 0; i < 4; i++)
                Update(i, Armed(20 * i, 1, 1));
            Assert.That(Update(4, Armed(80, 1, 1))[0].SigmaMm, Is.LessThan(30));
            Assert.That(Update(9, Armed(180, 1, 1))[0].SigmaMm, Is.GreaterThanOrEqualTo(60));
            Assert.That(Update(10, Armed(200, 1, 1))[0].SigmaMm, Is.LessThan(30));
        }

        [TestCase(60, 4, 1500)]
        [TestCase(0, 8, 1500)]
        [TestCase(0, 4, 1440)]
        public void TryHolder_WeaponElsewhereOrLater_IsNobodys(double awayMm, int frame, double z)
        {
            for (int i = 0; i < 4; i++)
                Update(i, Armed(20 * i, 1, 1));
            ArmFit there = Armed(20 * frame + awayMm, 2, 2);
            Assert.That(_tracks.TryHolder(there.MuzzleMm + new Vector3D(0, 0, z - 1500), frame * FrameUs, out _), Is.False);
        }

        private static ArmFit Armed(double x, int person, int seems)
        {
            ArmFit fit = Fit(x, person);
            fit.HasWeapon = true;
            fit.SeemsId = seems;
            return fit;
        }

        private static ArmFit Fit(double x, int person) => new ArmFit
        {
            PalmMm = new Vector3D(x, 0, 1500),
            SurfaceMm = new Vector3D(x, 0, 1490),
            MuzzleMm = new Vector3D(x, 0, 1300),
            PalmSigmaMm = 8,
            MuzzleSigmaMm = 8,
            Axis = new Vector3D(0, 0, -1),
            HasOneRoot = true,
            PersonId = person,
            SeemsId = person,
        };

        private static int NumberOf(HandObservation[] hands, int person) => Array.Find(hands, h => h.PersonId == person).TrackId;

        private HandObservation[] Update(int frame, params ArmFit[] fits)
        {
            _hands.Begin(frame, frame * FrameUs);
            _tracks.Update(_grid, frame * FrameUs, fits, _hands);
            return _hands.Hands.ToArray();
        }
    }
}
