using NUnit.Framework;
using UnityEngine;
using UnityStandIn;

namespace LaserTracking.Unity
{
    /// <summary>Against Unity's pages of Physics.Raycast, Physics.queriesHitTriggers, queriesHitBackfaces and SyncTransforms.</summary>
    public sealed class PhysicsRaycastTests : StandInTests
    {
        [TestCase(PrimitiveType.Cube, 4.5f)]
        [TestCase(PrimitiveType.Sphere, 4.5f)]
        [TestCase(PrimitiveType.Capsule, 4.5f)]
        [TestCase(PrimitiveType.Quad, 5f)]
        public void Raycast_AtUnitPrimitive_MeetsItsNearSide(PrimitiveType type, float distance)
        {
            GameObject target = Place(type, new Vector3(0, 0, 5));
            Assert.That(Cast(Vector3.zero, Vector3.forward * 3, out RaycastHit hit), Is.True);
            Assert.That(hit.distance, Is.EqualTo(distance).Within(1e-5));
            Assert.That(Vector3.Distance(hit.normal, Vector3.back), Is.LessThan(1e-5));
            Assert.That(Vector3.Distance(hit.point, new Vector3(0, 0, distance)), Is.LessThan(1e-5));
            Assert.That(hit.transform, Is.SameAs(target.transform));
        }

        [TestCase(PrimitiveType.Cube)]
        [TestCase(PrimitiveType.Sphere)]
        [TestCase(PrimitiveType.Capsule)]
        public void Raycast_FromWithin_IsNoHit(PrimitiveType type)
        {
            Place(type, Vector3.zero);
            Assert.That(Cast(new Vector3(0.1f, 0, 0.2f), Vector3.forward, out _), Is.False);
        }

        [Test]
        public void Raycast_BehindOrBeyond_IsNoHit()
        {
            Place(PrimitiveType.Cube, new Vector3(0, 0, 5));
            Assert.That(Cast(Vector3.zero, Vector3.back, out _), Is.False);
            Assert.That(Physics.Raycast(Vector3.zero, Vector3.forward, out _, 4.4f), Is.False);
            Assert.That(Physics.Raycast(Vector3.zero, Vector3.forward, out _, 4.6f), Is.True);
            Assert.That(Cast(Vector3.zero, Vector3.zero, out _), Is.False);
        }

        [Test]
        public void Raycast_OnQuadFromBehind_HitsOnlyIfBackFacesCount()
        {
            Place(PrimitiveType.Quad, new Vector3(0, 0, 5));
            Assert.That(Cast(new Vector3(0, 0, 10), Vector3.back, out _), Is.False);
            Physics.queriesHitBackfaces = true;
            Assert.That(Cast(new Vector3(0, 0, 10), Vector3.back, out _), Is.True);
        }

        [Test]
        public void Raycast_BesideQuad_Misses()
        {
            GameObject quad = Place(PrimitiveType.Quad, new Vector3(0, 0, 5));
            quad.transform.localScale = new Vector3(2, 1, 1);
            Physics.SyncTransforms();
            foreach (float side in new[] { -1f, 1f })
            {
                Assert.That(Cast(new Vector3(0.99f * side, 0.49f * side, 0), Vector3.forward, out _), Is.True);
                Assert.That(Cast(new Vector3(1.01f * side, 0, 0), Vector3.forward, out _), Is.False);
                Assert.That(Cast(new Vector3(0, 0.51f * side, 0), Vector3.forward, out _), Is.False);
            }
        }

        [Test]
        public void Raycast_Several_GivesTheNearest()
        {
            Place(PrimitiveType.Cube, new Vector3(0, 0, 9));
            GameObject near = Place(PrimitiveType.Sphere, new Vector3(0, 0, 5));
            Place(PrimitiveType.Quad, new Vector3(0, 0, 7));
            Cast(Vector3.zero, Vector3.forward, out RaycastHit hit);
            Assert.That(hit.collider.gameObject, Is.SameAs(near));
        }

        [Test]
        public void Raycast_Layers_AreHonoured()
        {
            GameObject target = Place(PrimitiveType.Cube, new Vector3(0, 0, 5));
            target.layer = 8;
            Assert.That(Physics.Raycast(Vector3.zero, Vector3.forward, out _, 100, 1 << 8), Is.True);
            Assert.That(Physics.Raycast(Vector3.zero, Vector3.forward, out _, 100, ~(1 << 8)), Is.False);
            target.layer = 2;
            Assert.That(Physics.Raycast(Vector3.zero, Vector3.forward, out _), Is.False, "Ignore Raycast is left out by default");
        }

