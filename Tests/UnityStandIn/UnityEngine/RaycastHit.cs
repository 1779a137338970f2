// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine
{
    public struct RaycastHit
    {
        public Vector3 point { get; set; }

        public Vector3 normal { get; set; }

        public float distance { get; set; }

        public Collider collider { get; internal set; }

        public Transform transform => collider == null ? null : collider.transform;
    }
}
