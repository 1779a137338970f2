namespace LaserTracking.Calibration
{
    /// <summary>Which coefficients of the lens a calibration determines; the others stay 0.</summary>
    public enum LensModel
    {
        /// <summary>k1, k2, p1, p2, k3: enough for most lenses.</summary>
        Brown5,

        /// <summary>k1, k2, p1, p2, k3 to k6: for wide lenses and many views.</summary>
        Rational8,

        /// <summary>k1, k2 only: when views are few.</summary>
        Radial2,
    }
}
