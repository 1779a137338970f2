using System;
using LaserTracking.Detection;

namespace LaserTracking.Tracking
{
    /// <summary>How camera 0 gathers light in time. What is not known stays at its default and widens the uncertainty of time and place.</summary>
    public sealed class CameraTimingSettings
    {
        /// <summary>Shutter: how long each row gathers light, µs, 0…1 s; 0: unknown.</summary>
        public double ExposureUs { get; set; }

        /// <summary>
        /// Rolling shutter: delay from one row to the next, µs, -1000…1000, negative when the picture is upside down; 0: all rows at
        /// once. Frame times are those of the middle row.
        /// </summary>
        public double RowUs { get; set; }

        /// <exception cref="ArgumentException">A value is outside its range or NaN; the message names it.</exception>
        public void Validate()
        {
            SettingCheck.InRange(nameof(ExposureUs), ExposureUs, 0, 1_000_000);
            SettingCheck.InRange(nameof(RowUs), RowUs, -1000, 1000);
        }

        public CameraTimingSettings Clone() => (CameraTimingSettings)MemberwiseClone();
    }
}
