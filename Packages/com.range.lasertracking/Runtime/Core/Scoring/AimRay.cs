namespace LaserTracking.Scoring
{
    /// <summary>From where the ray through the dot on the screen is drawn into the scene.</summary>
    public enum AimRay
    {
        /// <summary>From the picture's viewpoint: a shot meets what the picture shows under the dot.</summary>
        Viewpoint = 0,

        /// <summary>
        /// The published rule: from the muzzle as camera 1 measured it; from the viewpoint when there is no muzzle. Meets what stands
        /// on the weapon's line, which is what the picture shows only for an eye behind the sights at the viewpoint.
        /// </summary>
        Muzzle = 1,
    }
}
