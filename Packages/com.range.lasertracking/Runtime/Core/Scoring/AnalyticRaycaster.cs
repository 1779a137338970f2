using System;
using LaserTracking.Geometry;

namespace LaserTracking.Scoring
{
    /// <summary>
    /// Casts rays into a <see cref="SceneModel"/> in closed form and in double precision, with the rules of Unity's
    /// Physics.Raycast: nearest first (equal distances: the first in hierarchy order), a collider whose inside or surface holds the
    /// origin is not hit, a quad only from its front, a hit at exactly the maximum distance counts, a ray without direction or with
    /// NaN hits nothing. Reads only; safe to use from several threads. No allocation per cast.
    /// </summary>
    public sealed class AnalyticRaycaster : IRaycaster
    {
        private readonly SceneModel _scene;
        private readonly ScaledCollider[] _colliders;

        /// <param name="scene">Its layer mask decides which objects take part.</param>
        /// <param name="queriesHitTriggers">As Unity's setting of that name, which is on by default.</param>
        public AnalyticRaycaster(SceneModel scene, bool queriesHitTriggers = true)
        {
            _scene = scene;
            int count = 0;
            foreach (SceneObject candidate in scene.Objects)
                count += CountOf(candidate, scene.LayerMask, queriesHitTriggers);
            _colliders = new ScaledCollider[count];
            count = 0;
            for (int i = 0; i < scene.Objects.Count; i++)
            {
                SceneObject owner = scene.Objects[i];
                foreach (SceneCollider collider in owner.Colliders)
                {
                    if (TakesPart(owner, collider, scene.LayerMask, queriesHitTriggers))
                        _colliders[count++] = new ScaledCollider(collider, owner.Scale, i);
                }
            }
        }

        /// <inheritdoc/>
        public bool TryRaycast(in Ray3D ray, double maxDistanceM, double sceneTimeS, out RaycastHit hit)
        {
            hit = default;
            if (!ray.Origin.IsFinite || !ray.Direction.IsFinite || ray.Direction.LengthSquared == 0)
                return false;
            if (!(maxDistanceM > 0) || double.IsNaN(sceneTimeS) || double.IsInfinity(sceneTimeS))
                return false;

            double nearest = maxDistanceM;
            bool found = false;
            int poseOf = -1;
            Pose pose = default;
            Vector3D origin = default, direction = default;
            for (int i = 0; i < _colliders.Length; i++)
            {
                int owner = _colliders[i].ObjectIndex;
                if (owner != poseOf)
                {
                    poseOf = owner;
                    pose = _scene.Objects[owner].PoseAt(sceneTimeS);
                    origin = pose.InverseTransformPoint(ray.Origin);
                    direction = pose.InverseTransformDirection(ray.Direction);
                }

                if (!_colliders[i].TryRaycast(origin, direction, out double distance, out Vector3D normal))
                    continue;
                if (found ? !(distance < nearest) : !(distance <= nearest))
                    continue;
                found = true;
                nearest = distance;
                hit.ObjectIndex = owner;
                hit.ObjectPose = pose;
                hit.DistanceM = distance;
                hit.PointM = ray.At(distance);
                hit.LocalPointM = origin + direction * distance;
                hit.Normal = pose.TransformDirection(normal);
            }

            return found;
        }

        /// <inheritdoc/>
        public bool TryGetTarget(int objectIndex, out string name, out TargetDefinition? definition)
        {
            if (objectIndex < 0 || objectIndex >= _scene.Objects.Count)
            {
                name = "";
                definition = null;
                return false;
            }

            name = _scene.Objects[objectIndex].Name;
            definition = _scene.Objects[objectIndex].Target;
            return true;
        }

        private static int CountOf(SceneObject owner, int layerMask, bool triggers)
        {
            int count = 0;
            foreach (SceneCollider collider in owner.Colliders)
            {
                if (TakesPart(owner, collider, layerMask, triggers))
                    count++;
            }

            return count;
        }

        private static bool TakesPart(SceneObject owner, SceneCollider collider, int layerMask, bool triggers) =>
            (layerMask & 1 << (collider.IsOnChild ? collider.ChildLayer : owner.Layer)) != 0 && (triggers || !collider.IsTrigger);
    }
}
