using System;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Kernels;
using NUnit.Framework;

namespace LaserTracking.Fusion
{
    /// <summary>One person whose eyes are 2.3 m before the screen's middle and who may have fired at its middle.</summary>
    public sealed class WeaponPlaceTests
    {
        private static readonly HandCamera Camera = new HandCamera(
            SolidScene.Camera, new Pose(new Vector3D(1865, 0, 0), Rotation3D.AboutAxis(new Vector3D(0, 1, 0), Math.PI)));

        private static readonly Vector3D Eyes = new Vector3D(1.865, 0.5, -2.3);
        private static readonly Vector3D Dot = new Vector3D(1.865, 1.05, 0);

        [Test]
        public void Factor_PictureGoesOnBehindThePlace_SpeaksAgainstThem()
        {
            Assert.That(Factor(new SolidScene()), Is.LessThan(0.1));
        }

        [Test]
        public void Factor_SomethingThere_SpeaksForThem()
        {
            Assert.That(Factor(new SolidScene().Capsule(At(0.5), At(0.68), 25)), Is.GreaterThan(5));
        }

        [Test]
        public void Factor_SomethingBeforeIt_SpeaksForThem()
        {
            Assert.That(Factor(new SolidScene().Capsule(At(0.5) * 0.6, At(0.68) * 0.6, 60)), Is.GreaterThan(5));
        }

        [Test]
        public void Factor_EverythingCovered_SaysNothing()
        {
            Assert.That(Factor(new SolidScene { WallMm = 900 }), Is.EqualTo(1).Within(0.1));
        }

        [Test]
        public void Factor_NothingMeasured_SaysNothing()
        {
            Assert.That(Factor(new SolidScene { HoleShare = 1 }), Is.EqualTo(1).Within(0.1));
        }

        [Test]
        public void Factor_LineHardlyKnown_SaysLittle()
        {
            Assert.That(Factor(new SolidScene(), 150), Is.EqualTo(1).Within(0.1));
        }

        [Test]
        public void Factor_NobodyKnown_SaysNothing()
        {
            var places = new WeaponPlace(Camera, new SightLines(new FusionSettings()));
            Assert.That(places.Factor(7, Dot, Seen(new SolidScene())), Is.EqualTo(1));
        }

        [Test]
        public void Fuse_TwoWhoseWeaponsAreNotSeen_IsWhoseItMayBe()
        {
            // Both aim over points that are known; where the first one's weapon would be, the picture goes on behind it.
            var assignment = new ShooterAssignment(Camera);
            var hands = new HandObservations();
            hands.Begin(0, 0);
            hands.Add(Person(1, Eyes - new Vector3D(0.4, 0, 0), 10));
            hands.Add(Person(2, Eyes, 10));
            assignment.AddHands(hands);
            Assert.That(assignment.Fuse(default, new Vector2D(Dot.X, Dot.Y)).Shooter, Is.Zero, "without the picture either may have fired");

            assignment.Reset();
            hands.Depth.CopyFrom(Seen(new SolidScene().Capsule(At(0.5), At(0.68), 25)));
            assignment.AddHands(hands);
            Assert.That(assignment.Fuse(default, new Vector2D(Dot.X, Dot.Y)).Shooter, Is.EqualTo(1));
            Assert.That(Allocation.Of(() =>
            {
                assignment.AddHands(hands);
                assignment.Fuse(default, new Vector2D(Dot.X, Dot.Y));
            }), Is.Zero);
        }

        [TestCase(true, 1, ExpectedResult = true)]
        [TestCase(true, 3, ExpectedResult = false)]
        [TestCase(false, 3, ExpectedResult = true)]
        public bool Fuse_BesideALineHardlyKnown_IsUnknownWhereAPictureDoesNotShowSomebodysWeapon(bool hasPicture, double hiddenRivalWeight)
        {
            // Aimed 0.33 m beside the dot over eyes known to 60 mm; everything else is covered.
            var assignment = new ShooterAssignment(Camera, new FusionSettings { HiddenRivalWeight = hiddenRivalWeight });
            Vector3D eyes = Eyes - new Vector3D(1, 0, 0), pivot = eyes + new Vector3D(0, new FusionSettings().SightHeightM, 0);
            Vector3D muzzle = pivot + (Dot + new Vector3D(0.33, 0, 0) - pivot).Normalized * 0.75;
            var hands = new HandObservations();
            hands.Begin(0, 0);
            if (hasPicture)
                hands.Depth.CopyFrom(Seen(new SolidScene { WallMm = 900 }));
            hands.Add(Person(1, eyes, 60));
            hands.Add(Person(2, Eyes, 60));
            hands.Add(new HandObservation { TrackId = 1, PersonId = 1, MuzzleMm = Camera.ToCameraMm(muzzle), MuzzleSigmaMm = 5, SigmaMm = 12 });
            assignment.AddHands(hands);
            return assignment.Fuse(default, new Vector2D(Dot.X, Dot.Y)).Shooter > 0;
        }

        [Test]
        public void At_SeveralPictures_IsTheNearestInTimeOrNone()
        {
            var depths = new SeenDepths();
            var hands = new HandObservations();
            for (int i = 0; i < 6; i++)
            {
                hands.Begin(i, i * 33_000L);
                if (i != 3)
                    hands.Depth.CopyFrom(Seen(new SolidScene { WallMm = 1000 + 100 * i }));
                depths.Add(hands);
            }

            Assert.That(depths.At(134_000, 50_000)!.TowardsMm(new Vector3D(0, 0, 500)), Is.EqualTo(1400));
            Assert.That(depths.At(100_000, 50_000)!.TowardsMm(new Vector3D(0, 0, 500)), Is.EqualTo(1400), "one frame had no picture");
            Assert.That(depths.At(0, 30_000), Is.Null, "overwritten");
            depths.Clear();
            Assert.That(depths.At(134_000, 50_000), Is.Null);
        }

        private static double Factor(SolidScene scene, double sigmaMm = 10)
        {
            var sights = new SightLines(new FusionSettings());
            sights.See(Person(1, Eyes, sigmaMm), Camera, 0);
            return new WeaponPlace(Camera, sights).Factor(1, Dot, Seen(scene));
        }

        private static PersonObservation Person(int id, Vector3D eyesM, double sigmaMm) =>
            new PersonObservation { PersonId = id, EyeMm = Camera.ToCameraMm(eyesM), SigmaMm = sigmaMm };

        /// <summary>So far before the eyes on the line to the dot, camera space.</summary>
        private static Vector3D At(double reachM)
        {
            Vector3D pivot = Eyes + new Vector3D(0, new FusionSettings().SightHeightM, 0);
            return Camera.ToCameraMm(pivot + (Dot - pivot).Normalized * reachM);
        }

        private static SeenDepth Seen(SolidScene scene)
        {
            using var frame = new Frame();
            scene.Render(frame, 0, 0);
            var grid = new DepthGrid(SolidScene.Camera, new DepthHandSettings(), KernelRunner.Plain);
            grid.Fill(frame.Depth);
            var seen = new SeenDepth();
            seen.Fill(grid);
            return seen;
        }
    }
}
