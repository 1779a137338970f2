using System;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Limits of the dual detector. Lengths in the infrared picture are its own pixels; lengths in the colour picture are pixels of
    /// one 1920 wide, scaled to the real width, areas with the square. Checked when a <see cref="DualShotDetector"/> is made from it.
    /// </summary>
    public sealed class DualDetectorSettings
    {
        /// <summary>Least height of an infrared spot over its surroundings, counts, 1…65535.</summary>
        public double MinInfraredRise { get; set; } = 20;

        /// <summary>Least light of its brightest 3×3 pixels in standard deviations of what noise makes of as many, 0…100.</summary>
        public double MinInfraredSigmas { get; set; } = 7;

        /// <summary>Least height in standard deviations of the brightness around it, the wall's texture included, 0…100.</summary>
        public double MinInfraredContrast { get; set; } = 3;

        /// <summary>The same as a share of the brightness around it, 0…10: a wall's own texture stays below.</summary>
        public double MinInfraredShare { get; set; } = 0.12;

        /// <summary>Pixels among the brightest and its neighbours that must reach a fifth of the height, 1…9: lenses spread light, defects do not.</summary>
        public int MinInfraredFootPx { get; set; } = 3;

        /// <summary>Largest area at half height, infrared px, 1…2000.</summary>
        public int MaxInfraredAreaPx { get; set; } = 200;

        /// <summary>Within this lights of both pictures may be one, colour px, 1…200; a mapping that is sure narrows the search for a spot's colour.</summary>
        public double MatchRadiusPx { get; set; } = 20;

        /// <summary>Least height of visible light over its surroundings in its strongest channel, levels, 1…255.</summary>
        public double MinColorRise { get; set; } = 24;

        /// <summary>The same in standard deviations of the picture around it, 0…100.</summary>
        public double MinColorSigmas { get; set; } = 6;

        /// <summary>Largest area of visible light at half height, colour px, 1…4000.</summary>
        public double MaxColorAreaPx { get; set; } = 1200;

        /// <summary>Largest length through width of a spot in either picture, 1…100.</summary>
        public double MaxElongation { get; set; } = 6;

        /// <summary>Largest share of the ring around a spot that reaches half its height, 0…1.</summary>
        public double MaxRingShare { get; set; } = 0.12;

        /// <summary>
        /// Least share of a spot's colourfulness by which green exceeds both others, 0…1. As a hue: 120° ± 60°·(1 − this).
        /// </summary>
        public double MinGreenShare { get; set; } = 0.4;

        /// <summary>Least colourfulness (largest minus smallest channel) through brightness of what is not white, 0…1.</summary>
        public double MinColorfulness { get; set; } = 0.1;

        /// <summary>Light fainter than this share of the headroom may be the little that a colour camera sees of infrared, 0…1.</summary>
        public double MaxInfraredLeak { get; set; } = 0.25;

        /// <summary>Least green excess of a resting dot that only the colour picture shows, over its surroundings, levels, 1…255.</summary>
        public int MinGreenExcess { get; set; } = 25;

        /// <summary>Least height of such a dot as a share of the headroom, 0…1: projected green things seldom come near full brightness.</summary>
        public double MinRestingRise { get; set; } = 0.6;

        /// <summary>Largest length through width of such a dot, 1…100: what lies still is not smeared.</summary>
        public double MaxRestingElongation { get; set; } = 2;

        /// <summary>Frames in a row in which such a dot must lie in one place, 1…100.</summary>
        public int RestFrames { get; set; } = 3;

        /// <summary>Resting dots are looked for in one of so many parts of the colour picture a frame, 1…64; in all at the start.</summary>
        public int PatrolParts { get; set; } = 8;

        /// <summary>Spots that one frame may have examined in each picture, 1…1024: bounds the time.</summary>
        public int MaxCandidates { get; set; } = 64;

        /// <summary>Least confidence of a dot that the infrared or the resting search found, 0…1.</summary>
        public double MinConfidence { get; set; } = 0.3;

        /// <summary>False: only what infrared shows can be a dot, as in the published module; colour is read around it and nowhere else.</summary>
        public bool SearchesColor { get; set; } = true;

        /// <summary>Explicit vector instructions where the processor has them; results are the same without.</summary>
        public bool UseVectors { get; set; } = true;

        /// <exception cref="ArgumentException">A value is outside its range or NaN; the message names it.</exception>
        public void Validate()
        {
            SettingCheck.InRange(nameof(MinInfraredRise), MinInfraredRise, 1, 65535);
            SettingCheck.InRange(nameof(MinInfraredSigmas), MinInfraredSigmas, 0, 100);
            SettingCheck.InRange(nameof(MinInfraredContrast), MinInfraredContrast, 0, 100);
            SettingCheck.InRange(nameof(MinInfraredShare), MinInfraredShare, 0, 10);
            SettingCheck.InRange(nameof(MinInfraredFootPx), MinInfraredFootPx, 1, 9);
            SettingCheck.InRange(nameof(MaxInfraredAreaPx), MaxInfraredAreaPx, 1, 2000);
            SettingCheck.InRange(nameof(MatchRadiusPx), MatchRadiusPx, 1, 200);
            SettingCheck.InRange(nameof(MinColorRise), MinColorRise, 1, 255);
            SettingCheck.InRange(nameof(MinColorSigmas), MinColorSigmas, 0, 100);
            SettingCheck.InRange(nameof(MaxColorAreaPx), MaxColorAreaPx, 1, 4000);
            SettingCheck.InRange(nameof(MaxElongation), MaxElongation, 1, 100);
            SettingCheck.InRange(nameof(MaxRingShare), MaxRingShare, 0, 1);
            SettingCheck.InRange(nameof(MinGreenShare), MinGreenShare, 0, 1);
            SettingCheck.InRange(nameof(MinColorfulness), MinColorfulness, 0, 1);
            SettingCheck.InRange(nameof(MaxInfraredLeak), MaxInfraredLeak, 0, 1);
            SettingCheck.InRange(nameof(MinGreenExcess), MinGreenExcess, 1, 255);
            SettingCheck.InRange(nameof(MinRestingRise), MinRestingRise, 0, 1);
            SettingCheck.InRange(nameof(MaxRestingElongation), MaxRestingElongation, 1, 100);
            SettingCheck.InRange(nameof(RestFrames), RestFrames, 1, 100);
            SettingCheck.InRange(nameof(PatrolParts), PatrolParts, 1, 64);
            SettingCheck.InRange(nameof(MaxCandidates), MaxCandidates, 1, 1024);
            SettingCheck.InRange(nameof(MinConfidence), MinConfidence, 0, 1);
        }

        public DualDetectorSettings Clone() => (DualDetectorSettings)MemberwiseClone();
    }
}
