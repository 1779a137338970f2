namespace LaserTracking.Geometry
{
    /// <summary>A half line. The direction is a unit vector.</summary>
    public readonly struct Ray3D
    {
        public readonly Vector3D Origin;
        public readonly Vector3D Direction;

        public Ray3D(Vector3D origin, Vector3D direction)
        {
            Origin = origin;
            Direction = direction.Normalized;
        }

        public Vector3D At(double distance) => Origin + Direction * distance;
    }
}
