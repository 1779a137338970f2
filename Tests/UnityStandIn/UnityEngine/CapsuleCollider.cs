// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityStandIn;

namespace UnityEngine
{
    public class CapsuleCollider : Collider
    {
        public Vector3 center { get; set; }

        public float radius { get; set; } = 0.5f;

        /// <summary>Over both caps; never less than a sphere.</summary>
        public float height { get; set; } = 1;

        /// <summary>0 = x, 1 = y, 2 = z.</summary>
        public int direction { get; set; } = 1;

        /// <summary>The height is scaled along the axis, the radius by the larger of the scale across it.</summary>
        internal override bool Meets(Vector3 origin, Vector3 direction, out double distance, out Vector3 normal)
        {
            int axis = this.direction;
            Vector3 from = Pose.ToLocal(origin) - Vector3.Scale(center, Pose.Scale), along = Pose.ToLocalDirection(direction);
            double across = System.Math.Max(System.Math.Abs(Pose.Scale[(axis + 1) % 3]), System.Math.Abs(Pose.Scale[(axis + 2) % 3]));
            double scaled = radius * across;
            double half = System.Math.Max(0, height * System.Math.Abs(Pose.Scale[axis]) / 2 - scaled);
            bool met = RoundSolids.TryEnterCapsule(from, along, axis, half, scaled, out distance);
            Vector3 point = from + along * (float)distance;
            Vector3 onAxis = default;
            onAxis[axis] = (float)System.Math.Max(-half, System.Math.Min(half, point[axis]));
            normal = Pose.ToWorldDirection((point - onAxis).normalized);
            return met;
        }
    }
}
