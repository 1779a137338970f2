// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityStandIn;

namespace UnityEngine
{
    /// <summary>Not convex: triangles, seen from their front only unless Physics.queriesHitBackfaces.</summary>
    public class MeshCollider : Collider
    {
        public Mesh sharedMesh { get; set; }

        /// <summary>Convex ones are not modelled; the flag is there to be asked for.</summary>
        public bool convex { get; set; }

        internal override bool Meets(Vector3 origin, Vector3 direction, out double distance, out Vector3 normal)
        {
            distance = double.PositiveInfinity;
            normal = default;
            if (sharedMesh == null)
                return false;
            Vector3 from = Pose.ToLocal(origin), along = Pose.ToLocalDirection(direction), scale = Pose.Scale;
            bool isMirrored = scale.x * scale.y * scale.z < 0;
            int[] corners = sharedMesh.triangles;
            for (int i = 0; i + 2 < corners.Length; i += 3)
            {
                Vector3 a = Vector3.Scale(sharedMesh.vertices[corners[i]], scale);
                Vector3 b = Vector3.Scale(sharedMesh.vertices[corners[i + (isMirrored ? 2 : 1)]], scale);
                Vector3 c = Vector3.Scale(sharedMesh.vertices[corners[i + (isMirrored ? 1 : 2)]], scale);
                if (Triangle.TryMeet(from, along, a, b, c, Physics.queriesHitBackfaces, out double t, out Vector3 facing) && t < distance)
                {
                    distance = t;
                    normal = Pose.ToWorldDirection(facing);
                }
            }

            return !double.IsInfinity(distance);
        }
    }
}
