using LaserTracking.Geometry;

namespace LaserTracking.Scoring
{
    /// <summary>Nearest meeting of a ray with a collider. Scene space, metres.</summary>
    public struct RaycastHit
    {
        /// <summary>Index of the object in its scene or registry.</summary>
        public int ObjectIndex;

        public Vector3D PointM;
        public Vector3D Normal;
        public double DistanceM;

        /// <summary>
        /// Where the object stood: its position and rotation in the scene, without its scale. Carries the shot's uncertainty to the
        /// target's plane.
        /// </summary>
        public Pose ObjectPose;

        /// <summary>The point in the object's own axes and in metres (scale not undone): x right, y up in the target's plane.</summary>
        public Vector3D LocalPointM;
    }
}
