using System;

namespace LaserTracking.Detection
{
    /// <summary>
    /// What the advisor takes for given: the camera's exposure and tone, the laser asked about. Checked when a
    /// <see cref="DetectionAdvisor"/> is made from it.
    /// </summary>
    public sealed class AdvisorSettings
    {
        /// <summary>Columns of the map, 1…64.</summary>
        public int Columns { get; set; } = 8;

        /// <summary>Rows of the map, 1…64.</summary>
        public int Rows { get; set; } = 5;

        /// <summary>Exposure, µs; 0: not known, half a frame interval is assumed.</summary>
        public double ExposureUs { get; set; }

        /// <summary>Display value = linear light^(1/gamma), 1…4.</summary>
        public double Gamma { get; set; } = 2.2;

        /// <summary>Point spread of the lens, px (one standard deviation), 0…10.</summary>
        public double BlurPx { get; set; } = 0.8;

        /// <summary>The laser's colour; infrared is mostly stopped by a colour camera's filter.</summary>
        public LaserColor Color { get; set; } = LaserColor.Green;

        /// <summary>The laser's power, mW, 0.0001…1000: trainers for indoor use stay below 1.</summary>
        public double PowerMw { get; set; } = 1;

        /// <summary>Radius of the dot on the screen at which its light has fallen to 1/e², mm, 0.1…100.</summary>
        public double DotRadiusMm { get; set; } = 3;

        /// <summary>Share of the light in the halo, 0…0.9.</summary>
        public double HaloShare { get; set; } = 0.12;

        /// <summary>Width of the halo in widths of the core, 1…30.</summary>
        public double HaloScale { get; set; } = 4;

        /// <summary>Width of what the camera sees, m, where no calibration says it, 0.1…100.</summary>
        public double PictureWidthM { get; set; } = 3;

        /// <summary>Light of projected white on the screen, W/m², 0.001…1000: 2 is a projector of 1000 lm on 2 m².</summary>
        public double WhiteWPerM2 { get; set; } = 2;

        /// <summary>Linear light of projected white in the picture, 1 = full brightness, 0…100; 0: that of the brightest parts seen.</summary>
        public double WhiteLight { get; set; }

        /// <summary>Share of flashes that must be caught for "is caught", 0.5…0.999.</summary>
        public double CaughtShare { get; set; } = 0.9;

        /// <exception cref="ArgumentException">A value is outside its range or NaN; the message names it.</exception>
        public void Validate()
        {
            SettingCheck.InRange(nameof(Columns), Columns, 1, 64);
            SettingCheck.InRange(nameof(Rows), Rows, 1, 64);
            SettingCheck.InRange(nameof(ExposureUs), ExposureUs, 0, 1e7);
            SettingCheck.InRange(nameof(Gamma), Gamma, 1, 4);
            SettingCheck.InRange(nameof(BlurPx), BlurPx, 0, 10);
            SettingCheck.InRange(nameof(PowerMw), PowerMw, 0.0001, 1000);
            SettingCheck.InRange(nameof(DotRadiusMm), DotRadiusMm, 0.1, 100);
            SettingCheck.InRange(nameof(HaloShare), HaloShare, 0, 0.9);
            SettingCheck.InRange(nameof(HaloScale), HaloScale, 1, 30);
            SettingCheck.InRange(nameof(PictureWidthM), PictureWidthM, 0.1, 100);
            SettingCheck.InRange(nameof(WhiteWPerM2), WhiteWPerM2, 0.001, 1000);
            SettingCheck.InRange(nameof(WhiteLight), WhiteLight, 0, 100);
            SettingCheck.InRange(nameof(CaughtShare), CaughtShare, 0.5, 0.999);
            if (Color == LaserColor.Unknown)
                throw new ArgumentException("Color must be a laser's");
        }

        public AdvisorSettings Clone() => (AdvisorSettings)MemberwiseClone();
    }
}
