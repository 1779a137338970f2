namespace LaserTracking.Detection
{
    /// <summary>The published confidence's four summands: peak 0…0.4, contrast 0…0.3, nearness to the centre 0…0.2, stability 0…0.1.</summary>
    public readonly struct ConfidenceFactors
    {
        public ConfidenceFactors(double peak, double contrast, double center, double stability)
        {
            Peak = peak;
            Contrast = contrast;
            Center = center;
            Stability = stability;
        }

        public double Peak { get; }

        public double Contrast { get; }

        public double Center { get; }

        public double Stability { get; }

        /// <summary>The confidence, 0…1.</summary>
        public double Sum => Peak + Contrast + Center + Stability;
    }
}
