using LaserTracking.Detection;

namespace LaserTracking.Simulation
{
    /// <summary>The light of one training weapon.</summary>
    public sealed class LaserSettings
    {
        /// <summary>Green (532 nm), Red (650 nm) or Infrared (850 nm, mostly stopped by a colour camera's filter).</summary>
        public LaserColor Color { get; set; } = LaserColor.Green;

        /// <summary>Milliwatts while the light is on.</summary>
        public double PowerMw { get; set; } = 2;

        /// <summary>Radius on the screen at which the light has fallen to 1/e², mm.</summary>
        public double DotRadiusMm { get; set; } = 3;

        /// <summary>Share of the light that glare and the wall spread into the halo.</summary>
        public double HaloShare { get; set; } = 0.12;

        /// <summary>Width of the halo in widths of the core.</summary>
        public double HaloScale { get; set; } = 4;

        /// <summary>Standard deviation of the speckle grain relative to the light.</summary>
        public double SpeckleContrast { get; set; } = 0.25;

        internal void Visit(ScenarioVisitor v)
        {
            Color = v.Choice("color", Color);
            PowerMw = v.Number("power_mw", PowerMw, 0, 1000);
            DotRadiusMm = v.Number("dot_radius_mm", DotRadiusMm, 0.1, 100);
            HaloShare = v.Number("halo_share", HaloShare, 0, 0.9);
            HaloScale = v.Number("halo_scale", HaloScale, 1, 30);
            SpeckleContrast = v.Number("speckle_contrast", SpeckleContrast, 0, 1);
            if (Color == LaserColor.Unknown)
                v.Refuse("color", "is unknown", "give one of green, red, infrared");
        }
    }
}
