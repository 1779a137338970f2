using LaserTracking.Geometry;
using UnityEngine;
using Pose = LaserTracking.Geometry.Pose;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Core's doubles to and from Unity's floats: the only place where they meet. Scene space is Unity's own (left-handed, y up,
    /// metres), so that nothing is turned or mirrored here; see <see cref="Axes"/> for what is.
    /// </summary>
    public static class UnityConversions
    {
        public static Vector2 ToUnity(this Vector2D v) => new Vector2((float)v.X, (float)v.Y);

        public static Vector3 ToUnity(this Vector3D v) => new Vector3((float)v.X, (float)v.Y, (float)v.Z);

        public static Quaternion ToUnity(this Rotation3D r) => new Quaternion((float)r.X, (float)r.Y, (float)r.Z, (float)r.W);

        public static Vector2D ToCore(this Vector2 v) => new Vector2D(v.x, v.y);

        public static Vector3D ToCore(this Vector3 v) => new Vector3D(v.x, v.y, v.z);

        public static Rotation3D ToCore(this Quaternion q) => new Rotation3D(q.x, q.y, q.z, q.w);

        /// <summary>Where the transform stands in the world. Its scale is left out: lengths stay metres.</summary>
        public static Pose WorldPose(this Transform transform) => new Pose(transform.position.ToCore(), transform.rotation.ToCore());
    }
}
