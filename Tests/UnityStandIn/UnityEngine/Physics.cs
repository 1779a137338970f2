// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityStandIn;

namespace UnityEngine
{
    public class Physics
    {
        /// <summary>All layers but "Ignore Raycast" (2).</summary>
        public const int DefaultRaycastLayers = ~(1 << 2);

        public static bool queriesHitTriggers { get; set; } = true;

        public static bool queriesHitBackfaces { get; set; }

        public static void SyncTransforms()
        {
            foreach (Collider collider in World.Colliders)
                collider.SyncTransform();
        }

        public static bool Raycast(Vector3 origin, Vector3 direction, out RaycastHit hitInfo) =>
            Raycast(origin, direction, out hitInfo, float.PositiveInfinity);

        public static bool Raycast(Vector3 origin, Vector3 direction, out RaycastHit hitInfo, float maxDistance) =>
            Raycast(origin, direction, out hitInfo, maxDistance, DefaultRaycastLayers);

        public static bool Raycast(Vector3 origin, Vector3 direction, out RaycastHit hitInfo, float maxDistance, int layerMask) =>
            Raycast(origin, direction, out hitInfo, maxDistance, layerMask, QueryTriggerInteraction.UseGlobal);

        /// <summary>The nearest entry; colliders that hold the origin are not met.</summary>
        public static bool Raycast(Vector3 origin, Vector3 direction, out RaycastHit hitInfo, float maxDistance, int layerMask,
            QueryTriggerInteraction queryTriggerInteraction)
        {
            hitInfo = default;
            Vector3 unit = direction.normalized;
            if (unit.Equals(Vector3.zero))
                return false;
            bool withTriggers = queryTriggerInteraction == QueryTriggerInteraction.Collide
                || (queryTriggerInteraction == QueryTriggerInteraction.UseGlobal && queriesHitTriggers);
            double nearest = maxDistance;
            foreach (Collider collider in World.Colliders)
            {
                if (!collider.enabled || !collider.gameObject.activeInHierarchy || (layerMask & 1 << collider.gameObject.layer) == 0
                    || (collider.isTrigger && !withTriggers))
                    continue;
                if (!collider.Meets(origin, unit, out double distance, out Vector3 normal) || !(distance <= nearest))
                    continue;
                nearest = distance;
                hitInfo = new RaycastHit
                {
                    collider = collider, distance = (float)distance, normal = normal, point = origin + unit * (float)distance,
                };
            }

            return hitInfo.collider != null;
        }
    }
}
