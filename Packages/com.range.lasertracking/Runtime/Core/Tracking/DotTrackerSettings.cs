using System;
using LaserTracking.Detection;

namespace LaserTracking.Tracking
{
    /// <summary>How the dots of lasers move and how long they are remembered. Lengths in pixels of a picture 640 wide, times in microseconds.</summary>
    public sealed class DotTrackerSettings
    {
        /// <summary>Sights before a dot gets a number, 1…60. With 1 it gets one at once; with 2 light that is seen only once gets none.</summary>
        public int MinHits { get; set; } = 2;

        /// <summary>For how long a dot out of sight can come back with its number, µs, 0…60 s: 30 frames at 30 a second.</summary>
        public long MemoryUs { get; set; } = 1_000_000;

        /// <summary>
        /// A dot missed for no longer is continued frame by frame, µs, 0…10 s; after that only by what has proven to be a dot of its own.
        /// Three frames at 30 a second, so that stray light cannot pull a hidden dot away.
        /// </summary>
        public long LinkUs { get; set; } = 110_000;

        /// <summary>No dot goes farther from its predicted place between two sights, px at 640, 1…640.</summary>
        public double LinkRadiusPx { get; set; } = 40;

        /// <summary>
        /// A dot that fits no way is taken for a jump (a jerk of the hand, recoil) of one that was lost just now within this, px at 640,
        /// 0…640; 0: no jumps. Right where hardly a dot is missed and stray light is rare; otherwise jumps cost more numbers than they keep.
        /// </summary>
        public double JumpRadiusPx { get; set; }

        /// <summary>
        /// Standard deviation of a dot's place about its smooth way along each axis, px at 640, 0.01…100: tremor of the hand (4–12 Hz, too
        /// fast for the frame rate to follow) and error of measurement.
        /// </summary>
        public double TremorPx { get; set; } = 1;

        /// <summary>Standard deviation of a dot's velocity along each axis at first sight, px at 640 per second, 1…100,000.</summary>
        public double FirstSpeedPxPerS { get; set; } = 250;

        /// <summary>By how much the velocity wanders within a second, standard deviation along each axis, px at 640 per second, 1…100,000.</summary>
        public double SpeedWanderPxPerS { get; set; } = 140;

        /// <exception cref="ArgumentException">A value is outside its range or NaN; the message names it.</exception>
        public void Validate()
        {
            SettingCheck.InRange(nameof(MinHits), MinHits, 1, 60);
            SettingCheck.InRange(nameof(MemoryUs), MemoryUs, 0, 60_000_000);
            SettingCheck.InRange(nameof(LinkUs), LinkUs, 0, 10_000_000);
            SettingCheck.InRange(nameof(LinkRadiusPx), LinkRadiusPx, 1, 640);
            SettingCheck.InRange(nameof(JumpRadiusPx), JumpRadiusPx, 0, 640);
            SettingCheck.InRange(nameof(TremorPx), TremorPx, 0.01, 100);
            SettingCheck.InRange(nameof(FirstSpeedPxPerS), FirstSpeedPxPerS, 1, 100_000);
            SettingCheck.InRange(nameof(SpeedWanderPxPerS), SpeedWanderPxPerS, 1, 100_000);
        }

        public DotTrackerSettings Clone() => (DotTrackerSettings)MemberwiseClone();
    }
}
