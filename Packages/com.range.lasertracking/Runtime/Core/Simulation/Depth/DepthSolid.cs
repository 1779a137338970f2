using System;
using System.Numerics;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// A capsule, ellipsoid or box in camera 1's space (mm) that rays through its pixels can be tested against. Rays are
    /// (x, y, 1), so that the ray's parameter is the depth.
    /// </summary>
    internal struct DepthSolid
    {
        private enum Form : byte
        {
            Capsule,
            Ellipsoid,
            Box,
        }

        private Form _form;
        private Vector3 _a, _b, _axisX, _axisY, _axisZ;
        private float _radius;

        /// <summary>Share of its pixels that return no depth.</summary>
        public float LostShare;

        /// <summary>Middle and radius of a sphere around each end: what bounds it in the picture.</summary>
        public Vector3 EndA, EndB;

        public float EndRadius;

        public static DepthSolid Capsule(Vector3D a, Vector3D b, double radius, float lostShare = 0) => new DepthSolid
        {
            _form = Form.Capsule, _a = Single(a), _b = Single(b), _radius = (float)radius, LostShare = lostShare,
            EndA = Single(a), EndB = Single(b), EndRadius = (float)radius,
        };

        /// <summary>Half axes are vectors at right angles.</summary>
        public static DepthSolid Ellipsoid(Vector3D center, Vector3D halfX, Vector3D halfY, Vector3D halfZ, float lostShare = 0) =>
            Aligned(Form.Ellipsoid, center, halfX, halfY, halfZ, Math.Max(halfX.Length, Math.Max(halfY.Length, halfZ.Length)), lostShare);

        public static DepthSolid Box(Vector3D center, Vector3D halfX, Vector3D halfY, Vector3D halfZ, float lostShare = 0) =>
            Aligned(Form.Box, center, halfX, halfY, halfZ, (halfX + halfY + halfZ).Length, lostShare);

        /// <summary>Depth at which the ray meets it; 0 when it does not.</summary>
        public readonly float Depth(float x, float y)
        {
            switch (_form)
            {
                case Form.Capsule: return CapsuleDepth(new Vector3(x, y, 1));
                case Form.Ellipsoid: return EllipsoidDepth(new Vector3(x, y, 1));
                default: return BoxDepth(new Vector3(x, y, 1));
            }
        }

        private static DepthSolid Aligned(Form form, Vector3D center, Vector3D halfX, Vector3D halfY, Vector3D halfZ, double radius, float lostShare)
        {
            Vector3 middle = Single(center);
            // Each row divided by its squared length: the dot product with it is 1 at the end of the half axis.
            return new DepthSolid
            {
                _form = form, _a = middle, LostShare = lostShare, EndA = middle, EndB = middle, EndRadius = (float)radius,
                _axisX = Single(halfX * (1 / halfX.LengthSquared)),
                _axisY = Single(halfY * (1 / halfY.LengthSquared)),
                _axisZ = Single(halfZ * (1 / halfZ.LengthSquared)),
            };
        }

        // Written out: the library's sums in another order with and without vector hardware.
        private static float Dot(Vector3 a, Vector3 b) => a.X * b.X + a.Y * b.Y + a.Z * b.Z;

        private static Vector3 Single(Vector3D v) => new Vector3((float)v.X, (float)v.Y, (float)v.Z);

        // After I. Quilez's capsule intersection, for a ray that is not of unit length.
        private readonly float CapsuleDepth(Vector3 ray)
        {
            Vector3 ba = _b - _a, oa = -_a;
            float baba = Dot(ba, ba), bard = Dot(ba, ray), baoa = Dot(ba, oa);
            float rdoa = Dot(ray, oa), oaoa = Dot(oa, oa), rr = Dot(ray, ray), r2 = _radius * _radius;
            float a = baba * rr - bard * bard, b = baba * rdoa - baoa * bard, c = baba * oaoa - baoa * baoa - r2 * baba;
            float h = b * b - a * c;
            if (h < 0)
                return 0;
            float t = (-b - (float)Math.Sqrt(h)) / a, along = baoa + t * bard;
            if (along > 0 && along < baba)
                return t;
            Vector3 oc = along <= 0 ? oa : -_b;
            b = Dot(ray, oc);
            c = Dot(oc, oc) - r2;
            h = b * b - rr * c;
            return h > 0 ? (-b - (float)Math.Sqrt(h)) / rr : 0;
        }

        private readonly float EllipsoidDepth(Vector3 ray)
        {
            var o = new Vector3(-Dot(_axisX, _a), -Dot(_axisY, _a), -Dot(_axisZ, _a));
            var d = new Vector3(Dot(_axisX, ray), Dot(_axisY, ray), Dot(_axisZ, ray));
            float a = Dot(d, d), b = Dot(o, d), c = Dot(o, o) - 1, h = b * b - a * c;
            return h > 0 ? (-b - (float)Math.Sqrt(h)) / a : 0;
        }

        private readonly float BoxDepth(Vector3 ray)
        {
            float near = 0, far = float.MaxValue;
            return Slab(_axisX, ray, ref near, ref far) && Slab(_axisY, ray, ref near, ref far) && Slab(_axisZ, ray, ref near, ref far) ? near : 0;
        }

        private readonly bool Slab(Vector3 axis, Vector3 ray, ref float near, ref float far)
        {
            float o = -Dot(axis, _a), d = Dot(axis, ray);
            if (Math.Abs(d) < 1e-12f)
                return Math.Abs(o) <= 1;
            float t1 = (-1 - o) / d, t2 = (1 - o) / d;
            near = Math.Max(near, Math.Min(t1, t2));
            far = Math.Min(far, Math.Max(t1, t2));
            return near < far;
        }
    }
}
