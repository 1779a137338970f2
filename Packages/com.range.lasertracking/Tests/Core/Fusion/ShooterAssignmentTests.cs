using System;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Tracking;
using NUnit.Framework;

namespace LaserTracking.Fusion
{
    public sealed class ShooterAssignmentTests
    {
        /// <summary>Camera 1 in the middle of the screen's upper edge, looking at the trainees: turned about y by half a turn.</summary>
        private static readonly HandCamera Camera = new HandCamera(
            new PinholeCamera(504, 504, 320, 288, 640, 576),
            new Pose(new Vector3D(1865, 0, 0), Rotation3D.AboutAxis(new Vector3D(0, 1, 0), Math.PI)));

        private HandObservations _hands = null!;
        private ShooterAssignment _assignment = null!;

        [SetUp]
        public void SetUp()
        {
            _hands = new HandObservations();
            _assignment = new ShooterAssignment(Camera);
        }

        [Test]
        public void Fuse_OneHandAimedAtTheDot_IsItsShot()
        {
            var muzzle = new Vector3D(1.5, 1.0, -2.5);
            var dot = new Vector2D(1.2, 0.8);
            See(0, Hand(4, muzzle, dot, HandSide.Right));
            FusedShot fused = _assignment.Fuse(Shot(10_000, LaserColor.Green), dot);
            Assert.That(fused.Shooter, Is.EqualTo(1));
            Assert.That(fused.ShooterProbability, Is.GreaterThan(0.9));
            Assert.That(fused.Hand, Is.EqualTo(HandSide.Right));
            Assert.That(fused.HandTrackId, Is.EqualTo(4));
            Assert.That(fused.HasMuzzle, Is.True);
            Assert.That((fused.MuzzleM - muzzle).Length, Is.LessThan(1e-9));
            Assert.That((fused.Direction - (new Vector3D(dot.X, dot.Y, 0) - muzzle).Normalized).Length, Is.LessThan(1e-8));
            Assert.That(fused.PairDeltaUs, Is.EqualTo(-10_000));
            Assert.That(fused.AimErrorRad, Is.LessThan(1e-6));
        }

        [Test]
        public void Fuse_SideByTheArmAlone_IsNotTheHandThatFires()
        {
            var dot = new Vector2D(1.2, 0.8);
            HandObservation hand = Hand(4, new Vector3D(1.5, 1.0, -2.5), dot, HandSide.Right);
            hand.IsSideSure = false;
            See(0, hand);
            FusedShot fused = _assignment.Fuse(Shot(10_000, LaserColor.Green), dot);
            Assert.That(fused.Shooter, Is.EqualTo(1));
            Assert.That(fused.Hand, Is.EqualTo(HandSide.Unknown));
        }

        [Test]
        public void Fuse_HandAimedElsewhere_IsUnknown()
        {
            See(0, Hand(4, new Vector3D(1.5, 1.0, -2.5), new Vector2D(3.6, 0.2), HandSide.Right));
            FusedShot fused = _assignment.Fuse(Shot(0, LaserColor.Green), new Vector2D(0.1, 2.0));
            Assert.That(fused.Shooter, Is.Zero);
            Assert.That(fused.HasMuzzle, Is.False);
        }

        [Test]
        public void Fuse_NoHandWithinTheWindow_IsUnknown()
        {
            var dot = new Vector2D(1.2, 0.8);
            See(0, Hand(4, new Vector3D(1.5, 1.0, -2.5), dot, HandSide.Right));
            Assert.That(_assignment.Fuse(Shot(1_000_001, LaserColor.Green), dot).Shooter, Is.Zero);
        }

