// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityStandIn;

namespace UnityEngine
{
    /// <summary>
    /// Stands for physics where the transform stood at the last Physics.SyncTransforms or physics step, not where it is now.
    /// </summary>
    public class Collider : Component
    {
        public bool enabled { get; set; } = true;

        public bool isTrigger { get; set; }

        internal PhysicsPose Pose { get; private set; }

        internal void SyncTransform() => Pose = new PhysicsPose(transform);

        internal override void Refresh() => SyncTransform();

        /// <summary>Distance along the unit direction and the outward normal at the first entry; none from within.</summary>
        internal virtual bool Meets(Vector3 origin, Vector3 direction, out double distance, out Vector3 normal)
        {
            distance = 0;
            normal = default;
            return false;
        }
    }
}
