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
        public double MinRise { get; set; } = 0.05;

        /// <summary>Rise below which a candidate needs more evidence, share of the headroom 0…1: much that is faint comes and goes.</summary>
        public double FaintRise { get; set; } = 0.12;

        /// <summary>Least evidence of a candidate fainter than that, log-odds −20…20.</summary>
        public double FaintLogOdds { get; set; } = 1.5;

        /// <summary>Share of the picture's tiles that have risen, 0…1, from which such a candidate must be conclusive: many at once are no laser.</summary>
        public double CrowdedShare { get; set; } = 1 / 60.0;

        /// <summary>Least evidence of a candidate, log-odds −20…20: below, one reason is named. See DotEvidence.</summary>
        public double MinLogOdds { get; set; } = 0.6;

        /// <summary>By what candidates are weighed; what the detector was built with unless told otherwise. Never null.</summary>
        public DotEvidence Evidence { get; set; } = DotEvidence.Learned;

        /// <summary>Evidence at which one frame suffices, log-odds −20…20.</summary>
        public double ConclusiveLogOdds { get; set; } = 2.1;

        /// <summary>Further evidence needed where the projected picture's brightest is known and the candidate is no brighter, log-odds 0…20.</summary>
        public double ContentLogOdds { get; set; } = 1.4;

        /// <summary>Least area at half height, working px (half the picture's above <see cref="FullSizeMaxWidthPx"/>), 0…10000: one pixel alone is noise.</summary>
        public double MinAreaPx { get; set; } = 2;

        /// <summary>Largest area at half height, px² at 640, 1…100000.</summary>
        public double MaxAreaPx { get; set; } = 600;

        /// <summary>Least area through that of the ellipse with the same second moments, 0…1: nothing ragged is a dot.</summary>
        public double MinCompactness { get; set; } = 0.3;

        /// <summary>Least rise of the strongest channel since the last frame, per pixel of the dot, through the peak rise, 0…100.</summary>
        public double MinFreshness { get; set; } = 0.5;

        /// <summary>Largest length through width, 1…100.</summary>
        public double MaxElongation { get; set; } = 12;

        /// <summary>The same where one frame is to suffice.</summary>
        public double ConclusiveElongation { get; set; } = 4.5;

        /// <summary>Largest share of the ring around the dot that rose at least half as far, 0…1; for a dot that has to wait.</summary>
        public double MaxRingShare { get; set; } = 0.04;

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

        /// <summary>Frames that a dot which is not conclusive may stay on at any frame rate, 1…60.</summary>
        public int MaxWaitFrames { get; set; } = 5;

        /// <summary>For how long it may stay on before it is taken for scenery, where that is more frames, µs, 0…1 s: the longest flash, 300 ms, and an exposure.</summary>
        public long MaxWaitUs { get; set; } = 335_000;

        /// <summary>The same where something moves around it, µs, 0…1 s.</summary>
        public long MaxWaitAmidMovementUs { get; set; } = 170_000;

        /// <summary>Candidates that one frame may have examined in each of the two planes, 1…4096: bounds the time.</summary>
        public int MaxCandidates { get; set; } = 64;

        /// <summary>Explicit vector instructions where the processor has them; results are the same without.</summary>
        public bool UseVectors { get; set; } = true;

        /// <exception cref="ArgumentException">A value is outside its range or NaN; the message names it.</exception>
        public void Validate()
        {
            if (Evidence == null)
                throw new ArgumentException("evidence is needed to weigh candidates", nameof(Evidence));
            SettingCheck.InRange(nameof(FullSizeMaxWidthPx), FullSizeMaxWidthPx, 1, 16384);
            SettingCheck.InRange(nameof(EnvelopeDecay), EnvelopeDecay, 1, 64);
            SettingCheck.InRange(nameof(SmoothingNoise), SmoothingNoise, 0, 255);
            SettingCheck.InRange(nameof(MinRiseLevels), MinRiseLevels, 1, 255);
            SettingCheck.InRange(nameof(MinRiseSigmas), MinRiseSigmas, 0, 100);
            SettingCheck.InRange(nameof(MinRise), MinRise, 0, 1);
            SettingCheck.InRange(nameof(FaintRise), FaintRise, 0, 1);
            SettingCheck.InRange(nameof(FaintLogOdds), FaintLogOdds, -20, 20);
            SettingCheck.InRange(nameof(CrowdedShare), CrowdedShare, 0, 1);
            SettingCheck.InRange(nameof(MinLogOdds), MinLogOdds, -20, 20);
            SettingCheck.InRange(nameof(ConclusiveLogOdds), ConclusiveLogOdds, -20, 20);
            SettingCheck.InRange(nameof(ContentLogOdds), ContentLogOdds, 0, 20);
            SettingCheck.InRange(nameof(MinAreaPx), MinAreaPx, 0, 10000);
            SettingCheck.InRange(nameof(MaxAreaPx), MaxAreaPx, 1, 100000);
            SettingCheck.InRange(nameof(MinCompactness), MinCompactness, 0, 1);
            SettingCheck.InRange(nameof(MinFreshness), MinFreshness, 0, 100);
            SettingCheck.InRange(nameof(MaxElongation), MaxElongation, 1, 100);
            SettingCheck.InRange(nameof(ConclusiveElongation), ConclusiveElongation, 1, 100);
            SettingCheck.InRange(nameof(MaxRingShare), MaxRingShare, 0, 1);
            SettingCheck.InRange(nameof(QuietActivity), QuietActivity, 0, 255);
            SettingCheck.InRange(nameof(MinContentExcess), MinContentExcess, 1, 255);
            SettingCheck.InRange(nameof(MotionRadiusPx), MotionRadiusPx, 4, 320);
            SettingCheck.InRange(nameof(ColorCoherence), ColorCoherence, 0, 1);
            SettingCheck.InRange(nameof(MinColorHeadroom), MinColorHeadroom, 0, 255);
            SettingCheck.InRange(nameof(MaxWaitFrames), MaxWaitFrames, 1, 60);
            SettingCheck.InRange(nameof(MaxWaitUs), MaxWaitUs, 0, 1_000_000);
            SettingCheck.InRange(nameof(MaxWaitAmidMovementUs), MaxWaitAmidMovementUs, 0, 1_000_000);
            SettingCheck.InRange(nameof(MaxCandidates), MaxCandidates, 1, 4096);
        }

        public ShotDetectorSettings Clone() => (ShotDetectorSettings)MemberwiseClone();
    }
}