        [Test]
        public void Fuse_HandFartherAwayInTime_IsLessSure()
        {
            var muzzle = new Vector3D(1.5, 1.0, -2.5);
            var dot = new Vector2D(1.2, 0.8);
            double last = 1;
            foreach (long deltaUs in new[] { 0L, 70_000L, 300_000L })
            {
                _assignment = new ShooterAssignment(Camera, new FusionSettings { MinProbability = 0 });
                See(0, Hand(4, muzzle, dot, HandSide.Right));
                FusedShot fused = _assignment.Fuse(Shot(deltaUs, LaserColor.Green), dot);
                Assert.That(fused.PairDeltaUs, Is.EqualTo(-deltaUs));
                Assert.That(fused.ShooterProbability, Is.LessThan(last));
                last = fused.ShooterProbability;
            }
        }

        [Test]
        public void Fuse_TwoAtOnceWithCrossingBeams_EachGetsTheirOwn()
        {
            var left = new Vector2D(0.8, 1.0);
            var right = new Vector2D(2.6, 1.0);
            // The one who stands left aims right, and the other way round.
            See(0, Hand(1, new Vector3D(1.3, 1.1, -2.5), right, HandSide.Unknown), Hand(2, new Vector3D(2.2, 1.1, -2.5), left, HandSide.Unknown));
            var fused = new FusedShot[2];
            _assignment.Fuse(new[] { Shot(0, LaserColor.Green), Shot(0, LaserColor.Green) }, new[] { left, right }, fused);
            Assert.That(fused[0].HandTrackId, Is.EqualTo(2));
            Assert.That(fused[1].HandTrackId, Is.EqualTo(1));
            Assert.That(fused[0].Shooter, Is.EqualTo(1), "numbers follow the order of first shots");
            Assert.That(fused[1].Shooter, Is.EqualTo(2));
        }

        [Test]
        public void Fuse_TwoAtOnceOnNearlyOneSpot_NeverBothToOneHand()
        {
            var a = new Vector2D(1.80, 1.0);
            var b = new Vector2D(1.90, 1.0);
            See(0, Hand(1, new Vector3D(1.3, 1.1, -2.5), a, HandSide.Unknown), Hand(2, new Vector3D(2.2, 1.1, -2.5), a, HandSide.Unknown));
            var fused = new FusedShot[2];
            _assignment.Fuse(new[] { Shot(0, LaserColor.Green), Shot(0, LaserColor.Green) }, new[] { a, b }, fused);
            Assert.That(fused[0].Shooter == 0 || fused[0].HandTrackId != fused[1].HandTrackId, Is.True);
        }

        [Test]
        public void Fuse_GeometryUndecided_UnknownUntilColourTells()
        {
            var one = new Vector3D(1.3, 1.1, -2.5);
            var two = new Vector3D(2.2, 1.1, -2.5);
            var left = new Vector2D(0.6, 1.0);
            var right = new Vector2D(3.0, 1.0);
            var middle = new Vector2D(1.75, 1.0);
            See(0, Hand(1, one, middle, HandSide.Unknown), Hand(2, two, middle, HandSide.Unknown));
            Assert.That(_assignment.Fuse(Shot(0, LaserColor.Red), middle).Shooter, Is.Zero, "either could have fired");
            for (int i = 1; i <= 3; i++)
            {
                long t = i * 2_000_000L;
                See(t, Hand(1, one, left, HandSide.Unknown), Hand(2, two, right, HandSide.Unknown));
                Assert.That(_assignment.Fuse(Shot(t, LaserColor.Green), left).Shooter, Is.EqualTo(1));
                Assert.That(_assignment.Fuse(Shot(t, LaserColor.Red), right).Shooter, Is.EqualTo(2));
            }

            See(9_000_000, Hand(1, one, middle, HandSide.Unknown), Hand(2, two, middle, HandSide.Unknown));
            Assert.That(_assignment.Fuse(Shot(9_000_000, LaserColor.Red), middle).Shooter, Is.EqualTo(2));
        }

