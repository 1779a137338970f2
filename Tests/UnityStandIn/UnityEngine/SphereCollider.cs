// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityStandIn;

namespace UnityEngine
{
    public class SphereCollider : Collider
    {
        public Vector3 center { get; set; }

        public float radius { get; set; } = 0.5f;

        /// <summary>The largest of the scale's components counts.</summary>
        internal override bool Meets(Vector3 origin, Vector3 direction, out double distance, out Vector3 normal)
        {
            Vector3 from = Pose.ToLocal(origin) - Vector3.Scale(center, Pose.Scale);
            Vector3 scale = Pose.Scale;
            double scaled = radius * System.Math.Max(System.Math.Abs(scale.x), System.Math.Max(System.Math.Abs(scale.y), System.Math.Abs(scale.z)));
            bool met = RoundSolids.TryEnterSphere(from, Pose.ToLocalDirection(direction), scaled, out distance);
            normal = Pose.ToWorldDirection((from + Pose.ToLocalDirection(direction) * (float)distance).normalized);
            return met;
        }
    }
}
