using System;

namespace LaserTracking.Detection
{
    /// <summary>How the expected view of the projected picture is made and used. Checked when an <see cref="ExpectedView"/> is made.</summary>
    public sealed class PredictionSettings
    {
        /// <summary>Shortest delay from drawing to seeing that is searched, µs, -2…2 s: below zero where the clocks differ.</summary>
        public long MinDelayUs { get; set; } = -20_000;

        /// <summary>Longest one, µs, up to 2 s more than the shortest.</summary>
        public long MaxDelayUs { get; set; } = 300_000;

        /// <summary>How long the camera exposes, µs, 0…200 000. One picture of a 60 Hz projector if it is not known.</summary>
        public long ExposureUs { get; set; } = 16_667;

        /// <summary>What the expected view always allows for the delay to either side, µs, 0…100 000.</summary>
        public long DelaySlackUs { get; set; } = 4_000;

        /// <summary>Share by which the expected view is raised, 0…1.</summary>
        public double GainSlack { get; set; } = 0.03;

        /// <summary>Levels by which it is raised besides, 0…100.</summary>
        public int LevelSlack { get; set; } = 4;

        /// <summary>Levels above the expected view from which it is light from elsewhere, 1…255.</summary>
        public int MinExcess { get; set; } = 25;

        /// <summary>The same in standard deviations of the picture's temporal noise, 0…100.</summary>
        public double MinExcessSigmas { get; set; } = 6;

        /// <summary>Correlation of what was drawn with what is seen from which the delay counts as known, 0…1.</summary>
        public double MinCorrelation { get; set; } = 0.6;

        /// <summary>Share of the screen that may exceed the expected view before it is not relied on any more, 0…1.</summary>
        public double MaxUnexplainedShare { get; set; } = 0.04;

        /// <exception cref="ArgumentException">A value is outside its range or NaN; the message names it.</exception>
        public void Validate()
        {
            SettingCheck.InRange(nameof(MinDelayUs), MinDelayUs, -2_000_000, 2_000_000);
            SettingCheck.InRange(nameof(MaxDelayUs), MaxDelayUs, MinDelayUs + 40_000, MinDelayUs + 2_000_000);
            SettingCheck.InRange(nameof(ExposureUs), ExposureUs, 0, 200_000);
            SettingCheck.InRange(nameof(DelaySlackUs), DelaySlackUs, 0, 100_000);
            SettingCheck.InRange(nameof(GainSlack), GainSlack, 0, 1);
            SettingCheck.InRange(nameof(LevelSlack), LevelSlack, 0, 100);
            SettingCheck.InRange(nameof(MinExcess), MinExcess, 1, 255);
            SettingCheck.InRange(nameof(MinExcessSigmas), MinExcessSigmas, 0, 100);
            SettingCheck.InRange(nameof(MinCorrelation), MinCorrelation, 0, 1);
            SettingCheck.InRange(nameof(MaxUnexplainedShare), MaxUnexplainedShare, 0, 1);
        }

        public PredictionSettings Clone() => (PredictionSettings)MemberwiseClone();
    }
}
