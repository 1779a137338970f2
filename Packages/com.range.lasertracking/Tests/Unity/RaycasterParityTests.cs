using System;
using LaserTracking.Geometry;
using LaserTracking.Scoring;
using NUnit.Framework;
using UnityEngine;
using RaycastHit = LaserTracking.Scoring.RaycastHit;

namespace LaserTracking.Unity
{
    /// <summary>
    /// What is scored headlessly must be what Unity's physics would have hit. Play mode, because targets move only there.
    /// </summary>
    public sealed class RaycasterParityTests
    {
        private const double ToleranceM = 1e-3;
        private const int Rays = 600;

        private SceneParts _parts = new SceneParts();

        [SetUp]
        public void Begin() => _parts = new SceneParts();

        [TearDown]
        public void CleanUp() => _parts.DestroyAll();

        [Test]
        public void PhysicsRaycaster_StandingObjects_HitsWhatTheAnalyticOneHits()
        {
            Transform parent = _parts.Add(PrimitiveType.Cube, null, new Vector3(-2, 0, 9), new Vector3(0, 20, 0), new Vector3(1, 2, 0.5f), 8).transform;
            _parts.Add(PrimitiveType.Sphere, null, new Vector3(1, 1, 7), Vector3.zero, new Vector3(1.5f, 1.5f, 1.5f), 8);
            _parts.Add(PrimitiveType.Capsule, null, new Vector3(0, -1, 6), new Vector3(10, 0, 70), new Vector3(0.6f, 0.8f, 0.6f), 8);
            _parts.Add(PrimitiveType.Quad, null, new Vector3(2, -1, 5), new Vector3(15, -10, 30), new Vector3(2, 1, 1), 8);
            _parts.Add(PrimitiveType.Quad, null, new Vector3(-1, 1.5f, 4), new Vector3(0, 180, 0), new Vector3(2, 2, 1), 8);
            _parts.Add(PrimitiveType.Cube, null, new Vector3(0, 0, 3), Vector3.zero, new Vector3(3, 3, 0.1f), 9);
            _parts.Add(PrimitiveType.Sphere, parent, new Vector3(0, 0, -3), Vector3.zero, Vector3.one, 8);
            Compare(1 << 8, new double[] { 0 }, 100);
        }

        [Test]
        public void PhysicsRaycaster_Triggers_AreMetAsTheAnalyticOneMeetsThem()
        {
            _parts.Add(PrimitiveType.Cube, null, new Vector3(0, 0, 4), Vector3.zero, new Vector3(2, 2, 1), 8);
            _parts.MakeLastATrigger();
            _parts.Add(PrimitiveType.Cube, null, new Vector3(0, 0, 8), Vector3.zero, new Vector3(4, 4, 1), 8);
            Compare(1 << 8, new double[] { 0 }, 30);
        }

        [Test]
        public void PhysicsRaycaster_MovingTargets_AreMetWhereTheyWereThen()
        {
            Transform carrier = new GameObject("carrier").transform;
            carrier.position = new Vector3(0, 0, 2);
            carrier.rotation = Quaternion.Euler(0, 25, 10);
            try
            {
                _parts.Add(PrimitiveType.Cube, carrier, new Vector3(-2, 1, 6), Vector3.zero, new Vector3(1, 1, 0.1f), 8);
                _parts.Move(MotionKind.PingPong, new Vector3(4, 0, 0), 3, 0.4f);
                _parts.Add(PrimitiveType.Sphere, null, new Vector3(0, -1, 7), Vector3.zero, Vector3.one, 8);
                TargetMotion sine = _parts.Move(MotionKind.Sine, new Vector3(2, 1, 0), 5, 0);
                Vector3 shown = sine.transform.localPosition;
                Compare(1 << 8, new[] { 0, 0.7, 1.9, 12.3 }, 30);
                Assert.That(sine.transform.localPosition.Equals(shown), Is.True, "what is shown is put back to the bit");
            }
            finally
            {
                UnityEngine.Object.DestroyImmediate(carrier.gameObject);
            }
        }

        private void Compare(int layerMask, double[] timesS, int atLeast)
        {
            Physics.SyncTransforms();
            var analytic = new AnalyticRaycaster(_parts.Model(layerMask));
            var physics = new PhysicsRaycaster(layerMask, QueryTriggerInteraction.Collide);
            var random = new System.Random(17);
            int hits = 0;
            foreach (double timeS in timesS)
            {
                for (int i = 0; i < Rays; i++)
                {
                    var ray = new Ray3D(default, new Vector3D(random.NextDouble() - 0.5, random.NextDouble() - 0.5, 1));
                    if (!TryClearCut(analytic, ray, timeS, out bool expectsHit, out RaycastHit expected))
                        continue;
                    bool met = physics.TryRaycast(ray, 100, timeS, out RaycastHit actual);
                    Assert.That(met, Is.EqualTo(expectsHit), "ray " + i + " at " + timeS + " s");
                    if (!met)
                        continue;
                    hits++;
                    Same(physics, actual, analytic, expected, "ray " + i + " at " + timeS + " s");
                }
            }

            Assert.That(hits, Is.GreaterThanOrEqualTo(atLeast), "rays that hit something");
        }

        private static void Same(PhysicsRaycaster physics, RaycastHit actual, AnalyticRaycaster analytic, RaycastHit expected, string which)
        {
            physics.TryGetTarget(actual.ObjectIndex, out string name, out _);
            analytic.TryGetTarget(expected.ObjectIndex, out string expectedName, out _);
            Assert.That(name, Is.EqualTo(expectedName), which);
            Assert.That((actual.PointM - expected.PointM).Length, Is.LessThan(ToleranceM), which);
            Assert.That(actual.DistanceM, Is.EqualTo(expected.DistanceM).Within(ToleranceM), which);
            Assert.That((actual.LocalPointM - expected.LocalPointM).Length, Is.LessThan(ToleranceM), which);
            Assert.That((actual.ObjectPose.Position - expected.ObjectPose.Position).Length, Is.LessThan(ToleranceM), which);
            Assert.That((actual.Normal - expected.Normal).Length, Is.LessThan(0.01), which);
        }

        /// <summary>False at an edge, where floats may decide otherwise: the rays around do not agree on the object.</summary>
        private static bool TryClearCut(AnalyticRaycaster analytic, Ray3D ray, double timeS, out bool isHit, out RaycastHit hit)
        {
            isHit = analytic.TryRaycast(ray, 100, timeS, out hit);
            for (int i = 0; i < 4; i++)
            {
                var aside = new Vector3D(i < 2 ? (i - 0.5) * 2e-3 : 0, i < 2 ? 0 : (i - 2.5) * 2e-3, 0);
                bool isHitAside = analytic.TryRaycast(new Ray3D(ray.Origin, ray.Direction + aside), 100, timeS, out RaycastHit hitAside);
                if (isHitAside != isHit || (isHit && hitAside.ObjectIndex != hit.ObjectIndex) || (isHit && (hitAside.Normal - hit.Normal).Length > 0.1))
                    return false;
            }

            return true;
        }
    }
}
