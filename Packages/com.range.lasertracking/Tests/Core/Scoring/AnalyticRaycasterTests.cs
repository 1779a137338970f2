using System;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Scoring
{
    public sealed class AnalyticRaycasterTests
    {
        private static readonly Vector3D Forward = new Vector3D(0, 0, 1);
        private static readonly SceneCollider UnitBox = SceneCollider.Box(default, TestScenes.One);
        private static readonly SceneCollider UnitSphere = SceneCollider.Sphere(default, 0.5);

        [Test]
        public void AnalyticRaycaster_TwoColliders_GivesTheNearestWhateverTheirOrder()
        {
            SceneObject far = TestScenes.At(0, 0, 9, UnitBox), near = TestScenes.At(0, 0, 5, UnitBox);
            Assert.That(Hit(TestScenes.Of(far, near)).ObjectIndex, Is.EqualTo(1));
            Assert.That(Hit(TestScenes.Of(near, far)).ObjectIndex, Is.EqualTo(0));
            Assert.That(Hit(TestScenes.Of(near, far)).DistanceM, Is.EqualTo(4.5).Within(1e-12));
        }

        [Test]
        public void AnalyticRaycaster_EqualDistances_GivesTheFirstInTheHierarchy()
        {
            SceneObject one = TestScenes.At(0, 0, 5, UnitBox), same = TestScenes.At(0, 0, 5, UnitBox);
            Assert.That(Hit(TestScenes.Of(one, same)).ObjectIndex, Is.EqualTo(0));
        }

        [Test]
        public void AnalyticRaycaster_SeveralCollidersOfOneObject_GivesTheNearest()
        {
            SceneObject thing = TestScenes.At(0, 0, 5, UnitBox, SceneCollider.Sphere(new Vector3D(0, 0, -1), 0.25));
            Assert.That(Hit(TestScenes.Of(thing)).DistanceM, Is.EqualTo(3.75).Within(1e-12));
        }

        [Test]
        public void AnalyticRaycaster_OriginInsideOrOnSurface_HitsOnlyWhatIsBehind()
        {
            SceneCollider[] solids = { UnitBox, UnitSphere, SceneCollider.Capsule(default, 0.25, 1, 2) };
            foreach (SceneCollider solid in solids)
            {
                SceneModel scene = TestScenes.Of(TestScenes.At(0, 0, 0, solid), TestScenes.At(0, 0, 5, UnitBox));
                Assert.That(Hit(scene).ObjectIndex, Is.EqualTo(1), solid.Shape + " inside");
                var onSurface = new Ray3D(new Vector3D(0, 0, -0.5), Forward);
                RaycastHit hit;
                Assert.That(new AnalyticRaycaster(scene).TryRaycast(onSurface, 100, 0, out hit), Is.True);
                Assert.That(hit.ObjectIndex, Is.EqualTo(1), solid.Shape + " on its surface");
            }
        }

        [Test]
        public void AnalyticRaycaster_BehindTheOrigin_IsNotHit()
        {
            SceneCollider[] solids = { UnitBox, UnitSphere, SceneCollider.Capsule(default, 0.25, 1, 1), SceneCollider.Quad() };
            foreach (SceneCollider solid in solids)
                Assert.That(Misses(TestScenes.Of(TestScenes.At(0, 0, -5, solid))), Is.True, solid.Shape.ToString());
        }

        [Test]
        public void AnalyticRaycaster_LayerMask_SkipsOtherLayers()
        {
            SceneObject target = TestScenes.Target("t", TestScenes.Rings, 0, 0, 5);
            Assert.That(Misses(TestScenes.Of(~(1 << TestScenes.TargetLayer), target)), Is.True);
            Assert.That(Misses(TestScenes.Of(1 << TestScenes.TargetLayer, target)), Is.False);
            var last = new SceneObject("x", 31, target.RestPose, TestScenes.One, Rotation3D.Identity, default, new[] { UnitBox }, null);
            Assert.That(Misses(TestScenes.Of(1 << 31, last)), Is.False);
        }

        [Test]
        public void AnalyticRaycaster_Triggers_AreHitUnlessSwitchedOff()
        {
            SceneModel scene = TestScenes.Of(TestScenes.At(0, 0, 5, SceneCollider.Box(default, TestScenes.One, true)));
            Assert.That(new AnalyticRaycaster(scene).TryRaycast(Ahead, 100, 0, out RaycastHit _), Is.True);
            Assert.That(new AnalyticRaycaster(scene, false).TryRaycast(Ahead, 100, 0, out RaycastHit _), Is.False);
        }

        [Test]
        public void AnalyticRaycaster_MaxDistance_CountsUpToAndIncludingIt()
        {
            var raycaster = new AnalyticRaycaster(TestScenes.Of(TestScenes.At(0, 0, 5, UnitBox)));
            Assert.That(raycaster.TryRaycast(Ahead, 4.5, 0, out RaycastHit _), Is.True);
            Assert.That(raycaster.TryRaycast(Ahead, 4.499999, 0, out RaycastHit _), Is.False);
            Assert.That(raycaster.TryRaycast(Ahead, double.PositiveInfinity, 0, out RaycastHit _), Is.True);
        }

        [Test]
        public void AnalyticRaycaster_SenselessRay_HitsNothing()
        {
            var raycaster = new AnalyticRaycaster(TestScenes.Of(TestScenes.At(0, 0, 5, UnitBox), TestScenes.At(0, 0, 5, UnitSphere)));
            Ray3D[] rays =
            {
                default, new Ray3D(default, default), new Ray3D(new Vector3D(double.NaN, 0, 0), Forward),
                new Ray3D(default, new Vector3D(0, double.NaN, 1)), new Ray3D(default, new Vector3D(0, 0, double.PositiveInfinity)),
            };
            foreach (Ray3D ray in rays)
                Assert.That(raycaster.TryRaycast(ray, 100, 0, out RaycastHit _), Is.False);
            Assert.That(raycaster.TryRaycast(Ahead, double.NaN, 0, out RaycastHit _), Is.False);
            Assert.That(raycaster.TryRaycast(Ahead, 0, 0, out RaycastHit _), Is.False);
            Assert.That(raycaster.TryRaycast(Ahead, -1, 0, out RaycastHit _), Is.False);
            Assert.That(raycaster.TryRaycast(Ahead, 100, double.NaN, out RaycastHit _), Is.False);
        }

        [Test]
        public void AnalyticRaycaster_Quad_IsHitFromItsFrontOnly()
        {
            Rotation3D about = Rotation3D.AboutAxis(new Vector3D(0, 1, 0), Math.PI);
            var at = new Vector3D(0, 0, 5);
            RaycastHit hit = Hit(TestScenes.Of(TestScenes.Object(new Pose(at, Rotation3D.Identity), TestScenes.One, SceneCollider.Quad())));
            Assert.That(hit.DistanceM, Is.EqualTo(5).Within(1e-12));
            Assert.That((hit.Normal - new Vector3D(0, 0, -1)).Length, Is.LessThan(1e-12));
            Assert.That(Misses(TestScenes.Of(TestScenes.Object(new Pose(at, about), TestScenes.One, SceneCollider.Quad()))), Is.True);
            var mirrored = new Vector3D(1, 1, -1);
            Assert.That(Misses(TestScenes.Of(TestScenes.Object(new Pose(at, Rotation3D.Identity), mirrored, SceneCollider.Quad()))), Is.True);
            Assert.That(Misses(TestScenes.Of(TestScenes.Object(new Pose(at, about), mirrored, SceneCollider.Quad()))), Is.False);
            Assert.That(Misses(TestScenes.Of(TestScenes.Object(new Pose(at, Rotation3D.Identity), new Vector3D(-1, 1, 1), SceneCollider.Quad()))), Is.False);
        }

        [Test]
        public void AnalyticRaycaster_QuadEdge_EndsAtHalfItsScale()
        {
            SceneModel scene = TestScenes.Of(TestScenes.Object(new Pose(new Vector3D(0, 0, 5), Rotation3D.Identity), new Vector3D(3, 2, 1), SceneCollider.Quad()));
            Assert.That(Meets(scene, 1.499, 0.999), Is.True);
            Assert.That(Meets(scene, 1.501, 0), Is.False);
            Assert.That(Meets(scene, 0, -1.001), Is.False);
        }

        [Test]
        public void AnalyticRaycaster_ScaledSphere_TakesTheLargestComponent()
        {
            SceneModel scene = TestScenes.Of(TestScenes.Object(new Pose(new Vector3D(0, 0, 9), Rotation3D.Identity), new Vector3D(0.5, -4, 1), UnitSphere));
            Assert.That(Hit(scene).DistanceM, Is.EqualTo(7).Within(1e-12));
            Assert.That(Meets(scene, 1.999, 0), Is.True);
            Assert.That(Meets(scene, 2.001, 0), Is.False);
        }

        [Test]
        public void AnalyticRaycaster_ScaledCapsule_TakesTheLargerRadiusAndTheAxisHeight()
        {
            // Along y: radius 0.5 · max(|2|, |-3|) = 1.5, height 2 · 4 = 8, so the caps begin at ±2.5 and end at ±4.
            SceneModel scene = TestScenes.Of(TestScenes.Object(new Pose(new Vector3D(0, 0, 9), Rotation3D.Identity), new Vector3D(2, 4, -3),
                SceneCollider.Capsule(default, 0.5, 2, 1)));
            Assert.That(Hit(scene).DistanceM, Is.EqualTo(7.5).Within(1e-12));
            Assert.That(Meets(scene, 1.499, 2.4), Is.True);
            Assert.That(Meets(scene, 0, 3.999), Is.True);
            Assert.That(Meets(scene, 0, 4.001), Is.False);
            Assert.That(Meets(scene, 1.4, 3.6), Is.False);
        }

        [Test]
        public void AnalyticRaycaster_CapsuleShorterThanWide_IsASphere()
        {
            SceneModel scene = TestScenes.Of(TestScenes.At(0, 0, 9, SceneCollider.Capsule(default, 1, 0.5, 0)));
            Assert.That(Hit(scene).DistanceM, Is.EqualTo(8).Within(1e-12));
            Assert.That(Meets(scene, 0.999, 0), Is.True);
            Assert.That(Meets(scene, 1.001, 0), Is.False);
        }

        [Test]
        public void AnalyticRaycaster_CapsuleAxes_LieAlongXYZ()
        {
            Vector3D[] far = { new Vector3D(1.9, 0, 0), new Vector3D(0, 1.9, 0) };
            for (int axis = 0; axis < 3; axis++)
            {
                SceneModel scene = TestScenes.Of(TestScenes.At(0, 0, 9, SceneCollider.Capsule(default, 0.5, 4, axis)));
                for (int i = 0; i < far.Length; i++)
                    Assert.That(Meets(scene, far[i].X, far[i].Y), Is.EqualTo(axis == i), "axis " + axis + " probe " + i);
                Assert.That(Hit(scene).DistanceM, Is.EqualTo(axis == 2 ? 7 : 8.5).Within(1e-12));
            }
        }

        [Test]
        public void AnalyticRaycaster_CentreUnderScale_MovesWithSignedScale()
        {
            SceneCollider box = SceneCollider.Box(new Vector3D(1, 0, 0), new Vector3D(0.1, 0.1, 0.1));
            SceneModel scene = TestScenes.Of(TestScenes.Object(new Pose(new Vector3D(0, 0, 5), Rotation3D.Identity), new Vector3D(-2, 1, 1), box));
            Assert.That(Meets(scene, -2, 0), Is.True);
            Assert.That(Meets(scene, -2.09, 0), Is.True);
            Assert.That(Meets(scene, 2, 0), Is.False);
        }

        [Test]
        public void AnalyticRaycaster_LocalPoint_IsInTheObjectsAxesInMetres()
        {
            Rotation3D rotation = Rotation3D.AboutAxis(new Vector3D(0, 1, 0), -0.5);
            SceneObject card = TestScenes.Object(new Pose(new Vector3D(0.2, 0.1, 6), rotation), new Vector3D(2, 3, 0.01), UnitBox);
            RaycastHit hit = Hit(TestScenes.Of(card));
            Assert.That((card.RestPose.TransformPoint(hit.LocalPointM) - hit.PointM).Length, Is.LessThan(1e-12));
            Assert.That(hit.LocalPointM.Z, Is.EqualTo(-0.005).Within(1e-12));
            Assert.That((hit.ObjectPose.TransformPoint(hit.LocalPointM) - hit.PointM).Length, Is.LessThan(1e-12));
            Assert.That((hit.PointM - new Vector3D(0, 0, hit.DistanceM)).Length, Is.LessThan(1e-12));
        }

        [Test]
        public void AnalyticRaycaster_MovingObject_StandsWhereItStoodAtTheTime()
        {
            var motion = new MotionPath(MotionKind.PingPong, new Vector3D(2, 0, 0), 4, 0);
            Rotation3D quarter = Rotation3D.AboutAxis(new Vector3D(0, 0, 1), Math.PI / 2);
            var thing = new SceneObject("t", 0, new Pose(new Vector3D(0, 0, 5), Rotation3D.Identity), TestScenes.One, quarter, motion, new[] { UnitBox }, null);
            var raycaster = new AnalyticRaycaster(TestScenes.Of(thing));

            // The parent is turned a quarter about z, so the travel along its x is along the world's y.
            var up = new Ray3D(new Vector3D(0, 2, 0), Forward);
            Assert.That(raycaster.TryRaycast(Ahead, 100, 0, out RaycastHit _), Is.True);
            Assert.That(raycaster.TryRaycast(up, 100, 0, out RaycastHit _), Is.False);
            Assert.That(raycaster.TryRaycast(up, 100, 2, out RaycastHit hit), Is.True);
            Assert.That((hit.ObjectPose.Position - new Vector3D(0, 2, 5)).Length, Is.LessThan(1e-12));
            Assert.That(raycaster.TryRaycast(Ahead, 100, 2, out RaycastHit _), Is.False);
        }

        [Test]
        public void AnalyticRaycaster_TryGetTarget_NamesTargetsAndScenery()
        {
            var raycaster = new AnalyticRaycaster(TestScenes.Of(TestScenes.At(0, 0, 9, UnitBox), TestScenes.Target("left", TestScenes.Rings, 0, 0, 5)));
            Assert.That(raycaster.TryGetTarget(1, out string name, out TargetDefinition? definition), Is.True);
            Assert.That(name, Is.EqualTo("left"));
            Assert.That(definition, Is.SameAs(TestScenes.Rings));
            Assert.That(raycaster.TryGetTarget(0, out name, out definition), Is.True);
            Assert.That(definition, Is.Null);
            Assert.That(raycaster.TryGetTarget(2, out name, out definition), Is.False);
            Assert.That(raycaster.TryGetTarget(-1, out name, out definition), Is.False);
        }

        private static Ray3D Ahead => new Ray3D(default, Forward);

        private static RaycastHit Hit(SceneModel scene)
        {
            Assert.That(new AnalyticRaycaster(scene).TryRaycast(Ahead, 100, 0, out RaycastHit hit), Is.True);
            return hit;
        }

        private static bool Misses(SceneModel scene) => !new AnalyticRaycaster(scene).TryRaycast(Ahead, 100, 0, out RaycastHit _);

        private static bool Meets(SceneModel scene, double x, double y) =>
            new AnalyticRaycaster(scene).TryRaycast(new Ray3D(new Vector3D(x, y, 0), Forward), 100, 0, out RaycastHit _);
    }
}
