namespace LaserTracking.Geometry
{
    /// <summary>The points X with Normal · X = Distance; the normal is a unit vector. Units are those of the frame of reference.</summary>
    public readonly struct Plane3D
    {
        public readonly Vector3D Normal;
        public readonly double Distance;

        /// <param name="normal">Any length but zero.</param>
        /// <param name="point">A point of the plane.</param>
        public Plane3D(Vector3D normal, Vector3D point)
        {
            Normal = normal.Normalized;
            Distance = Vector3D.Dot(Normal, point);
        }

        /// <summary>Above zero on the side that the normal points to.</summary>
        public double SignedDistance(Vector3D point) => Vector3D.Dot(Normal, point) - Distance;

        /// <summary>Where a half line meets the plane; false when it runs along or away from it.</summary>
        public bool TryIntersect(Ray3D ray, out Vector3D point)
        {
            double length = -SignedDistance(ray.Origin) / Vector3D.Dot(Normal, ray.Direction);
            point = ray.At(length);
            return length >= 0 && point.IsFinite;
        }
    }
}
