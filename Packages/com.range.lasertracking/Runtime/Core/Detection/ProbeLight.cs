namespace LaserTracking.Detection
{
    /// <summary>A dot of light that is not there: what a laser would add to the picture.</summary>
    internal struct ProbeLight
    {
        /// <summary>Centre, px of the full picture.</summary>
        public Geometry.Vector2D PositionPx;

        /// <summary>Linear light at the centre by channel; 1 = full brightness.</summary>
        public float Blue;
        public float Green;
        public float Red;

        /// <summary>Standard deviation of the core, px of the full picture.</summary>
        public double SigmaPx;

        /// <summary>Share of the light that lies in the halo, and its width in widths of the core (Moffat profile, exponent 2).</summary>
        public double HaloShare;
        public double HaloScale;
    }
}
