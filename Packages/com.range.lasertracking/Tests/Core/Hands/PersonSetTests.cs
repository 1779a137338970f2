using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Hands
{
    /// <summary>A level camera: upright space is camera space with y turned up.</summary>
    public sealed class PersonSetTests
    {
        private static readonly Vector3D Front = new Vector3D(0, 300, 1500);

        [Test]
        public void Find_ArmThatBeginsBehindTheHead_IsNotTheirs()
        {
            PersonSet people = WithSomebodyInFront();
            Assert.That(people.Find(new Vector3D(150, 0, 1400), out _, out _), Is.EqualTo(1));
            Assert.That(people.Find(new Vector3D(150, 0, 2200), out _, out _), Is.Zero, "of somebody whom they hide");
        }

        [Test]
        public void SeeArm_ForASecondWithoutAHead_IsAPersonWhoseEyesAreAGuess()
        {
            PersonSet people = WithSomebodyInFront();
            var root = new Vector3D(150, 0, 2200);
            for (int i = 0; i < 30; i++)
                people.SeeArm(root, 400_000 + i * 33_000);
            Assert.That(people.Find(root, out _, out bool isHeadHidden), Is.EqualTo(2));
            Assert.That(isHeadHidden, Is.True);
            var seen = new HandObservations();
            people.Report(seen);
            Assert.That(seen.People[1].SigmaMm, Is.GreaterThan(2 * seen.People[0].SigmaMm));
        }

        [Test]
        public void See_HeadOfSomebodyWhoWasHidden_KeepsTheirNumber()
        {
            PersonSet people = WithSomebodyInFront();
            var root = new Vector3D(150, 0, 2200);
            for (int i = 0; i < 30; i++)
                people.SeeArm(root, 400_000 + i * 33_000);
            people.See(new Vector3D(100, 320, 2300), 1_500_000);
            Assert.That(people.Find(root, out _, out bool isHeadHidden), Is.EqualTo(2));
            Assert.That(isHeadHidden, Is.False);
        }

        [Test]
        public void SeeArm_OfSomebodyKnown_MakesNobody()
        {
            PersonSet people = WithSomebodyInFront();
            for (int i = 0; i < 60; i++)
                people.SeeArm(new Vector3D(150, 0, 1400), 400_000 + i * 33_000);
            var seen = new HandObservations();
            people.Report(seen);
            Assert.That(seen.People.Length, Is.EqualTo(1));
        }

        private static PersonSet WithSomebodyInFront()
        {
            var people = new PersonSet(new DepthHandSettings(), UprightFrame.Level);
            for (int i = 0; i < 12; i++)
                people.See(Front, i * 33_000);
            return people;
        }
    }
}