        [Test]
        public void Fuse_TrackLostAndFoundAgain_KeepsTheNumber()
        {
            var muzzle = new Vector3D(1.5, 1.0, -2.5);
            var dot = new Vector2D(1.2, 0.8);
            See(0, Hand(4, muzzle, dot, HandSide.Right));
            _assignment.Fuse(Shot(0, LaserColor.Green), dot);
            See(5_000_000, Hand(9, muzzle + new Vector3D(0.2, 0, 0), dot, HandSide.Right));
            Assert.That(_assignment.Fuse(Shot(5_000_000, LaserColor.Green), dot).Shooter, Is.EqualTo(1));
            See(9_000_000, Hand(11, muzzle + new Vector3D(1.2, 0, 0), dot, HandSide.Right));
            Assert.That(_assignment.Fuse(Shot(9_000_000, LaserColor.Green), dot).Shooter, Is.EqualTo(2), "somebody else, elsewhere");
        }

        [Test]
        public void Fuse_PublishedMode_TakesTheNearestInTimeWhereverItAims()
        {
            _assignment = new ShooterAssignment(Camera, new FusionSettings { Mode = FusionMode.Published });
            var dot = new Vector2D(1.2, 0.8);
            See(0, Hand(1, new Vector3D(1.0, 1, -2), dot, HandSide.Unknown));
            See(400_000, Hand(2, new Vector3D(2.0, 1, -2), new Vector2D(3.5, 2), HandSide.Unknown));
            FusedShot fused = _assignment.Fuse(Shot(300_000, LaserColor.Green), dot);
            Assert.That(fused.HandTrackId, Is.EqualTo(2));
            Assert.That(fused.PairDeltaUs, Is.EqualTo(100_000));
            Assert.That(_assignment.Fuse(Shot(1_400_001, LaserColor.Green), dot).HasMuzzle, Is.False);
        }

        [Test]
        public void Fuse_HandGivenToTheWrongNeighbour_IsStillTheOneWhoAimsOverIt()
        {
            var dot = new Vector2D(1.2, 0.8);
            var eyes = new Vector3D(1.4, 0.9, -2.9);
            Vector3D muzzle = eyes + (new Vector3D(dot.X, dot.Y, 0) - eyes).Normalized * 0.75;
            HandObservation hand = Hand(4, muzzle, dot, HandSide.Right);
            hand.PersonId = 2;
            SeePeople(0, new[] { Person(1, eyes), Person(2, eyes + new Vector3D(0.65, 0, 0)) }, hand);
            Assert.That(_assignment.Fuse(Shot(0, LaserColor.Green), dot).Shooter, Is.EqualTo(1));
            SeePeople(5_000_000, new[] { Person(1, eyes), Person(2, eyes + new Vector3D(0.65, 0, 0)) }, Hand(9, muzzle, dot, HandSide.Right));
            Assert.That(_assignment.Fuse(Shot(5_000_000, LaserColor.Green), dot).Shooter, Is.EqualTo(1), "a person, not a track");
        }

        [Test]
        public void Fuse_TwoWhoseHandsAreHidden_IsUnknown()
        {
            SeePeople(0, new[] { Person(1, new Vector3D(1.4, 0.9, -2.9)), Person(2, new Vector3D(2.1, 0.9, -2.9)) });
            FusedShot fused = _assignment.Fuse(Shot(0, LaserColor.Green), new Vector2D(1.7, 0.8));
            Assert.That(fused.Shooter, Is.Zero);
        }

        [TestCase(false, ExpectedResult = true)]
        [TestCase(true, ExpectedResult = false)]
        public bool Fuse_EyesHiddenDotBesideTheLine_IsTheirsUnlessTheWeaponIsSeenToPointElsewhere(bool isWeaponSeen)
        {
            var eyes = new Vector3D(1.6, 0.9, -3.2);
            PersonObservation person = Person(1, eyes);
            person.SigmaMm = 150;
            HandObservation hand = Aimed(1, eyes, new Vector2D(1.2, 0.9));
            hand.AimDirection = default;
            if (isWeaponSeen)
                hand.WeaponDirection = Camera.PoseInScreenMm.InverseTransformDirection(Camera.ToScreenM(hand.MuzzleMm) - eyes).Normalized;
            SeePeople(0, new[] { person }, hand);
            return _assignment.Fuse(Shot(0, LaserColor.Green), new Vector2D(2.35, 0.9)).Shooter > 0;
        }

