namespace LaserTracking.Geometry
{
    /// <summary>What a point that the fit had not seen said of a calibration of the screen.</summary>
    public readonly struct ScreenResidual
    {
        /// <param name="screenM">Where the point is on the screen.</param>
        /// <param name="offMm">Where the calibration puts it, less that.</param>
        public ScreenResidual(Vector2D screenM, Vector2D offMm)
        {
            ScreenM = screenM;
            OffMm = offMm;
        }

        public Vector2D ScreenM { get; }

        public Vector2D OffMm { get; }
    }
}
