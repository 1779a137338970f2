using System;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Limits of the default detector. Lengths are pixels of a picture 640 wide and areas their squares, both scaled to the real
    /// size; rises are shares of the headroom (the room left between a pixel's own past and full brightness) unless they say levels.
    /// Checked when a <see cref="ShotDetector"/> is made from it.
    /// </summary>
    public sealed class ShotDetectorSettings
    {
        /// <summary>Wider frames are searched at half size (2×2 maximum) and measured at full size, px, 1…16384.</summary>
        public int FullSizeMaxWidthPx { get; set; } = 1100;

        /// <summary>Levels a frame by which the remembered brightness of a pixel fades, 1…64.</summary>
        public int EnvelopeDecay { get; set; } = 6;

        /// <summary>Temporal noise from which the picture is smoothed before the search, levels (one standard deviation), 0…255.</summary>
        public double SmoothingNoise { get; set; } = 2.5;

        /// <summary>Least rise of a candidate, levels, 1…255.</summary>
        public double MinRiseLevels { get; set; } = 6;

        /// <summary>Least rise of a candidate in standard deviations of the picture's temporal noise, 0…100.</summary>
        public double MinRiseSigmas { get; set; } = 6;

        /// <summary>Least rise of a candidate, share of the headroom 0…1.</summary>
        public double MinRise { get; set; } = 0.12;

        /// <summary>Least rise at which one frame suffices, share of the headroom 0…1.</summary>
        public double ConclusiveRise { get; set; } = 0.33;

        /// <summary>Least area at half height, px² at 640, 0…10000.</summary>
        public double MinAreaPx { get; set; } = 4;

        /// <summary>Largest area at half height, px² at 640, 1…100000.</summary>
        public double MaxAreaPx { get; set; } = 600;

        /// <summary>Least area through that of the ellipse with the same second moments, 0…1.</summary>
        public double MinCompactness { get; set; } = 0.7;

        /// <summary>Largest length through width, 1…100.</summary>
        public double MaxElongation { get; set; } = 12;

        /// <summary>Least rise of a streak, share of the headroom 0…1: light smeared that far and still this bright is a laser's.</summary>
        public double StreakRise { get; set; } = 0.6;

        /// <summary>Largest length through width where the rise is below that of a streak.</summary>
        public double MaxFaintElongation { get; set; } = 4.5;

        /// <summary>The same for a candidate that is neither vivid nor small enough for one frame to suffice.</summary>
        public double MaxBluntElongation { get; set; } = 1.8;

        /// <summary>The same for a candidate that only the largest channel shows: faint streaks look like moving edges.</summary>
        public double MaxLargestElongation { get; set; } = 2.5;

        /// <summary>The same where one frame is to suffice.</summary>
        public double ConclusiveElongation { get; set; } = 4.5;

        /// <summary>Largest area where one frame is to suffice and the candidate is not vivid, px² at 640, 1…100000.</summary>
        public double ConclusiveAreaPx { get; set; } = 150;

        /// <summary>Largest share of the ring around the dot that rose at least half as far, 0…1; for a dot that has to wait.</summary>
        public double MaxRingShare { get; set; } = 0.04;

        /// <summary>The same for a dot that has to wait and whose rise would not be conclusive, unless it is vivid.</summary>
        public double MaxFaintRingShare { get; set; } = 0.005;

        /// <summary>The same where one frame is to suffice.</summary>
        public double ConclusiveRingShare { get; set; } = 0.02;

        /// <summary>Largest relative rise of the upper tenth of the ring, through the dot's own, 0…1.</summary>
        public double MaxRingLevel { get; set; } = 0.25;

        /// <summary>The same where the rise would not be conclusive.</summary>
        public double MaxFaintRingLevel { get; set; } = 0.12;

        /// <summary>The same where one frame is to suffice.</summary>
        public double ConclusiveRingLevel { get; set; } = 0.15;

        /// <summary>The same for a vivid candidate whose rise would not be conclusive: a strong halo is part of a laser dot.</summary>
        public double MaxVividRingLevel { get; set; } = 0.13;

        /// <summary>Least rise of the strongest channel since the last frame, per pixel of the dot, through the peak rise, 0…100.</summary>
        public double MinFreshness { get; set; } = 0.5;

        /// <summary>The same where the rise would not be conclusive.</summary>
        public double MinFaintFreshness { get; set; } = 0.65;

        /// <summary>Least red-green coherence of a large candidate that is not vivid, 0…1.</summary>
        public double MinBluntCoherence { get; set; } = 0.5;

        /// <summary>Least strength of a vivid candidate, levels·px at 640, 0…10000.</summary>
        public double VividStrength { get; set; } = 250;

        /// <summary>
        /// Rise of the stronger of red and green per pixel of the dot, through the peak rise, from which a candidate is vivid, 0…100.
        /// Grey things that brighten reach one.
        /// </summary>
        public double VividFreshness { get; set; } = 1.5;

        /// <summary>Largest share of the surroundings that changed since the last frame, 0…1; for a dot that has to wait.</summary>
        public double MaxMotionShare { get; set; } = 0.06;

        /// <summary>The same where one frame is to suffice.</summary>
        public double ConclusiveMotionShare { get; set; } = 0.035;

        /// <summary>The same for a dot that has to wait and whose rise would not be conclusive.</summary>
        public double MaxFaintMotionShare { get; set; } = 0.02;

        /// <summary>The same for an exemplary dot: strong, compact, round, small and with a silent ring.</summary>
        public double MaxExemplaryMotionShare { get; set; } = 0.6;

        /// <summary>Least rise of an exemplary dot, share of the headroom 0…1.</summary>
        public double ExemplaryRise { get; set; } = 0.75;

        /// <summary>Least compactness of an exemplary dot, 0…1.</summary>
        public double ExemplaryCompactness { get; set; } = 0.88;

        /// <summary>
        /// By how much light must exceed the projected picture's brightest to be none of it, levels, 1…255. Where less room is left
        /// above that, brightness proves nothing.
        /// </summary>
        public int MinContentExcess { get; set; } = 24;

        /// <summary>
        /// Recent activity nearby above which light no brighter than the projected picture has to prove itself by going out, levels, 0…255.
        /// </summary>
        public double QuietActivity { get; set; } = 4;

        /// <summary>Radius of the surroundings that must be at rest, px at 640, 4…320.</summary>
        public double MotionRadiusPx { get; set; } = 40;

        /// <summary>Share of the red-green differences over the dot that must point one way for a colour to be named, 0…1.</summary>
        public double ColorCoherence { get; set; } = 0.2;

        /// <summary>Least room that the other colour must have had left for a colour to be named, mean levels, 0…255.</summary>
        public double MinColorHeadroom { get; set; } = 4;

        /// <summary>Least strength (rise times root of area) of a candidate, levels·px at 640, 0…10000.</summary>
        public double MinStrength { get; set; } = 75;

        /// <summary>What each level of the tile's ordinary activity adds to the least strength, px at 640, 0…1000.</summary>
        public double StrengthPerActivity { get; set; } = 25;

        /// <summary>Least strength where the rise would not be conclusive.</summary>
        public double MinFaintStrength { get; set; } = 85;

        /// <summary>What each level of activity adds to it.</summary>
        public double FaintStrengthPerActivity { get; set; } = 80;

        /// <summary>Frames that a dot which is not conclusive may stay on before it is taken for scenery, 1…60.</summary>
        public int MaxWaitFrames { get; set; } = 5;

        /// <summary>Candidates that one frame may have examined in each of the two planes, 1…4096: bounds the time.</summary>
        public int MaxCandidates { get; set; } = 64;

        /// <summary>Explicit vector instructions where the processor has them; results are the same without.</summary>
        public bool UseVectors { get; set; } = true;

        /// <exception cref="ArgumentException">A value is outside its range or NaN; the message names it.</exception>
        public void Validate()
        {
            SettingCheck.InRange(nameof(FullSizeMaxWidthPx), FullSizeMaxWidthPx, 1, 16384);
            SettingCheck.InRange(nameof(EnvelopeDecay), EnvelopeDecay, 1, 64);
            SettingCheck.InRange(nameof(SmoothingNoise), SmoothingNoise, 0, 255);
            SettingCheck.InRange(nameof(MinRiseLevels), MinRiseLevels, 1, 255);
            SettingCheck.InRange(nameof(MinRiseSigmas), MinRiseSigmas, 0, 100);
            SettingCheck.InRange(nameof(MinRise), MinRise, 0, 1);
            SettingCheck.InRange(nameof(ConclusiveRise), ConclusiveRise, 0, 1);
            SettingCheck.InRange(nameof(MinAreaPx), MinAreaPx, 0, 10000);
            SettingCheck.InRange(nameof(MaxAreaPx), MaxAreaPx, 1, 100000);
            SettingCheck.InRange(nameof(MinCompactness), MinCompactness, 0, 1);
            SettingCheck.InRange(nameof(MaxBluntElongation), MaxBluntElongation, 1, 100);
            SettingCheck.InRange(nameof(MaxElongation), MaxElongation, 1, 100);
            SettingCheck.InRange(nameof(MaxLargestElongation), MaxLargestElongation, 1, 100);
            SettingCheck.InRange(nameof(ConclusiveElongation), ConclusiveElongation, 1, 100);
            SettingCheck.InRange(nameof(ConclusiveAreaPx), ConclusiveAreaPx, 1, 100000);
            SettingCheck.InRange(nameof(ConclusiveRingLevel), ConclusiveRingLevel, 0, 1);
            SettingCheck.InRange(nameof(MaxRingShare), MaxRingShare, 0, 1);
            SettingCheck.InRange(nameof(ConclusiveRingShare), ConclusiveRingShare, 0, 1);
            SettingCheck.InRange(nameof(MaxRingLevel), MaxRingLevel, 0, 1);
            SettingCheck.InRange(nameof(MaxVividRingLevel), MaxVividRingLevel, 0, 1);
            SettingCheck.InRange(nameof(VividFreshness), VividFreshness, 0, 100);
            SettingCheck.InRange(nameof(MaxMotionShare), MaxMotionShare, 0, 1);
            SettingCheck.InRange(nameof(ConclusiveMotionShare), ConclusiveMotionShare, 0, 1);
            SettingCheck.InRange(nameof(MaxFaintMotionShare), MaxFaintMotionShare, 0, 1);
            SettingCheck.InRange(nameof(MaxExemplaryMotionShare), MaxExemplaryMotionShare, 0, 1);
            SettingCheck.InRange(nameof(ExemplaryRise), ExemplaryRise, 0, 1);
            SettingCheck.InRange(nameof(ExemplaryCompactness), ExemplaryCompactness, 0, 1);
            SettingCheck.InRange(nameof(QuietActivity), QuietActivity, 0, 255);
            SettingCheck.InRange(nameof(MinContentExcess), MinContentExcess, 1, 255);
            SettingCheck.InRange(nameof(MotionRadiusPx), MotionRadiusPx, 4, 320);
            SettingCheck.InRange(nameof(ColorCoherence), ColorCoherence, 0, 1);
            SettingCheck.InRange(nameof(MinColorHeadroom), MinColorHeadroom, 0, 255);
            SettingCheck.InRange(nameof(MinStrength), MinStrength, 0, 10000);
            SettingCheck.InRange(nameof(StrengthPerActivity), StrengthPerActivity, 0, 1000);
            SettingCheck.InRange(nameof(MinFaintStrength), MinFaintStrength, 0, 10000);
            SettingCheck.InRange(nameof(FaintStrengthPerActivity), FaintStrengthPerActivity, 0, 1000);
            SettingCheck.InRange(nameof(MaxWaitFrames), MaxWaitFrames, 1, 60);
            SettingCheck.InRange(nameof(MaxFaintElongation), MaxFaintElongation, 1, 100);
            SettingCheck.InRange(nameof(MaxFaintRingShare), MaxFaintRingShare, 0, 1);
            SettingCheck.InRange(nameof(MaxFaintRingLevel), MaxFaintRingLevel, 0, 1);
            SettingCheck.InRange(nameof(MinFreshness), MinFreshness, 0, 100);
            SettingCheck.InRange(nameof(MinFaintFreshness), MinFaintFreshness, 0, 100);
            SettingCheck.InRange(nameof(MinBluntCoherence), MinBluntCoherence, 0, 1);
            SettingCheck.InRange(nameof(VividStrength), VividStrength, 0, 10000);
            SettingCheck.InRange(nameof(StreakRise), StreakRise, 0, 1);
            SettingCheck.InRange(nameof(MaxCandidates), MaxCandidates, 1, 4096);
        }

        public ShotDetectorSettings Clone() => (ShotDetectorSettings)MemberwiseClone();
    }
}
