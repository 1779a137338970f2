using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>One pooled mark on whatever a shot met: goes where that goes, and away with it.</summary>
    internal sealed class HoleMark
    {
        /// <summary>Off the surface, so that the two do not flicker through each other.</summary>
        private const float LiftM = 0.002f;

        private readonly GameObject _object;
        private readonly Transform _transform;
        private readonly Renderer _renderer;
        private Transform? _met;
        private Vector3 _localPoint;
        private Quaternion _localRotation;

        public HoleMark(Transform parent, Material? material, float diameterM)
        {
            _object = GameObject.CreatePrimitive(PrimitiveType.Quad);
            _object.name = "Hole";
            // At once, not at the end of the frame: a shot cast meanwhile must not meet a mark.
            Object.DestroyImmediate(_object.GetComponent<Collider>());
            _transform = _object.transform;
            _transform.SetParent(parent, false);
            _transform.localScale = new Vector3(diameterM, diameterM, 1);
            _renderer = _object.GetComponent<Renderer>();
            _renderer.sharedMaterial = material;
            _object.SetActive(false);
        }

        public bool IsShown => _object.activeSelf;

        public void Show(in ShotTrace trace, MaterialPropertyBlock color)
        {
            _met = trace.Met;
            Vector3 normal = trace.LocalNormal;
            // A quad is seen from the side that its z axis points away from.
            _localRotation = Quaternion.LookRotation(new Vector3(-normal.x, -normal.y, -normal.z), Mathf.Abs(normal.y) > 0.99f ? Vector3.forward : Vector3.up);
            _localPoint = trace.LocalEnd + normal * LiftM;
            _renderer.SetPropertyBlock(color);
            _object.SetActive(true);
            Follow();
        }

        /// <summary>Once what it is on has moved.</summary>
        public void Follow()
        {
            if (!_object.activeSelf)
                return;
            if (_met == null || !_met.gameObject.activeInHierarchy)
            {
                Hide();
                return;
            }

            Quaternion rotation = _met.rotation;
            _transform.SetPositionAndRotation(_met.position + rotation * _localPoint, rotation * _localRotation);
        }

        public void Hide()
        {
            _met = null;
            _object.SetActive(false);
        }
    }
}