        [Test]
        public void Raycast_Triggers_FollowQueryAndGlobalSetting()
        {
            Place(PrimitiveType.Cube, new Vector3(0, 0, 5)).GetComponent<BoxCollider>().isTrigger = true;
            Assert.That(Meets(QueryTriggerInteraction.UseGlobal), Is.True);
            Assert.That(Meets(QueryTriggerInteraction.Ignore), Is.False);
            Physics.queriesHitTriggers = false;
            Assert.That(Meets(QueryTriggerInteraction.UseGlobal), Is.False);
            Assert.That(Meets(QueryTriggerInteraction.Collide), Is.True);
        }

        [Test]
        public void Raycast_InactiveDisabledOrDestroyed_IsNotMet()
        {
            GameObject target = Place(PrimitiveType.Cube, new Vector3(0, 0, 5));
            target.SetActive(false);
            Assert.That(Cast(Vector3.zero, Vector3.forward, out _), Is.False);
            target.SetActive(true);
            target.GetComponent<BoxCollider>().enabled = false;
            Assert.That(Cast(Vector3.zero, Vector3.forward, out _), Is.False);
            target.GetComponent<BoxCollider>().enabled = true;
            Assert.That(Cast(Vector3.zero, Vector3.forward, out _), Is.True);
            Object.DestroyImmediate(target);
            Assert.That(Cast(Vector3.zero, Vector3.forward, out _), Is.False);
        }

        [Test]
        public void Raycast_AfterTransformMoved_SeesItOnlyAfterSync()
        {
            GameObject target = Place(PrimitiveType.Cube, new Vector3(0, 0, 5));
            target.transform.position = new Vector3(3, 0, 5);
            Assert.That(Cast(Vector3.zero, Vector3.forward, out _), Is.True);
            Physics.SyncTransforms();
            Assert.That(Cast(Vector3.zero, Vector3.forward, out _), Is.False);
            target.transform.position = new Vector3(0, 0, 5);
            PlayerLoop.Step(0.02);
            Assert.That(Cast(Vector3.zero, Vector3.forward, out _), Is.True, "a physics step syncs too");
        }

        [Test]
        public void Raycast_ScaledRoundColliders_UseTheLargerScales()
        {
            GameObject sphere = Place(PrimitiveType.Sphere, new Vector3(0, 0, 5));
            sphere.transform.localScale = new Vector3(4, 1, 1);
            Physics.SyncTransforms();
            Cast(Vector3.zero, Vector3.forward, out RaycastHit hit);
            Assert.That(hit.distance, Is.EqualTo(3f).Within(1e-5), "radius times the largest");
            Object.DestroyImmediate(sphere);

            GameObject capsule = Place(PrimitiveType.Capsule, new Vector3(0, 0, 5));
            capsule.transform.localScale = new Vector3(3, 2, 1);
            Physics.SyncTransforms();
            Cast(new Vector3(0, 0.4f, 0), Vector3.forward, out hit);
            Assert.That(hit.distance, Is.EqualTo(3.5f).Within(1e-5), "radius times the larger across the axis");
            Assert.That(Cast(new Vector3(0, 1.9f, 0), Vector3.forward, out _), Is.True, "height times the scale along it");
            Assert.That(Cast(new Vector3(0, 2.1f, 0), Vector3.forward, out _), Is.False);
        }

        [Test]
        public void Raycast_TurnedBoxWithCenter_MeetsItWhereItStands()
        {
            GameObject target = Place(PrimitiveType.Cube, new Vector3(0, 0, 5));
            target.transform.localRotation = Quaternion.Euler(0, 90, 0);
            target.transform.localScale = new Vector3(2, 1, 4);
            BoxCollider box = target.GetComponent<BoxCollider>();
            box.center = new Vector3(0, 0, 0.5f);
            Physics.SyncTransforms();
            // Local z, four long and shifted by two, now points along world x; local x, two long, against world z.
            Assert.That(Cast(new Vector3(3.9f, 0, 0), Vector3.forward, out RaycastHit hit), Is.True);
            Assert.That(hit.distance, Is.EqualTo(4f).Within(1e-5));
            Assert.That(Cast(new Vector3(-0.1f, 0, 0), Vector3.forward, out _), Is.False);
        }

        private static GameObject Place(PrimitiveType type, Vector3 position)
        {
            GameObject placed = GameObject.CreatePrimitive(type);
            placed.transform.position = position;
            Physics.SyncTransforms();
            return placed;
        }

        private static bool Cast(Vector3 origin, Vector3 direction, out RaycastHit hit) => Physics.Raycast(origin, direction, out hit);

        private static bool Meets(QueryTriggerInteraction triggers) =>
            Physics.Raycast(Vector3.zero, Vector3.forward, out _, 100, -1, triggers);
    }
}
