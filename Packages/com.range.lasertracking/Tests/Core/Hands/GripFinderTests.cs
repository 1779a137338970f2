using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Hands
{
    /// <summary>A level camera that looks at two people 0.42 m apart; what is seen of a weapon is made up.</summary>
    public sealed class GripFinderTests
    {
        private const double GripToMuzzleMm = 150;
        private const double BoreAboveGripMm = 50;

        /// <summary>A palm known worse is not stated.</summary>
        private const double StatedMm = 20;

        private static readonly Vector3D Left = new Vector3D(-210, -300, 2400);
        private static readonly Vector3D Right = new Vector3D(210, -300, 2400);
        private static readonly Vector3D Muzzle = new Vector3D(-60, -180, 1650);

        [Test]
        public void Find_WeaponOfItsPerson_PalmLiesAGripBehindIt()
        {
            ArmFit fit = Fit(1, Aim(Left));
            Find(ref fit);
            Assert.That((fit.GripMm - Grip(Left)).Length, Is.LessThan(10));
            Assert.That(fit.GripSigmaMm, Is.GreaterThan(4).And.LessThan(12));
        }

        [Test]
        public void Find_ArmGivenToANeighbour_PalmLiesOnTheLineThatTheWeaponShows()
        {
            ArmFit fit = Fit(1, Aim(Right));
            Find(ref fit);
            Assert.That((Grip(Right) - Grip(Left)).Length, Is.GreaterThan(60), "it makes a difference");
            Assert.That((fit.GripMm - Grip(Right)).Length, Is.LessThan(10));
            Assert.That(fit.GripSigmaMm, Is.LessThan(StatedMm));
        }

        [Test]
        public void Find_WeaponBetweenTwo_SaysThatItMayBeEithers()
        {
            ArmFit fit = Fit(1, (Aim(Left) + Aim(Right)).Normalized);
            fit.PersonId = 0;
            fit.HasSurface = false;
            Find(ref fit);
            Assert.That(fit.GripSigmaMm, Is.GreaterThan(StatedMm));
        }

        [Test]
        public void Find_WeaponThatIsNobodys_IsTooLittleKnown()
        {
            ArmFit fit = Fit(1, new Vector3D(-0.9, 0, -0.4).Normalized);
            Find(ref fit);
            Assert.That(fit.GripSigmaMm, Is.GreaterThan(StatedMm));
        }

        [Test]
        public void Find_NoWeaponSeen_TellsNothing()
        {
            ArmFit fit = Fit(1, Aim(Left));
            fit.HasWeapon = false;
            Find(ref fit);
            Assert.That(fit.GripSigmaMm, Is.Zero);
        }

        private static Vector3D Aim(Vector3D eye) => (Muzzle - eye).Normalized;

        private static Vector3D Grip(Vector3D eye) => Muzzle - Aim(eye) * GripToMuzzleMm + new Vector3D(0, BoreAboveGripMm, 0);

        /// <summary>A weapon that lies along a direction, with the front of the fist that holds it.</summary>
        private static ArmFit Fit(int person, Vector3D aim) => new ArmFit
        {
            PersonId = person,
            HasWeapon = true,
            MuzzleMm = Muzzle,
            WeaponDirection = aim,
            HasSurface = true,
            SurfaceMm = Muzzle - aim * (GripToMuzzleMm - 39) + new Vector3D(0, BoreAboveGripMm, 0),
        };

        private static void Find(ref ArmFit fit)
        {
            var settings = new DepthHandSettings();
            var people = new PersonSet(settings, UprightFrame.Level);
            for (int i = 0; i < 30; i++)
            {
                people.Begin(i * 33_000);
                people.See(UprightFrame.Level.ToUpright(Left), i * 33_000);
                people.See(UprightFrame.Level.ToUpright(Right), i * 33_000);
            }

            new GripFinder(settings, UprightFrame.Level).Find(people, ref fit);
        }
    }
}
