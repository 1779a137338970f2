using System;
using NUnit.Framework;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>Left-handed, y up, z forward; degrees; Euler angles about z, x, y in this order.</summary>
    public sealed class TransformTests : StandInTests
    {
        private const float Tolerance = 1e-4f;

        [Test]
        public void Euler_QuarterTurns_TurnTheAxesAsInUnity()
        {
            Expect(Quaternion.Euler(0, 90, 0) * Vector3.forward, Vector3.right);
            Expect(Quaternion.Euler(90, 0, 0) * Vector3.forward, Vector3.down);
            Expect(Quaternion.Euler(0, 0, 90) * Vector3.right, Vector3.up);
            Expect(Quaternion.Euler(90, 90, 0) * Vector3.up, Vector3.right);
        }

        [Test]
        public void LookRotation_OfDirection_TurnsForwardThere()
        {
            var direction = new Vector3(1, -2, 0.5f);
            Expect(Quaternion.LookRotation(direction) * Vector3.forward, direction.normalized);
            Assert.That((Quaternion.LookRotation(direction) * Vector3.right).y, Is.EqualTo(0).Within(Tolerance), "no roll");
        }

        [Test]
        public void Matrix_RotationOfRotate_IsTheSameRotation()
        {
            var random = new System.Random(4);
            for (int i = 0; i < 200; i++)
            {
                Quaternion q = Quaternion.Euler(Next(random, 360), Next(random, 360), Next(random, 360));
                Quaternion back = Matrix4x4.TRS(Vector3.one, q, new Vector3(2, 3, 0.5f)).rotation;
                Assert.That(Mathf.Abs(Quaternion.Dot(q, back)), Is.EqualTo(1).Within(1e-5));
            }
        }

        [Test]
        public void TransformPoint_ThroughHierarchy_EqualsProductOfMatrices()
        {
            var random = new System.Random(7);
            for (int i = 0; i < 100; i++)
            {
                Transform a = Random(random, null), b = Random(random, a), c = Random(random, b);
                Matrix4x4 product = LocalMatrix(a) * LocalMatrix(b) * LocalMatrix(c);
                var point = new Vector3(Next(random, 3), Next(random, 3), Next(random, 3));
                Expect(c.TransformPoint(point), product.MultiplyPoint3x4(point));
                Expect(c.position, product.MultiplyPoint3x4(Vector3.zero));
                Expect(c.TransformVector(point), product.MultiplyVector(point));
                Expect(c.InverseTransformPoint(c.TransformPoint(point)), point);
                Assert.That(Mathf.Abs(Quaternion.Dot(c.rotation, a.localRotation * b.localRotation * c.localRotation)), Is.EqualTo(1).Within(1e-5));
            }
        }

        [Test]
        public void Inverse_TimesMatrix_IsIdentity()
        {
            Matrix4x4 matrix = Matrix4x4.TRS(new Vector3(1, 2, 3), Quaternion.Euler(10, 20, 30), new Vector3(2, 0.5f, -3));
            Matrix4x4 product = matrix.inverse * matrix;
            for (int i = 0; i < 16; i++)
                Assert.That(product[i], Is.EqualTo(Matrix4x4.identity[i]).Within(1e-6));
            Assert.That(Matrix4x4.Scale(Vector3.zero).inverse, Is.EqualTo(default(Matrix4x4)));
        }

        [Test]
        public void Position_SetInHierarchy_IsTheWorldPosition()
        {
            var random = new System.Random(9);
            Transform child = Random(random, Random(random, null));
            child.SetPositionAndRotation(new Vector3(3, 1, -2), Quaternion.Euler(5, 6, 7));
            Expect(child.position, new Vector3(3, 1, -2));
            Assert.That(Quaternion.Angle(child.rotation, Quaternion.Euler(5, 6, 7)), Is.LessThan(0.1f));
        }

        [Test]
        public void SetParent_WorldPositionStays_KeepsTheWorldPose()
        {
            var random = new System.Random(3);
            Transform parent = new GameObject().transform;
            parent.localPosition = new Vector3(1, 2, 3);
            parent.localRotation = Quaternion.Euler(20, 30, 40);
            parent.localScale = new Vector3(2, 2, 2);
            Transform child = Random(random, null);
            Vector3 position = child.position, scale = child.lossyScale;
            Quaternion rotation = child.rotation;
            child.SetParent(parent);
            Expect(child.position, position);
            Expect(child.lossyScale, scale);
            Assert.That(Quaternion.Angle(child.rotation, rotation), Is.LessThan(0.1f));
            Assert.That(child.root, Is.SameAs(parent));
            child.SetParent(null, false);
            Assert.That(Vector3.Distance(child.position, position), Is.GreaterThan(0.1f), "local values stay when asked to");
        }

        [Test]
        public void TransformDirection_IgnoresScale()
        {
            Transform scaled = new GameObject().transform;
            scaled.localScale = new Vector3(5, 5, 5);
            scaled.localRotation = Quaternion.Euler(0, 90, 0);
            Expect(scaled.TransformDirection(Vector3.forward), Vector3.right);
            Expect(scaled.TransformVector(Vector3.forward), Vector3.right * 5);
            Expect(scaled.forward, Vector3.right);
        }

        private static Transform Random(System.Random random, Transform? parent)
        {
            Transform made = new GameObject().transform;
            made.SetParent(parent, false);
            made.localPosition = new Vector3(Next(random, 2), Next(random, 2), Next(random, 2));
            made.localRotation = Quaternion.Euler(Next(random, 360), Next(random, 360), Next(random, 360));
            made.localScale = new Vector3(0.5f + (float)random.NextDouble(), 0.5f + (float)random.NextDouble(), 0.5f + (float)random.NextDouble());
            return made;
        }

        private static Matrix4x4 LocalMatrix(Transform transform) =>
            Matrix4x4.Translate(transform.localPosition) * Matrix4x4.Rotate(transform.localRotation) * Matrix4x4.Scale(transform.localScale);

        private static float Next(System.Random random, float range) => (float)(random.NextDouble() * 2 - 1) * range;

        private static void Expect(Vector3 actual, Vector3 expected) =>
            Assert.That(Vector3.Distance(actual, expected), Is.LessThan(Tolerance), actual + " instead of " + expected);
    }
}
