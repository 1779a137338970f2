using System;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Every constant of the published algorithm, with the published value as default. What the publication leaves open is marked
    /// "our reading". Checked when a <see cref="PaperShotDetector"/> is made from it.
    /// </summary>
    public sealed class PaperDetectorSettings
    {
        /// <summary>Frames wider than this are reduced to it by area averaging, px, 16…8192.</summary>
        public int ReducedWidthPx { get; set; } = 960;

        /// <summary>α of the background B ← αB + (1-α)I, 0…1.</summary>
        public double BackgroundAlpha { get; set; } = 0.95;

        /// <summary>γ of the spike map M ← max(blurred difference, γM), 0…1: half its height is left after 5 frames.</summary>
        public double SpikeGamma { get; set; } = 0.88;

        /// <summary>Weight of the spike map in the score, 0…1.</summary>
        public double SpikeWeight { get; set; } = 0.6;

        /// <summary>Weight of the green excess in the score, 0…1.</summary>
        public double GreenWeight { get; set; } = 0.4;

        /// <summary>Share of the frame's pixels with the highest scores that are candidates, above 0…1.</summary>
        public double TopShare { get; set; } = 0.005;

        /// <summary>Least green excess of a candidate, levels 0…255.</summary>
        public double MinGreenExcess { get; set; } = 25;

        /// <summary>Least confidence of a dot, 0…1.</summary>
        public double MinConfidence { get; set; } = 0.3;

        /// <summary>Weight of peak intensity in the confidence, 0…1.</summary>
        public double PeakWeight { get; set; } = 0.4;

        /// <summary>Weight of local contrast in the confidence, 0…1.</summary>
        public double ContrastWeight { get; set; } = 0.3;

        /// <summary>Weight of nearness to the picture's centre in the confidence, 0…1.</summary>
        public double CenterWeight { get; set; } = 0.2;

        /// <summary>Weight of stability of movement in the confidence, 0…1.</summary>
        public double StabilityWeight { get; set; } = 0.1;

        /// <summary>Half the side of the window around the best pixel for contrast and position, reduced px, 1…64. Our reading.</summary>
        public int WindowRadiusPx { get; set; } = 8;

        /// <summary>Movement since the last dot at which stability is zero, reduced px, above 0. Our reading.</summary>
        public double StabilityRangePx { get; set; } = 100;

        /// <summary>Explicit vector instructions where the processor has them; results are the same without.</summary>
        public bool UseVectors { get; set; } = true;

        /// <exception cref="ArgumentException">A value is outside its range or NaN; the message names it.</exception>
        public void Validate()
        {
            SettingCheck.InRange(nameof(ReducedWidthPx), ReducedWidthPx, 16, 8192);
            SettingCheck.InRange(nameof(BackgroundAlpha), BackgroundAlpha, 0, 1);
            SettingCheck.InRange(nameof(SpikeGamma), SpikeGamma, 0, 1);
            SettingCheck.InRange(nameof(SpikeWeight), SpikeWeight, 0, 1);
            SettingCheck.InRange(nameof(GreenWeight), GreenWeight, 0, 1);
            SettingCheck.InRange(nameof(TopShare), TopShare, 1e-6, 1);
            SettingCheck.InRange(nameof(MinGreenExcess), MinGreenExcess, 0, 255);
            SettingCheck.InRange(nameof(MinConfidence), MinConfidence, 0, 1);
            SettingCheck.InRange(nameof(PeakWeight), PeakWeight, 0, 1);
            SettingCheck.InRange(nameof(ContrastWeight), ContrastWeight, 0, 1);
            SettingCheck.InRange(nameof(CenterWeight), CenterWeight, 0, 1);
            SettingCheck.InRange(nameof(StabilityWeight), StabilityWeight, 0, 1);
            SettingCheck.InRange(nameof(WindowRadiusPx), WindowRadiusPx, 1, 64);
            SettingCheck.InRange(nameof(StabilityRangePx), StabilityRangePx, 1e-3, 1e6);
        }

        public PaperDetectorSettings Clone() => (PaperDetectorSettings)MemberwiseClone();
    }
}
