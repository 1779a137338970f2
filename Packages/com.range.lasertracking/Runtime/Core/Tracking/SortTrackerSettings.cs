using System;
using LaserTracking.Detection;

namespace LaserTracking.Tracking
{
    /// <summary>The three settings of SORT; the defaults are the published ones.</summary>
    public sealed class SortTrackerSettings
    {
        /// <summary>Frames for which a track lives on without a detection, 0…1,000,000.</summary>
        public int MaxAge { get; set; } = 1;

        /// <summary>Detections in unbroken order before a track is reported, 0…1,000,000; in the first frames of all it is reported at once.</summary>
        public int MinHits { get; set; } = 3;

        /// <summary>Least intersection over union of a detection and a predicted box, 0…1.</summary>
        public double IouThreshold { get; set; } = 0.3;

        /// <exception cref="ArgumentException">A value is outside its range or NaN; the message names it.</exception>
        public void Validate()
        {
            SettingCheck.InRange(nameof(MaxAge), MaxAge, 0, 1_000_000);
            SettingCheck.InRange(nameof(MinHits), MinHits, 0, 1_000_000);
            SettingCheck.InRange(nameof(IouThreshold), IouThreshold, 0, 1);
        }

        public SortTrackerSettings Clone() => (SortTrackerSettings)MemberwiseClone();
    }
}