        [Test]
        public void Fuse_SteadyOffsetOfTheAim_IsLearned()
        {
            // The eyes as seen are 80 mm beside those over which is aimed: two persons' lines differ by less.
            var aimed = new Vector3D(1.4, 0.9, -2.9);
            PersonObservation[] people = { Person(1, aimed + new Vector3D(0.08, 0, 0)) };
            double first = 0, last = 0;
            for (int i = 0; i < 6; i++)
            {
                var dot = new Vector2D(0.6 + 0.4 * i, 0.5 + 0.2 * (i % 3));
                HandObservation hand = Hand(4, aimed + (new Vector3D(dot.X, dot.Y, 0) - aimed).Normalized * 0.75, dot, HandSide.Right);
                hand.PersonId = 1;
                SeePeople(i * 2_000_000L, people, hand);
                last = _assignment.Fuse(Shot(i * 2_000_000L, LaserColor.Green), dot).SightErrorRad;
                if (i == 0)
                    first = last;
            }

            Assert.That(first, Is.GreaterThan(0.08));
            Assert.That(last, Is.LessThan(0.3 * first));
        }

        [Test]
        public void Fuse_FirstShotThatCouldNotBeTold_TeachesOnceTheOthersLineIsKnown()
        {
            // Both aim 100 mm beside the eyes as seen, and first at nearly one place. Then the first one fires alone until their line is
            // known: after that the very first shot must have been the other's, whose line it shows.
            Vector3D one = new Vector3D(1.2, 0.9, -2.9), two = new Vector3D(2.2, 0.9, -2.9), off = new Vector3D(0.1, 0, 0);
            PersonObservation[] people = { Person(1, one + off), Person(2, two + off) };
            var near = new Vector2D(1.7, 1.0);
            Vector2D nearly = near + new Vector2D(0.12, 0);
            SeePeople(0, people, Aimed(1, one, nearly), Aimed(2, two, near));
            Assert.That(_assignment.Fuse(Shot(0, LaserColor.Green), near).Shooter, Is.Zero, "either could have fired");
            double before = SightError(two, people, 1_000_000);
            for (int i = 0; i < 8; i++)
            {
                long time = 2_000_000 + i * 1_000_000L;
                var dot = new Vector2D(0.4 + 0.3 * (i % 4), 0.4 + 0.3 * (i % 3));
                SeePeople(time, people, Aimed(1, one, dot), Aimed(2, two, new Vector2D(3.2, 1.8)));
                Assert.That(_assignment.Fuse(Shot(time, LaserColor.Green), dot).HandTrackId, Is.EqualTo(1));
                for (int frame = 1; frame < 10; frame++)
                    SeePeople(time + frame * 33_000L, people, Aimed(1, one, dot), Aimed(2, two, new Vector2D(3.2, 1.8)));
            }

            Assert.That(SightError(two, people, 12_000_000), Is.LessThan(0.3 * before));
        }

        [TestCase(0.15)]
        [TestCase(0.4)]
        public void Fuse_ShotPastAWellKnownLine_LeavesIt(double asideM)
        {
            var aimed = new Vector3D(1.4, 0.9, -2.9);
            PersonObservation[] people = { Person(1, aimed + new Vector3D(0.08, 0, 0)) };
            for (int i = 0; i < 8; i++)
                Fire(i * 1_000_000L, new Vector2D(0.5 + 0.3 * (i % 5), 0.5 + 0.3 * (i % 3)), default);
            double before = SightError(aimed, people, 9_000_000, 1);
            Fire(10_000_000, new Vector2D(1.2, 0.8), new Vector2D(asideM, 0));
            Assert.That(SightError(aimed, people, 12_000_000, 1), Is.LessThan(before + 0.003));

            void Fire(long timeUs, Vector2D dot, Vector2D aside)
            {
                SeePeople(timeUs, people, Aimed(1, aimed, dot));
                _assignment.Fuse(Shot(timeUs, LaserColor.Green), dot + aside);
                for (int frame = 1; frame < 20; frame++)
                    SeePeople(timeUs + frame * 33_000L, people, Aimed(1, aimed, dot));
            }
        }

