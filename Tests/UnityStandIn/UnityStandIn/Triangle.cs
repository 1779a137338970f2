// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityEngine;

namespace UnityStandIn
{
    /// <summary>Where a ray meets the plane of a triangle, and whether inside all three edges; in double.</summary>
    internal static class Triangle
    {
        public static bool TryMeet(Vector3 from, Vector3 along, Vector3 a, Vector3 b, Vector3 c, bool withBack, out double distance, out Vector3 normal)
        {
            distance = 0;
            normal = Vector3.Cross(b - a, c - a).normalized;
            double facing = Dot(Vector3.Cross(b - a, c - a), along);
            // Clockwise in left-handed axes: the cross product points to the viewer, so a front is met against it.
            if (facing == 0 || (facing > 0 && !withBack))
                return false;
            distance = Dot(Vector3.Cross(b - a, c - a), a - from) / facing;
            if (distance < 0)
                return false;
            Vector3 p = from + along * (float)distance;
            double ab = Dot(Vector3.Cross(b - a, p - a), normal), bc = Dot(Vector3.Cross(c - b, p - b), normal), ca = Dot(Vector3.Cross(a - c, p - c), normal);
            return ab >= 0 && bc >= 0 && ca >= 0;
        }

        private static double Dot(Vector3 a, Vector3 b) => (double)a.x * b.x + (double)a.y * b.y + (double)a.z * b.z;
    }
}
