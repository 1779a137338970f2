using LaserTracking.Capture;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Hands
{
    public sealed class PeopleTests
    {
        private const int Frames = 20;
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
        public void Process_SomebodyWhoAims_IsAPersonWithTheirHand()
        {
            var scene = new SolidScene { NoiseMm = 4 }.Body(0, 1750);
            scene.Arm(new Vector3D(-190, -60, 1720), new Vector3D(-80, -60, 1150), 140);
            Run(new DepthHandTracker(SolidScene.Camera), scene);
            Assert.That(_hands.People.Length, Is.EqualTo(1));
            PersonObservation person = _hands.People[0];
            Assert.That(_hands.Hands[0].PersonId, Is.EqualTo(person.PersonId));
            // The head's middle is at (0, -240), its front 95 mm before 1750.
            Assert.That(person.EyeMm.X, Is.EqualTo(0).Within(60));
            Assert.That(person.EyeMm.Y, Is.EqualTo(-240).Within(80));
            Assert.That(person.EyeMm.Z, Is.EqualTo(1670).Within(80));
            Assert.That(_hands.Hands[0].SightDirection.LengthSquared, Is.EqualTo(1).Within(1e-9));
        }

        [Test]
        public void Process_TwoPeople_EachHasTheirHand()
        {
            var scene = new SolidScene { NoiseMm = 4 }.Body(-350, 1750).Body(350, 1800);
            scene.Arm(new Vector3D(-540, -60, 1720), new Vector3D(-430, -60, 1150), 140);
            scene.Arm(new Vector3D(540, -60, 1770), new Vector3D(430, -60, 1200), 140);
            Run(new DepthHandTracker(SolidScene.Camera), scene);
            Assert.That(_hands.People.Length, Is.EqualTo(2));
            Assert.That(_hands.Hands.Length, Is.EqualTo(2));
            Assert.That(_hands.Hands[0].PersonId, Is.Not.EqualTo(_hands.Hands[1].PersonId));
            foreach (HandObservation hand in _hands.Hands)
            {
                foreach (PersonObservation person in _hands.People)
                {
                    if (person.PersonId == hand.PersonId)
                        Assert.That(System.Math.Sign(person.EyeMm.X), Is.EqualTo(System.Math.Sign(hand.PalmMm.X)));
                }
            }
        }

        [Test]
        public void Process_ArmLowered_ThePersonStays()
        {
            var scene = new SolidScene { NoiseMm = 4 }.Body(0, 1750);
            scene.Arm(new Vector3D(-190, -60, 1720), new Vector3D(-80, -60, 1150), 140);
            var tracker = new DepthHandTracker(SolidScene.Camera);
            Run(tracker, scene);
            int id = _hands.People[0].PersonId;
            new SolidScene { NoiseMm = 4 }.Body(0, 1750).Render(_frame, Frames, Frames * 33_333L);
            tracker.Process(_frame, _hands);
            Assert.That(_hands.People.Length, Is.EqualTo(1));
            Assert.That(_hands.People[0].PersonId, Is.EqualTo(id));
        }

        private void Run(DepthHandTracker tracker, SolidScene scene)
        {
            for (int i = 0; i < Frames; i++)
            {
                scene.Render(_frame, i, i * 33_333L, i + 1);
                tracker.Process(_frame, _hands);
            }
        }
    }
}
