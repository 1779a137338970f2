using LaserTracking.Geometry;
using LaserTracking.Hands;
using NUnit.Framework;

namespace LaserTracking.Fusion
{
    public sealed class HandHistoryTests
    {
        private readonly PairedHand[] _pairs = new PairedHand[8];

        [Test]
        public void At_BetweenTwoSightings_Interpolates()
        {
            var history = new HandHistory();
            Add(history, 100_000, 1, 10);
            Add(history, 140_000, 1, 50);
            Assert.That(history.At(110_000, 1_000_000, 250_000, _pairs), Is.EqualTo(1));
            Assert.That(_pairs[0].Hand.MuzzleMm.X, Is.EqualTo(20).Within(1e-9));
            Assert.That(_pairs[0].DeltaUs, Is.EqualTo(-10_000));
            Assert.That(_pairs[0].IsInterpolated, Is.True);
        }

        [Test]
        public void At_AfterTheLastSighting_GivesItAsItWas()
        {
            var history = new HandHistory();
            Add(history, 100_000, 1, 10);
            Add(history, 140_000, 1, 50);
            Assert.That(history.At(150_000, 1_000_000, 250_000, _pairs), Is.EqualTo(1));
            Assert.That(_pairs[0].Hand.MuzzleMm.X, Is.EqualTo(50));
            Assert.That(_pairs[0].DeltaUs, Is.EqualTo(-10_000));
            Assert.That(_pairs[0].IsInterpolated, Is.False);
        }

        [Test]
        public void At_SightingsFarApart_TakesTheNearer()
        {
            var history = new HandHistory();
            Add(history, 0, 1, 10);
            Add(history, 900_000, 1, 50);
            history.At(500_000, 1_000_000, 250_000, _pairs);
            Assert.That(_pairs[0].Hand.MuzzleMm.X, Is.EqualTo(50));
            Assert.That(_pairs[0].DeltaUs, Is.EqualTo(400_000));
        }

        [Test]
        public void Shift_ClockThatWasLate_GivesTheSightingsOfTheirTrueTime()
        {
            var history = new HandHistory();
            Add(history, 170_000, 1, 10);
            Add(history, 210_000, 1, 50);
            history.Shift(-70_000);
            Add(history, 180_000, 1, 90);
            Assert.That(history.At(130_000, 1_000_000, 250_000, _pairs), Is.EqualTo(1));
            Assert.That(_pairs[0].Hand.MuzzleMm.X, Is.EqualTo(40).Within(1e-9));
            history.At(160_000, 1_000_000, 250_000, _pairs);
            Assert.That(_pairs[0].Hand.MuzzleMm.X, Is.EqualTo(70).Within(1e-9), "between an old sighting and a new one");
        }

        [Test]
        public void At_OutsideTheWindow_GivesNone()
        {
            var history = new HandHistory();
            Add(history, 0, 1, 10);
            Assert.That(history.At(1_000_000, 1_000_000, 0, _pairs), Is.EqualTo(1), "at the window's edge");
            Assert.That(history.At(1_000_001, 1_000_000, 0, _pairs), Is.Zero);
        }

        [Test]
        public void At_SeveralHands_AreOrderedByTrack()
        {
            var history = new HandHistory();
            Add(history, 0, 7, 10);
            Add(history, 0, 3, 10);
            Add(history, 1000, 7, 10);
            Assert.That(history.At(0, 1_000_000, 0, _pairs), Is.EqualTo(2));
            Assert.That(_pairs[0].Hand.TrackId, Is.EqualTo(3));
            Assert.That(_pairs[1].Hand.TrackId, Is.EqualTo(7));
        }

        [Test]
        public void Add_MoreThanTheCapacity_ForgetsTheOldest()
        {
            var history = new HandHistory(4);
            for (int i = 0; i < 10; i++)
                Add(history, i * 1000, 1, i);
            Assert.That(history.Count, Is.EqualTo(4));
            history.At(0, 1_000_000, 0, _pairs);
            Assert.That(_pairs[0].Hand.MuzzleMm.X, Is.EqualTo(6));
        }

        [Test]
        public void Add_FrameThatComesLate_IsPutInItsPlace()
        {
            var history = new HandHistory(3);
            Add(history, 200_000, 1, 20);
            Add(history, 100_000, 1, 10);
            Add(history, 300_000, 1, 30);
            history.At(150_000, 1_000_000, 250_000, _pairs);
            Assert.That(_pairs[0].Hand.MuzzleMm.X, Is.EqualTo(15).Within(1e-9));
            Add(history, 50_000, 1, 5);
            Assert.That(history.Count, Is.EqualTo(3), "older than all that is kept: no room for it");
            history.At(50_000, 1_000_000, 250_000, _pairs);
            Assert.That(_pairs[0].Hand.MuzzleMm.X, Is.EqualTo(10));
        }

        [Test]
        public void At_HandThatMoves_GivesItsVelocity()
        {
            var history = new HandHistory();
            for (int i = 0; i < 8; i++)
                Add(history, i * 33_000, 1, i * 16.5);
            history.At(240_000, 1_000_000, 250_000, _pairs);
            Assert.That(_pairs[0].MuzzleVelocityMmS.X, Is.EqualTo(500).Within(1e-6));
            Assert.That(_pairs[0].VelocitySeconds, Is.EqualTo(0.099).Within(1e-9));
        }

        [Test]
        public void At_HandSeenOnce_HasNoVelocity()
        {
            var history = new HandHistory();
            Add(history, 0, 1, 10);
            history.At(0, 1_000_000, 250_000, _pairs);
            Assert.That(_pairs[0].VelocitySeconds, Is.Zero);
        }

        [Test]
        public void Steady_WeaponAtRestAfterASwing_IsTheMeanOfTheRest()
        {
            var history = new HandHistory();
            Add(history, 0, 1, 400);
            Add(history, 33_000, 1, 120);
            Add(history, 66_000, 1, 101);
            Add(history, 99_000, 1, 98);
            Add(history, 99_000, 2, 500);
            Add(history, 132_000, 1, 101);
            Add(history, 165_000, 1, 300);
            Assert.That(history.Steady(1, 0, 140_000, 8, out Vector3D muzzle), Is.EqualTo(3));
            Assert.That(muzzle.X, Is.EqualTo(100).Within(1e-9));
        }

        [Test]
        public void Steady_TrackThatWasNotSeen_IsNone()
        {
            var history = new HandHistory();
            Add(history, 0, 1, 400);
            Assert.That(history.Steady(7, 0, 140_000, 8, out _), Is.Zero);
            Assert.That(history.Steady(1, 10_000, 140_000, 8, out _), Is.Zero);
        }

        [Test]
        public void CopyTrack_OfSeveralHands_GivesOneInOrderOfTime()
        {
            var history = new HandHistory();
            for (int i = 0; i < 10; i++)
                Add(history, i * 10_000, 1 + i % 2, i);
            var hands = new HandObservation[3];
            var times = new long[3];
            Assert.That(history.CopyTrack(1, 10_000, 70_000, hands, times), Is.EqualTo(3));
            Assert.That(times, Is.EqualTo(new long[] { 20_000, 40_000, 60_000 }));
            Assert.That(hands[2].MuzzleMm.X, Is.EqualTo(6));
        }

        private static void Add(HandHistory history, long timeUs, int track, double x)
        {
            var hands = new HandObservations();
            hands.Begin(0, timeUs);
            hands.Add(new HandObservation { TrackId = track, MuzzleMm = new Vector3D(x, 0, 1000), PalmMm = new Vector3D(x, 0, 1100) });
            history.Add(hands);
        }
    }
}
