// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System.Collections;
using System.Collections.Generic;

namespace UnityEngine
{
    /// <summary>
    /// Local position, rotation and scale; the world's follow from the parents. Rotation and scale of a parent apply to the child's
    /// position; skew from rotated children of unevenly scaled parents is in the matrix, and left out of lossyScale, as in Unity.
    /// </summary>
    public class Transform : Component, IEnumerable
    {
        private Transform _parent;

        protected Transform()
        {
        }

        public Vector3 localPosition { get; set; }

        public Quaternion localRotation { get; set; } = Quaternion.identity;

        public Vector3 localScale { get; set; } = Vector3.one;

        public Transform parent
        {
            get => _parent;
            set => SetParent(value, true);
        }

        public Transform root => _parent == null ? this : _parent.root;

        public int childCount => Children.Count;

        public Vector3 position
        {
            get => _parent == null ? localPosition : _parent.TransformPoint(localPosition);
            set => localPosition = _parent == null ? value : _parent.InverseTransformPoint(value);
        }

        public Quaternion rotation
        {
            get => _parent == null ? localRotation : _parent.rotation * localRotation;
            set => localRotation = _parent == null ? value : Quaternion.Inverse(_parent.rotation) * value;
        }

        public Vector3 forward
        {
            get => rotation * Vector3.forward;
            set => rotation = Quaternion.LookRotation(value);
        }

        public Matrix4x4 localToWorldMatrix
        {
            get
            {
                Matrix4x4 local = Matrix4x4.TRS(localPosition, localRotation, localScale);
                return _parent == null ? local : _parent.localToWorldMatrix * local;
            }
        }

        public Matrix4x4 worldToLocalMatrix => localToWorldMatrix.inverse;

        /// <summary>The matrix's part along the object's own axes: without the skew.</summary>
        public Vector3 lossyScale
        {
            get
            {
                Matrix4x4 scale = Matrix4x4.Rotate(Quaternion.Inverse(rotation)) * localToWorldMatrix;
                return new Vector3(scale.m00, scale.m11, scale.m22);
            }
        }

        internal List<Transform> Children { get; } = new List<Transform>();

        public Transform GetChild(int index) => Children[index];

        public IEnumerator GetEnumerator() => Children.GetEnumerator();

        public bool IsChildOf(Transform parent)
        {
            for (Transform at = this; at != null; at = at._parent)
            {
                if (at == parent)
                    return true;
            }

            return false;
        }

        public void SetParent(Transform p) => SetParent(p, true);

        public void SetParent(Transform parent, bool worldPositionStays)
        {
            if (parent != null && parent.IsChildOf(this))
                return;
            Vector3 worldPosition = position, worldScale = lossyScale;
            Quaternion worldRotation = rotation;
            bool wasActive = gameObject.activeInHierarchy;
            Unhook();
            _parent = parent;
            if (parent != null)
                parent.Children.Add(this);
            if (worldPositionStays)
            {
                position = worldPosition;
                rotation = worldRotation;
                localScale = Vector3.one;
                Vector3 unit = lossyScale;
                localScale = new Vector3(worldScale.x / unit.x, worldScale.y / unit.y, worldScale.z / unit.z);
            }

            if (gameObject.activeInHierarchy != wasActive)
                gameObject.RefreshAll();
        }

        public void SetPositionAndRotation(Vector3 position, Quaternion rotation)
        {
            this.position = position;
            this.rotation = rotation;
        }

        public void Translate(Vector3 translation) => position += rotation * translation;

        public Vector3 TransformPoint(Vector3 position) => localToWorldMatrix.MultiplyPoint3x4(position);

        public Vector3 InverseTransformPoint(Vector3 position) => worldToLocalMatrix.MultiplyPoint3x4(position);

        /// <summary>Scale plays no part: lengths stay.</summary>
        public Vector3 TransformDirection(Vector3 direction) => rotation * direction;

        public Vector3 InverseTransformDirection(Vector3 direction) => Quaternion.Inverse(rotation) * direction;

        public Vector3 TransformVector(Vector3 vector) => localToWorldMatrix.MultiplyVector(vector);

        public Vector3 InverseTransformVector(Vector3 vector) => worldToLocalMatrix.MultiplyVector(vector);

        internal void Unhook()
        {
            if (_parent != null)
                _parent.Children.Remove(this);
            _parent = null;
        }
    }
}
