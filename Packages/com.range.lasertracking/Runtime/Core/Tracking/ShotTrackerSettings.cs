using System;
using LaserTracking.Detection;

namespace LaserTracking.Tracking
{
    /// <summary>How dots become shots. Times in microseconds, lengths in pixels of a picture 640 wide (scaled to the real one).</summary>
    public sealed class ShotTrackerSettings
    {
        /// <summary>A dot continues a track when it lies within this of where that was or was going, px at 640, 1…640; what smears may go farther.</summary>
        public double LinkRadiusPx { get; set; } = 40;

        /// <summary>A track that shows no dot for longer is over, µs, 0…10 s. Two frames are allowed at any frame rate.</summary>
        public long MemoryUs { get; set; } = 90_000;

        /// <summary>Light that lasts longer is no flash but a laser held on, µs, 0…10 s.</summary>
        public long HeldAfterUs { get; set; } = 350_000;

        /// <summary>Light that lasted longer and is lost where things move may be covered by them, µs, 0…10 s.</summary>
        public long CoveredAfterUs { get; set; } = 150_000;

        /// <summary>A dot that has to wait for its proof is no shot of its own within this of one that began with it, px at 640, 0…640.</summary>
        public double HaloRadiusPx { get; set; } = 20;

        /// <summary>For how long a laser held on may be out of sight and come back as the same dot, µs, 0…60 s.</summary>
        public long HeldMemoryUs { get; set; } = 1_000_000;

        /// <summary>
        /// A dot that begins anew on a track after darkness for at least this long is a new shot (double tap), µs, 0…10 s. Measured
        /// from the last frame that showed the light; at least one dark frame must lie between.
        /// </summary>
        public long MinTapGapUs { get; set; } = 60_000;

        /// <summary>
        /// Half of that darkness will do when the track's own flash began at least this long ago, µs, 0…10 s: taps of long flashes leave
        /// little darkness. Fastest taps follow each other after 0.10 s; a frame's time less, because flashes begin between frames.
        /// </summary>
        public long MinTapPeriodUs { get; set; } = 80_000;

        /// <summary>Frames that a dot which is not conclusive may wait for its proof at any frame rate, 1…60.</summary>
        public int MaxWaitFrames { get; set; } = 5;

        /// <summary>For how long it may wait where that is more frames, µs, 0…1 s; as the detector's.</summary>
        public long MaxWaitUs { get; set; } = 335_000;

        /// <summary>
        /// A rejected candidate within this of a waiting dot, in the frame where it should have vanished, says that it did not vanish
        /// sharply, px at 640, 0…640.
        /// </summary>
        public double VanishRadiusPx { get; set; } = 5;

        /// <summary>
        /// How fast the dot of an aimed weapon moves without its shape showing it, px at 640 per second, root mean square along each axis,
        /// 0…10000: tremor, sway, a target followed. Widens the place of the light's begin.
        /// </summary>
        public double HandSpeedPxPerS { get; set; } = 11;

        /// <summary>Shutter and rolling shutter of the camera.</summary>
        public CameraTimingSettings Timing { get; set; } = new CameraTimingSettings();

        /// <exception cref="ArgumentException">A value is outside its range or NaN; the message names it.</exception>
        public void Validate()
        {
            SettingCheck.InRange(nameof(LinkRadiusPx), LinkRadiusPx, 1, 640);
            SettingCheck.InRange(nameof(MemoryUs), MemoryUs, 0, 10_000_000);
            SettingCheck.InRange(nameof(HeldAfterUs), HeldAfterUs, 0, 10_000_000);
            SettingCheck.InRange(nameof(CoveredAfterUs), CoveredAfterUs, 0, 10_000_000);
            SettingCheck.InRange(nameof(HaloRadiusPx), HaloRadiusPx, 0, 640);
            SettingCheck.InRange(nameof(HeldMemoryUs), HeldMemoryUs, 0, 60_000_000);
            SettingCheck.InRange(nameof(MinTapGapUs), MinTapGapUs, 0, 10_000_000);
            SettingCheck.InRange(nameof(MinTapPeriodUs), MinTapPeriodUs, 0, 10_000_000);
            SettingCheck.InRange(nameof(MaxWaitFrames), MaxWaitFrames, 1, 60);
            SettingCheck.InRange(nameof(MaxWaitUs), MaxWaitUs, 0, 1_000_000);
            SettingCheck.InRange(nameof(VanishRadiusPx), VanishRadiusPx, 0, 640);
            SettingCheck.InRange(nameof(HandSpeedPxPerS), HandSpeedPxPerS, 0, 10_000);
            Timing.Validate();
        }

        public ShotTrackerSettings Clone()
        {
            var copy = (ShotTrackerSettings)MemberwiseClone();
            copy.Timing = Timing.Clone();
            return copy;
        }
    }
}
