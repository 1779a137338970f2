using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Scoring;
using UnityEngine;
using RaycastHit = LaserTracking.Scoring.RaycastHit;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Casts rays with Unity's physics, so that a shot can meet any collider. Targets with a <see cref="TargetMotion"/> are put
    /// where they were at the photon time for the cast and back afterwards. Main thread only.
    /// </summary>
    public sealed class PhysicsRaycaster : IRaycaster
    {
        private readonly int _layerMask;
        private readonly QueryTriggerInteraction _triggers;
        private readonly List<GameObject> _objects = new List<GameObject>();
        private readonly List<string> _names = new List<string>();
        private readonly List<LaserTarget?> _targets = new List<LaserTarget?>();
        private readonly Dictionary<GameObject, int> _indices = new Dictionary<GameObject, int>();
        private RaycastHit _last;
        private bool _hasLast;

        /// <param name="hitLayers">Layers that shots can hit.</param>
        /// <param name="triggers">Whether triggers stop shots; by default as the project's physics settings say.</param>
        public PhysicsRaycaster(LayerMask hitLayers, QueryTriggerInteraction triggers = QueryTriggerInteraction.UseGlobal)
        {
            _layerMask = hitLayers;
            _triggers = triggers;
        }

        public bool TryRaycast(in Ray3D ray, double maxDistanceM, double sceneTimeS, out RaycastHit hit)
        {
            for (int i = 0; i < MovingTargets.Count; i++)
                MovingTargets.At(i).Rewind(sceneTimeS);
            // Colliders follow their transforms only now: without this the ray would meet the targets where they are shown.
            Physics.SyncTransforms();
            try
            {
                return TryRaycastAsPosed(ray, maxDistanceM, out hit);
            }
            finally
            {
                for (int i = MovingTargets.Count - 1; i >= 0; i--)
                    MovingTargets.At(i).Restore();
                Physics.SyncTransforms();
            }
        }

        public bool TryGetTarget(int objectIndex, out string name, out TargetDefinition? definition)
        {
            if (objectIndex < 0 || objectIndex >= _objects.Count || _objects[objectIndex] == null)
            {
                name = "";
                definition = null;
                return false;
            }

            LaserTarget? target = _targets[objectIndex];
            name = _names[objectIndex];
            definition = target == null ? null : target.Definition;
            return true;
        }

        /// <summary>What the last ray met, target or scenery; false when it met nothing since <see cref="Forget"/>.</summary>
        internal bool TryGetLast(out RaycastHit hit, out GameObject? owner, out LaserTarget? target)
        {
            hit = _last;
            owner = _hasLast ? _objects[_last.ObjectIndex] : null;
            target = _hasLast ? _targets[_last.ObjectIndex] : null;
            return _hasLast;
        }

        internal void Forget() => _hasLast = false;

        private bool TryRaycastAsPosed(in Ray3D ray, double maxDistanceM, out RaycastHit hit)
        {
            hit = default;
            _hasLast = false;
            if (!Physics.Raycast(ray.Origin.ToUnity(), ray.Direction.ToUnity(), out UnityEngine.RaycastHit met, (float)maxDistanceM,
                _layerMask, _triggers))
                return false;
            LaserTarget? target = met.collider.GetComponentInParent<LaserTarget>();
            if (target != null && !target.enabled)
                target = null;
            GameObject owner = target == null ? met.collider.gameObject : target.gameObject;
            hit.ObjectIndex = IndexOf(owner, target);
            hit.ObjectPose = owner.transform.WorldPose();
            hit.PointM = met.point.ToCore();
            hit.Normal = met.normal.ToCore();
            hit.DistanceM = met.distance;
            hit.LocalPointM = hit.ObjectPose.InverseTransformPoint(hit.PointM);
            _last = hit;
            _hasLast = true;
            return true;
        }

        private int IndexOf(GameObject owner, LaserTarget? target)
        {
            if (!_indices.TryGetValue(owner, out int index))
            {
                index = _objects.Count;
                _indices.Add(owner, index);
                _objects.Add(owner);
                _names.Add(owner.name);
                _targets.Add(target);
            }

            _targets[index] = target;
            return index;
        }
    }
}
