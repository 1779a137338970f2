namespace LaserTracking.Simulation
{
    /// <summary>
    /// Draws shots for all shooters from the scenario's seed. Pulses are spread evenly in the logarithm of their length, so that
    /// short flashes are as frequent as in recorded sessions.
    /// </summary>
    public sealed class ShotGeneratorSettings
    {
        /// <summary>Mean number of shots a minute of one shooter, follow-ups included; 0 = none.</summary>
        public double ShotsPerMinute { get; set; }

        /// <summary>Shortest pulse, ms.</summary>
        public double PulseMinMs { get; set; } = 5;

        /// <summary>Longest pulse, ms.</summary>
        public double PulseMaxMs { get; set; } = 300;

        /// <summary>Share of shots that are followed by a second at the same spot.</summary>
        public double DoubleTapShare { get; set; } = 0.2;

        /// <summary>Shortest time between the two shots of a double tap, s.</summary>
        public double SplitMinS { get; set; } = 0.1;

        /// <summary>Longest time between the two shots of a double tap, s.</summary>
        public double SplitMaxS { get; set; } = 0.4;

        /// <summary>Share of shots at the very moment of another shooter's.</summary>
        public double SimultaneousShare { get; set; } = 0.05;

        /// <summary>Share of shots fired while the weapon swings; the dot then moves at 0.5 to 4 m/s.</summary>
        public double SweepShare { get; set; } = 0.1;

        /// <summary>Share of shots that are held on for <see cref="HeldS"/>.</summary>
        public double HeldShare { get; set; }

        public double HeldS { get; set; } = 2;

        /// <summary>Share of shots at a random point of the screen in place of a target.</summary>
        public double AnywhereShare { get; set; } = 0.3;

        internal void Visit(ScenarioVisitor v)
        {
            ShotsPerMinute = v.Number("shots_per_minute", ShotsPerMinute, 0, 600);
            PulseMinMs = v.Number("pulse_min_ms", PulseMinMs, 0.1, 10000);
            PulseMaxMs = v.Number("pulse_max_ms", PulseMaxMs, 0.1, 10000);
            DoubleTapShare = v.Number("double_tap_share", DoubleTapShare, 0, 1);
            SplitMinS = v.Number("split_min_s", SplitMinS, 0.01, 10);
            SplitMaxS = v.Number("split_max_s", SplitMaxS, 0.01, 10);
            SimultaneousShare = v.Number("simultaneous_share", SimultaneousShare, 0, 1);
            SweepShare = v.Number("sweep_share", SweepShare, 0, 1);
            HeldShare = v.Number("held_share", HeldShare, 0, 1);
            HeldS = v.Number("held_s", HeldS, 0.3, 3600);
            AnywhereShare = v.Number("anywhere_share", AnywhereShare, 0, 1);
            if (PulseMaxMs < PulseMinMs)
                v.Refuse("pulse_max_ms", "is below pulse_min_ms", "give at least pulse_min_ms");
            if (SplitMaxS < SplitMinS)
                v.Refuse("split_max_s", "is below split_min_s", "give at least split_min_s");
        }
    }
}
