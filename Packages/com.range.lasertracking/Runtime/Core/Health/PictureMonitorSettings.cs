using System;
using LaserTracking.Detection;

namespace LaserTracking.Health
{
    /// <summary>
    /// From when on the picture itself is worth a word. Levels are 0…255 of the raw picture, shares 0…1. Checked when a
    /// <see cref="PictureMonitor"/> is made from it.
    /// </summary>
    public sealed class PictureMonitorSettings
    {
        /// <summary>Display value = linear light^(1/gamma), 1…4: how brightness follows exposure. Most cameras lie near 2.2.</summary>
        public double Gamma { get; set; } = 2.2;

        /// <summary>Exposure of the camera, µs; 0: not known, advice is then given as a factor.</summary>
        public double ExposureUs { get; set; }

        /// <summary>Brightness at which the projected picture's brightest parts leave a dot alone in clipping, levels, 16…255.</summary>
        public double WantedLevel { get; set; } = 140;

        /// <summary>Share of the screen without room for an ordinary dot that counts as over-exposed.</summary>
        public double SaturatedShareLimit { get; set; } = 0.05;

        /// <summary>Brightness of the brightest parts below which the picture counts as under-exposed, levels, 0…255.</summary>
        public double DarkLevel { get; set; } = 24;

        /// <summary>Least swing (half of peak to peak) of a flicker, levels, 0.1…255: half of what a candidate must rise at least.</summary>
        public double FlickerLevels { get; set; } = 1.5;

        /// <summary>Least change of the whole picture's brightness within a second, share of the level.</summary>
        public double ExposureChange { get; set; } = 0.04;

        /// <summary>Least displacement of a bumped camera's picture, px of a picture 640 wide, 0.2…20.</summary>
        public double ShiftPx { get; set; } = 0.7;

        /// <summary>How long not a pixel may change, seconds, 0.1…60.</summary>
        public double FrozenS { get; set; } = 1;

        /// <exception cref="ArgumentException">A value is outside its range or NaN; the message names it.</exception>
        public void Validate()
        {
            SettingCheck.InRange(nameof(Gamma), Gamma, 1, 4);
            SettingCheck.InRange(nameof(ExposureUs), ExposureUs, 0, 1e7);
            SettingCheck.InRange(nameof(WantedLevel), WantedLevel, 16, 255);
            SettingCheck.InRange(nameof(SaturatedShareLimit), SaturatedShareLimit, 0, 1);
            SettingCheck.InRange(nameof(DarkLevel), DarkLevel, 0, 255);
            SettingCheck.InRange(nameof(FlickerLevels), FlickerLevels, 0.1, 255);
            SettingCheck.InRange(nameof(ExposureChange), ExposureChange, 0.005, 1);
            SettingCheck.InRange(nameof(ShiftPx), ShiftPx, 0.2, 20);
            SettingCheck.InRange(nameof(FrozenS), FrozenS, 0.1, 60);
        }

        public PictureMonitorSettings Clone() => (PictureMonitorSettings)MemberwiseClone();
    }
}
