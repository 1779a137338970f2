using System;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Scoring
{
    /// <summary>
    /// Random solids and rays against references that share nothing with the raycaster's formulas: marching along the ray by the
    /// distance to the solid, and triangles by their plane and edges in world space.
    /// </summary>
    public sealed class AnalyticRaycasterPropertyTests
    {
        private const int Rays = 4000;
        private const double MaxDistance = 40;

        [TestCase(ColliderShape.Box)]
        [TestCase(ColliderShape.Sphere)]
        [TestCase(ColliderShape.Capsule)]
        public void AnalyticRaycaster_RandomSolid_AgreesWithMarching(ColliderShape shape)
        {
            var random = new Random(100 + (int)shape);
            int hits = 0, misses = 0, inside = 0, grazing = 0;
            for (int i = 0; i < Rays; i++)
            {
                SceneCollider collider = RandomCollider(random, shape);
                Vector3D scale = RandomVector(random, 0.3, 2);
                if (random.Next(3) == 0)
                    scale = new Vector3D(-scale.X, scale.Y, scale.Z);
                var pose = new Pose(RandomVector(random, -4, 4), RandomRotation(random));
                Ray3D ray = RandomRay(random, pose.TransformPoint(Vector3D.Scale(collider.Center, scale)));
                var raycaster = new AnalyticRaycaster(TestScenes.Of(TestScenes.Object(pose, scale, collider)));
                bool found = raycaster.TryRaycast(ray, MaxDistance, 0, out RaycastHit hit);

                double t = 0, smallest = double.PositiveInfinity;
                double first = Distance(collider, scale, pose, ray.Origin);
                int steps = 0;
                for (double d = first; t < MaxDistance && d > 1e-10 && steps < 20000; d = Distance(collider, scale, pose, ray.At(t)), steps++)
                {
                    smallest = Math.Min(smallest, d);
                    t += d;
                }

                if (first <= 0)
                {
                    inside++;
                    Assert.That(found, Is.False, "case " + i + ": starts inside");
                }
                else if (t >= MaxDistance)
                {
                    misses++;
                    Assert.That(found, Is.False, "case " + i + ": misses by " + smallest);
                }
                else if (steps == 20000)
                {
                    grazing++;
                }
                else
                {
                    hits++;
                    Assert.That(found, Is.True, "case " + i + ": hits at " + t);
                    Assert.That(hit.DistanceM, Is.EqualTo(t).Within(1e-6), "case " + i);
                    Assert.That((hit.PointM - ray.At(hit.DistanceM)).Length, Is.LessThan(1e-9), "case " + i);
                    Assert.That((hit.Normal - Gradient(collider, scale, pose, hit.PointM)).Length, Is.LessThan(1e-3), "case " + i);
                }
            }

            Assert.That(hits, Is.GreaterThan(Rays / 5));
            Assert.That(misses, Is.GreaterThan(Rays / 5));
            Assert.That(inside, Is.GreaterThan(10));
            Assert.That(grazing, Is.LessThan(Rays / 50));
        }

        [Test]
        public void AnalyticRaycaster_RandomQuad_AgreesWithItsTwoTriangles()
        {
            var random = new Random(7);
            int hits = 0;
            for (int i = 0; i < Rays; i++)
            {
                Vector3D scale = RandomVector(random, 1, 5);
                var pose = new Pose(RandomVector(random, -4, 4), RandomRotation(random));
                Ray3D ray = RandomRay(random, pose.Position);
                var raycaster = new AnalyticRaycaster(TestScenes.Of(TestScenes.Object(pose, scale, SceneCollider.Quad())));
                bool found = raycaster.TryRaycast(ray, MaxDistance, 0, out RaycastHit hit);

                Vector3D a = Corner(pose, scale, -1, -1), b = Corner(pose, scale, -1, 1), c = Corner(pose, scale, 1, 1), d = Corner(pose, scale, 1, -1);
                bool expected = Triangle(ray, a, b, c, out double t) || Triangle(ray, a, c, d, out t);
                Assert.That(found, Is.EqualTo(expected), "case " + i);
                if (!expected)
                    continue;
                hits++;
                Assert.That(hit.DistanceM, Is.EqualTo(t).Within(1e-9), "case " + i);
            }

            Assert.That(hits, Is.GreaterThan(Rays / 10));
        }

        [Test]
        public void AnalyticRaycaster_ManyObjects_GivesTheSmallestOfTheirSingleAnswers()
        {
            var random = new Random(3);
            var objects = new SceneObject[12];
            for (int i = 0; i < objects.Length; i++)
            {
                objects[i] = TestScenes.Object(new Pose(RandomVector(random, -3, 3), RandomRotation(random)), RandomVector(random, 0.5, 2),
                    RandomCollider(random, (ColliderShape)(i % 3)));
            }

            var all = new AnalyticRaycaster(TestScenes.Of(objects));
            var single = Array.ConvertAll(objects, one => new AnalyticRaycaster(TestScenes.Of(one)));
            for (int i = 0; i < 2000; i++)
            {
                Ray3D ray = RandomRay(random, RandomVector(random, -3, 3));
                int nearest = -1;
                double distance = double.PositiveInfinity;
                for (int k = 0; k < single.Length; k++)
                {
                    if (single[k].TryRaycast(ray, MaxDistance, 0, out RaycastHit one) && one.DistanceM < distance)
                    {
                        nearest = k;
                        distance = one.DistanceM;
                    }
                }

                Assert.That(all.TryRaycast(ray, MaxDistance, 0, out RaycastHit hit), Is.EqualTo(nearest >= 0));
                if (nearest >= 0)
                    Assert.That(hit.ObjectIndex, Is.EqualTo(nearest));
            }
        }

        // Distance from a world point to the solid, negative inside, by Unity's rules of scale.
        private static double Distance(in SceneCollider collider, Vector3D scale, Pose pose, Vector3D world)
        {
            Vector3D p = pose.InverseTransformPoint(world) - Vector3D.Scale(collider.Center, scale);
            double sx = Math.Abs(scale.X), sy = Math.Abs(scale.Y), sz = Math.Abs(scale.Z);
            if (collider.Shape == ColliderShape.Sphere)
                return p.Length - collider.Radius * Math.Max(sx, Math.Max(sy, sz));
            if (collider.Shape == ColliderShape.Box)
            {
                double qx = Math.Abs(p.X) - collider.Size.X * sx / 2, qy = Math.Abs(p.Y) - collider.Size.Y * sy / 2, qz = Math.Abs(p.Z) - collider.Size.Z * sz / 2;
                double outside = new Vector3D(Math.Max(qx, 0), Math.Max(qy, 0), Math.Max(qz, 0)).Length;
                return outside + Math.Min(0, Math.Max(qx, Math.Max(qy, qz)));
            }

            double along = collider.Axis == 0 ? p.X : collider.Axis == 1 ? p.Y : p.Z;
            double axisScale = collider.Axis == 0 ? sx : collider.Axis == 1 ? sy : sz;
            double across = collider.Axis == 0 ? Math.Max(sy, sz) : collider.Axis == 1 ? Math.Max(sx, sz) : Math.Max(sx, sy);
            double radius = collider.Radius * across, half = Math.Max(0, collider.Height * axisScale / 2 - radius);
            double beyond = Math.Max(0, Math.Abs(along) - half);
            return Math.Sqrt(Math.Max(0, p.LengthSquared - along * along) + beyond * beyond) - radius;
        }

        private static Vector3D Gradient(in SceneCollider collider, Vector3D scale, Pose pose, Vector3D p)
        {
            const double h = 1e-6;
            double o = Distance(collider, scale, pose, p);
            return new Vector3D(Distance(collider, scale, pose, p + new Vector3D(h, 0, 0)) - o, Distance(collider, scale, pose, p + new Vector3D(0, h, 0)) - o,
                Distance(collider, scale, pose, p + new Vector3D(0, 0, h)) - o) * (1 / h);
        }

        // Clockwise as seen from the front, as Unity winds its triangles.
        private static bool Triangle(in Ray3D ray, Vector3D a, Vector3D b, Vector3D c, out double t)
        {
            Vector3D normal = Vector3D.Cross(b - a, c - a);
            double facing = Vector3D.Dot(ray.Direction, normal);
            t = facing < 0 ? Vector3D.Dot(a - ray.Origin, normal) / facing : -1;
            if (!(t > 0 && t <= MaxDistance))
                return false;
            Vector3D p = ray.At(t);
            return Vector3D.Dot(Vector3D.Cross(b - a, p - a), normal) >= 0 && Vector3D.Dot(Vector3D.Cross(c - b, p - b), normal) >= 0
                && Vector3D.Dot(Vector3D.Cross(a - c, p - c), normal) >= 0;
        }

        private static Vector3D Corner(Pose pose, Vector3D scale, int x, int y) =>
            pose.TransformPoint(new Vector3D(x * scale.X / 2, y * scale.Y / 2, 0));

        private static SceneCollider RandomCollider(Random random, ColliderShape shape)
        {
            Vector3D center = RandomVector(random, -0.5, 0.5);
            if (shape == ColliderShape.Box)
                return SceneCollider.Box(center, RandomVector(random, 0.2, 3));
            double radius = 0.2 + random.NextDouble();
            return shape == ColliderShape.Sphere ? SceneCollider.Sphere(center, radius) : SceneCollider.Capsule(center, radius, 4 * random.NextDouble() + 0.1, random.Next(3));
        }

        private static Ray3D RandomRay(Random random, Vector3D near)
        {
            Vector3D origin = random.Next(10) == 0 ? near + RandomVector(random, -0.5, 0.5) : RandomVector(random, -9, 9);
            return new Ray3D(origin, random.Next(8) == 0 ? RandomVector(random, -1, 1) : near + RandomVector(random, -1.5, 1.5) - origin);
        }

        private static Rotation3D RandomRotation(Random random) =>
            random.Next(5) == 0 ? Rotation3D.Identity : Rotation3D.AboutAxis(RandomVector(random, -1, 1), 6 * random.NextDouble());

        private static Vector3D RandomVector(Random random, double low, double high) => new Vector3D(
            low + (high - low) * random.NextDouble(), low + (high - low) * random.NextDouble(), low + (high - low) * random.NextDouble());
    }
}
