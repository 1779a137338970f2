using System;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using NUnit.Framework;

namespace LaserTracking.Fusion
{
    /// <summary>Two people 0.6 m apart, eyes 2.5 m from the screen; columns 0 and 1.</summary>
    public sealed class HandOwnersTests
    {
        private static readonly HandCamera Camera = new HandCamera(
            new PinholeCamera(504, 504, 320, 288, 640, 576),
            new Pose(new Vector3D(1865, 0, 0), Rotation3D.AboutAxis(new Vector3D(0, 1, 0), Math.PI)));

        private static readonly Vector3D Left = new Vector3D(1.4, 0.65, -2.5);
        private static readonly Vector3D Right = new Vector3D(2.0, 0.65, -2.5);
        private static readonly Vector3D Between = new Vector3D(1.7, 0.7, -1.86);
        private static readonly int[] People = { 1, 2 };

        private HandOwners _owners = null!;

        [SetUp]
        public void SetUp()
        {
            var settings = new FusionSettings();
            var sights = new SightLines(settings);
            sights.See(new PersonObservation { PersonId = 1, EyeMm = Camera.ToCameraMm(Left), SigmaMm = 45 }, Camera, 0);
            sights.See(new PersonObservation { PersonId = 2, EyeMm = Camera.ToCameraMm(Right), SigmaMm = 45 }, Camera, 0);
            _owners = new HandOwners(Camera, settings, sights);
        }

        [Test]
        public void ShareOut_WeaponInTheMiddleWithoutBearing_IsWhoseTheArmSeems()
        {
            _owners.ShareOut(new[] { Weapon(1, Between, default) }, People);
            Assert.That(_owners.Share(0, 0), Is.GreaterThan(0.7));
            Assert.That(_owners.Share(1, 0), Is.LessThan(0.3));
        }

        [Test]
        public void ShareOut_WeaponThatPointsAwayFromTheNeighbour_IsTheNeighbours()
        {
            _owners.ShareOut(new[] { Weapon(1, Between, Between - Right) }, People);
            Assert.That(_owners.Share(1, 0), Is.GreaterThan(0.8));
            Assert.That(_owners.Visible(1), Is.GreaterThan(0.8));
            Assert.That(_owners.Visible(0), Is.LessThan(0.2), "their own weapon may be hidden");
        }

        [Test]
        public void Share_HandOfSomebodyWhoseWeaponIsSeen_IsNotWhatTheyFireWith()
        {
            Vector3D raised = Left + new Vector3D(0.05, 0.05, 0.7), other = Left + new Vector3D(-0.2, 0.3, 0.5);
            PairedHand support = Weapon(1, other, default);
            support.Hand.TrackId = 2;
            support.Hand.MuzzleSigmaMm = 36;
            _owners.ShareOut(new[] { Weapon(1, raised, raised - Left), support }, People);
            Assert.That(_owners.Share(0, 0), Is.GreaterThan(0.95));
            Assert.That(_owners.Share(0, 1), Is.LessThan(0.05));
        }

        [Test]
        public void Visible_HandThatHangsDown_LeavesTheWeaponHidden()
        {
            // A cuff that looks like a muzzle, a metre below the eyes.
            Vector3D hanging = Right + new Vector3D(0.05, 1, 0);
            _owners.ShareOut(new[] { Weapon(2, hanging, new Vector3D(0, 0, 1)) }, People);
            Assert.That(_owners.Visible(1), Is.LessThan(0.5));
        }

        [Test]
        public void Visible_SeenLongBefore_LeavesTheWeaponHidden()
        {
            PairedHand earlier = Weapon(1, Left + new Vector3D(0.05, 0.05, 0.7), default);
            earlier.DeltaUs = -300_000;
            _owners.ShareOut(new[] { earlier }, People);
            Assert.That(_owners.Visible(0), Is.Zero);
            Assert.That(_owners.Share(0, 0), Is.GreaterThan(0.8), "but it is the best that is known of it");
        }

        private static PairedHand Weapon(int person, Vector3D muzzleM, Vector3D alongM) => new PairedHand
        {
            Hand = new HandObservation
            {
                TrackId = 1,
                PersonId = person,
                MuzzleMm = Camera.ToCameraMm(muzzleM),
                MuzzleSigmaMm = 4,
                WeaponDirection = Camera.PoseInScreenMm.InverseTransformDirection(alongM).Normalized,
            },
        };
    }
}
