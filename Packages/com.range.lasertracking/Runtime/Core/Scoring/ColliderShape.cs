namespace LaserTracking.Scoring
{
    /// <summary>Solids that a ray can meet, with the meaning of Unity's colliders of the same name.</summary>
    public enum ColliderShape
    {
        Box = 0,
        Sphere = 1,
        Capsule = 2,

        /// <summary>Unity's quad mesh: 1×1 in the plane z = 0, hit only from its front, the side of negative z.</summary>
        Quad = 3,
    }
}
