namespace LaserTracking.Geometry
{
    /// <summary>How two measurements of the screen's plane agree, along the camera's rays through the screen's corners and middle.</summary>
    public readonly struct ScreenPlaneAgreement
    {
        /// <summary>Between the normals, radians.</summary>
        public readonly double AngleRad;

        /// <summary>How much farther the other plane lies at the screen's middle, mm along the ray.</summary>
        public readonly double MiddleMm;

        /// <summary>Largest distance at a corner, mm along the ray.</summary>
        public readonly double WorstCornerMm;

        /// <summary>The screen's size, m, if the other plane is right.</summary>
        public readonly Vector2D OtherSizeM;

        public ScreenPlaneAgreement(double angleRad, double middleMm, double worstCornerMm, Vector2D otherSizeM)
        {
            AngleRad = angleRad;
            MiddleMm = middleMm;
            WorstCornerMm = worstCornerMm;
            OtherSizeM = otherSizeM;
        }
    }
}
