namespace LaserTracking.Simulation
{
    /// <summary>
    /// The infrared sensor beside camera 0, exposed with it: 16-bit counts of 850 nm light. Defaults: passive infrared of an Azure
    /// Kinect, about a tenth of what its own illumination brings.
    /// </summary>
    public sealed class InfraredCameraSettings
    {
        /// <summary>Without it the frames hold colour alone.</summary>
        public bool Enabled { get; set; }

        /// <summary>Pixels.</summary>
        public int Width { get; set; } = 1024;

        /// <summary>Pixels.</summary>
        public int Height { get; set; } = 1024;

        /// <summary>Mean brightness of the wall in passive infrared, counts.</summary>
        public double AmbientCounts { get; set; } = 80;

        /// <summary>Swing of the wall's reflectance over decimetres as a share of its mean.</summary>
        public double WallContrast { get; set; } = 0.15;

        /// <summary>Noise in the dark, sd in counts.</summary>
        public double ReadNoiseCounts { get; set; } = 3;

        /// <summary>Variance in counts² that each count of light adds.</summary>
        public double ShotNoise { get; set; } = 0.3;

        /// <summary>Light of a 1 mW emitter that shines for the whole exposure, counts summed over its pixels.</summary>
        public double EmitterCounts { get; set; } = 4000;

        /// <summary>
        /// The camera's own illumination is on: the wall is ten times as bright, and a tenth of steady emitters is left, since such
        /// cameras subtract what does not follow their modulation.
        /// </summary>
        public bool Active { get; set; }

        /// <summary>Standard deviation of the lens's point spread, px.</summary>
        public double BlurPx { get; set; } = 0.6;

        /// <summary>To the left of the colour camera, mm.</summary>
        public double BaselineMm { get; set; } = 32;

        /// <summary>Horizontal field of view, degrees; 0: as much as shows the whole screen with a small margin.</summary>
        public double FieldOfViewDeg { get; set; }

        internal void Visit(ScenarioVisitor v)
        {
            Enabled = v.Flag("enabled", Enabled);
            Width = v.Integer("width", Width, 16, 4096);
            Height = v.Integer("height", Height, 16, 4096);
            AmbientCounts = v.Number("ambient_counts", AmbientCounts, 0, 5000);
            WallContrast = v.Number("wall_contrast", WallContrast, 0, 1);
            ReadNoiseCounts = v.Number("read_noise_counts", ReadNoiseCounts, 0, 500);
            ShotNoise = v.Number("shot_noise", ShotNoise, 0, 100);
            EmitterCounts = v.Number("emitter_counts", EmitterCounts, 0, 1e7);
            Active = v.Flag("active", Active);
            BlurPx = v.Number("blur_px", BlurPx, 0, 6);
            BaselineMm = v.Number("baseline_mm", BaselineMm, -1000, 1000);
            FieldOfViewDeg = v.Number("field_of_view_deg", FieldOfViewDeg, 0, 150);
        }
    }
}
