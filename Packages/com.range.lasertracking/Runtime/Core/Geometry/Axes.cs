namespace LaserTracking.Geometry
{
    /// <summary>
    /// Every conversion between the frames of reference, each written once.
    /// Camera: right-handed, x right, y down, z forward, mm. Screen: right-handed, origin at the picture's top-left corner, x right,
    /// y down, z into the picture (trainees stand at negative z), m. Scene: Unity's, left-handed, y up, m.
    /// </summary>
    public static class Axes
    {
        /// <summary>Metres in a millimetre.</summary>
        public const double MetresPerMillimetre = 0.001;

        public static Vector3D MillimetresToMetres(Vector3D mm) => mm * MetresPerMillimetre;

        public static Vector3D MetresToMillimetres(Vector3D m) => m * 1000;

        /// <summary>
        /// Screen space to the local space of the screen's surface in the scene: origin in the middle, x right, y up, z into the
        /// picture. Both in metres.
        /// </summary>
        public static Vector3D ScreenToSurface(Vector3D screenM, Vector2D screenSizeM) =>
            new Vector3D(screenM.X - screenSizeM.X / 2, screenSizeM.Y / 2 - screenM.Y, screenM.Z);

        /// <summary>The inverse of <see cref="ScreenToSurface"/>.</summary>
        public static Vector3D SurfaceToScreen(Vector3D surfaceM, Vector2D screenSizeM) =>
            new Vector3D(surfaceM.X + screenSizeM.X / 2, screenSizeM.Y / 2 - surfaceM.Y, surfaceM.Z);
    }
}