        [Test]
        public void Fuse_FiftyShotsAtOnce_StaysBoundedAndGivesOneEach()
        {
            var dot = new Vector2D(1.2, 0.8);
            See(0, Hand(4, new Vector3D(1.5, 1.0, -2.5), dot, HandSide.Right));
            var shots = new Shot[50];
            var places = new Vector2D[50];
            Array.Fill(places, dot);
            var fused = new FusedShot[50];
            _assignment.Fuse(shots, places, fused);
            int known = 0;
            foreach (FusedShot one in fused)
                known += one.Shooter > 0 ? 1 : 0;
            Assert.That(known, Is.LessThanOrEqualTo(1));
        }

        [Test]
        public void Fuse_OnceWarm_AllocatesNothing()
        {
            var dot = new Vector2D(1.2, 0.8);
            var shots = new Shot[3];
            var places = new[] { dot, new Vector2D(2, 1), new Vector2D(3, 1) };
            var fused = new FusedShot[3];
            SeePeople(0, new[] { Person(1, new Vector3D(1.6, 0.9, -3.2)) }, Hand(4, new Vector3D(1.5, 1.0, -2.5), dot, HandSide.Right));
            _assignment.Fuse(shots, places, fused);
            long allocated = Allocation.Of(() =>
            {
                _assignment.AddHands(_hands);
                _assignment.Fuse(shots, places, fused);
                _assignment.Fuse(shots[0], dot);
            });
            Assert.That(allocated, Is.Zero);
        }

        /// <summary>How far from their line of sight a shot of the second person passes.</summary>
        private double SightError(Vector3D pivot, PersonObservation[] people, long timeUs, int person = 2)
        {
            var dot = new Vector2D(2.9, 0.6);
            SeePeople(timeUs, people, Aimed(person, pivot, dot));
            return _assignment.Fuse(Shot(timeUs, LaserColor.Unknown), dot).SightErrorRad;
        }

        private static HandObservation Aimed(int person, Vector3D pivot, Vector2D dot)
        {
            HandObservation hand = Hand(person, pivot + (new Vector3D(dot.X, dot.Y, 0) - pivot).Normalized * 0.75, dot, HandSide.Unknown);
            hand.PersonId = person;
            hand.MuzzleSigmaMm = 5;
            return hand;
        }

        private static Shot Shot(long timeUs, LaserColor color) => new Shot { TimeUs = timeUs, Dot = new Dot { Color = color } };

        private static HandObservation Hand(int track, Vector3D muzzleM, Vector2D aimedAtM, HandSide side)
        {
            Vector3D muzzle = Camera.ToCameraMm(muzzleM);
            Vector3D axis = (Camera.ToCameraMm(new Vector3D(aimedAtM.X, aimedAtM.Y, 0)) - muzzle).Normalized;
            return new HandObservation
            {
                TrackId = track, Side = side, IsSideSure = true, MuzzleMm = muzzle, PalmMm = muzzle - axis * 130, AimDirection = axis,
                SigmaMm = 12, MuzzleSigmaMm = 20, AimSigmaRad = 0.08,
            };
        }

        private static PersonObservation Person(int id, Vector3D eyesM) =>
            new PersonObservation { PersonId = id, EyeMm = Camera.ToCameraMm(eyesM), SigmaMm = 60 };

        private void See(long timeUs, params HandObservation[] hands) => SeePeople(timeUs, new PersonObservation[0], hands);

        private void SeePeople(long timeUs, PersonObservation[] people, params HandObservation[] hands)
        {
            _hands.Begin(0, timeUs);
            foreach (PersonObservation person in people)
                _hands.Add(person);
            foreach (HandObservation hand in hands)
                _hands.Add(hand);
            _assignment.AddHands(_hands);
        }
    }
}
