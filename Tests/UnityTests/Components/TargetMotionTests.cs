using LaserTracking.Scoring;
using NUnit.Framework;
using UnityEngine;
using UnityStandIn;

namespace LaserTracking.Unity
{
    public sealed class TargetMotionTests : StandInTests
    {
        [Test]
        public void TargetMotion_Sine_ShowsAndComputesTheSamePath()
        {
            TargetMotion motion = Make(MotionKind.Sine, new Vector3(2, 0, 0), 4);
            PlayerLoop.Step(1);
            Assert.That(motion.transform.localPosition.x, Is.EqualTo(3).Within(1e-6), "rest 1 + travel 2 at a quarter");
            PlayerLoop.Step(2);
            Assert.That(motion.transform.localPosition.x, Is.EqualTo(-1).Within(1e-6));
            Assert.That(motion.PoseAt(1).Position.X, Is.EqualTo(3).Within(1e-6), "the past can be asked for");
        }

        [Test]
        public void TargetMotion_BelowTurnedParent_MovesInTheParentsAxes()
        {
            TargetMotion motion = Make(MotionKind.Sine, new Vector3(2, 0, 0), 4);
            var parent = new GameObject("parent");
            parent.transform.localRotation = Quaternion.Euler(0, 90, 0);
            motion.transform.SetParent(parent.transform, false);
            PlayerLoop.Step(1);
            Assert.That(Vector3.Distance(motion.transform.position, new Vector3(0, 0, -3)), Is.LessThan(1e-5f));
            Assert.That((motion.PoseAt(1).Position - motion.transform.position.ToCore()).Length, Is.LessThan(1e-5));
        }

        [Test]
        public void TargetMotion_MovedByOthers_RemembersWhere()
        {
            TargetMotion motion = Make(MotionKind.None, default, 0);
            for (int i = 0; i < 10; i++)
            {
                motion.transform.position = new Vector3(i, 0, 0);
                PlayerLoop.Step(0.1);
            }

            // After step i the clock stands at (i + 1) / 10.
            Assert.That(motion.PoseAt(0.55).Position.X, Is.EqualTo(4.5).Within(1e-6));
            Assert.That(motion.PoseAt(99).Position.X, Is.EqualTo(9));
        }

        [Test]
        public void TargetMotion_PeriodOfZero_StandsStillAndSaysSo()
        {
            TargetMotion motion = Make(MotionKind.Circle, Vector3.one, 0);
            PlayerLoop.Step(1);
            Assert.That(ConsoleLog.Entries, Has.Count.EqualTo(1));
            Assert.That(ConsoleLog.Entries[0].Message, Does.Contain("period"));
            Assert.That(motion.transform.localPosition.x, Is.EqualTo(1));
        }

        [Test]
        public void PhysicsRaycaster_CarriedTarget_IsRewoundAfterItsCarrier()
        {
            // The child remembers world poses and was enabled before the carrier that moves it.
            TargetMotion child = Make(MotionKind.None, default, 0);
            child.gameObject.AddComponent<BoxCollider>();
            TargetMotion carrier = Make(MotionKind.PingPong, new Vector3(10, 0, 0), 20);
            carrier.transform.localPosition = Vector3.zero;
            child.transform.SetParent(carrier.transform);
            carrier.enabled = false;
            carrier.enabled = true;
            for (int i = 0; i < 20; i++)
                PlayerLoop.Step(0.1);
            double worldXThen = child.PoseAt(1).Position.X;
            var raycaster = new PhysicsRaycaster(~0);
            var ray = new LaserTracking.Geometry.Ray3D(new LaserTracking.Geometry.Vector3D(worldXThen, 0, -5), new LaserTracking.Geometry.Vector3D(0, 0, 1));
            Assert.That(raycaster.TryRaycast(ray, 100, 1, out LaserTracking.Scoring.RaycastHit hit), Is.True);
            Assert.That(hit.LocalPointM.X, Is.EqualTo(0).Within(1e-4));
            Assert.That(raycaster.TryRaycast(ray, 100, 2, out hit) && System.Math.Abs(hit.LocalPointM.X) < 0.4, Is.False, "it moved on");
        }

        private static TargetMotion Make(MotionKind kind, Vector3 travelM, float periodS)
        {
            var owner = new GameObject("target");
            owner.SetActive(false);
            owner.transform.localPosition = new Vector3(1, 0, 0);
            TargetMotion motion = owner.AddComponent<TargetMotion>();
            SerializedFields.Set(motion, "_kind", kind);
            SerializedFields.Set(motion, "_travelM", travelM);
            SerializedFields.Set(motion, "_periodS", periodS);
            owner.SetActive(true);
            return motion;
        }
    }
}
