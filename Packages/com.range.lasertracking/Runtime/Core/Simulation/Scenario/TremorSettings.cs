namespace LaserTracking.Simulation
{
    /// <summary>
    /// Physiological tremor and slow sway of the aim. Published: mode 7 Hz, between people sd 1.3 Hz, within one person the frequency
    /// wanders by 0.7 Hz; wrist rotation about 0.5 mrad, population 0.08 to 1.9.
    /// </summary>
    public sealed class TremorSettings
    {
        /// <summary>4 to 12 Hz; 0: drawn from the population with the scenario's seed.</summary>
        public double FrequencyHz { get; set; }

        /// <summary>Standard deviation of the frequency within the person, Hz.</summary>
        public double WanderHz { get; set; } = 0.7;

        /// <summary>Root mean square angle along each axis, mrad; negative: drawn from the population.</summary>
        public double AmplitudeMrad { get; set; } = -1;

        /// <summary>Root mean square angle of the slow sway (0.3 to 1 Hz) along each axis, mrad.</summary>
        public double SwayMrad { get; set; } = 1.5;

        internal void Visit(ScenarioVisitor v)
        {
            FrequencyHz = v.Number("frequency_hz", FrequencyHz, 0, 12);
            WanderHz = v.Number("wander_hz", WanderHz, 0, 3);
            AmplitudeMrad = v.Number("amplitude_mrad", AmplitudeMrad, -1, 20);
            SwayMrad = v.Number("sway_mrad", SwayMrad, 0, 50);
            if (FrequencyHz > 0 && FrequencyHz < 4)
                v.Refuse("frequency_hz", "is below tremor", "give 4 to 12, or 0 to have it drawn");
        }
    }
}
