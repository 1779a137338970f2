// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityEngine;

namespace UnityStandIn
{
    /// <summary>Where physics believes a collider to stand. Local here means: turned and moved back, not scaled back.</summary>
    internal readonly struct PhysicsPose
    {
        private readonly Vector3 _position;
        private readonly Quaternion _rotation;

        public PhysicsPose(Transform transform)
        {
            _position = transform.position;
            _rotation = transform.rotation.normalized;
            Scale = transform.lossyScale;
        }

        public Vector3 Scale { get; }

        public Vector3 ToLocal(Vector3 world) => Quaternion.Inverse(_rotation) * (world - _position);

        public Vector3 ToLocalDirection(Vector3 world) => Quaternion.Inverse(_rotation) * world;

        public Vector3 ToWorldDirection(Vector3 local) => _rotation * local;
    }
}
