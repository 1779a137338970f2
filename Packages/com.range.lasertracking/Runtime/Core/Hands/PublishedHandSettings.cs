using System;

namespace LaserTracking.Hands
{
    /// <summary>The constants of the published hand method. Its bounds belong to the authors' room; each default says why it was chosen.</summary>
    public sealed class PublishedHandSettings
    {
        /// <summary>Published 400 mm: nearer than that the sensor is unreliable.</summary>
        public double NearMm { get; set; } = 400;

        /// <summary>Published 2000 mm: beyond lie the projection screen and what it reflects.</summary>
        public double FarMm { get; set; } = 2000;

        /// <summary>
        /// Change against the frame before, mm, from which a pixel counts as moving. Not published; 40 mm is above twice the
        /// sensor's random error (17 mm). A pixel that gains or loses its depth changes by all of it.
        /// </summary>
        public double MotionMm { get; set; } = 40;

        /// <summary>Published 5×5 patch: radius 2.</summary>
        public int PatchRadiusPx { get; set; } = 2;

        /// <summary>Published fallback of 1500 mm where the patch has no depth: the distance at which the user stands there.</summary>
        public double AssumedDepthMm { get; set; } = 1500;

        /// <summary>
        /// Smallest number of moving pixels in the gate, as a share of the picture; not published. 0.05 % is 184 px of 640×576, a
        /// tenth of a palm at 1.2 m, and above what single bad pixels reach together after the gate.
        /// </summary>
        public double MinMovingShare { get; set; } = 0.0005;

        /// <summary>Standard deviation of a measured position: the sensor's random error.</summary>
        public double MeasuredSigmaMm { get; set; } = 17;

        /// <summary>Standard deviation of an assumed distance: uniform over the gate of 1600 mm.</summary>
        public double AssumedSigmaMm { get; set; } = 460;

        /// <exception cref="ArgumentException">A value is outside its range.</exception>
        public void Validate()
        {
            if (!(NearMm >= 0 && FarMm > NearMm && FarMm <= ushort.MaxValue))
                throw new ArgumentException("published hand settings: 0 <= NearMm < FarMm <= 65535");
            if (!(MotionMm > 0 && AssumedDepthMm > 0 && MeasuredSigmaMm > 0 && AssumedSigmaMm > 0))
                throw new ArgumentException("published hand settings: lengths above zero");
            if (PatchRadiusPx < 0 || PatchRadiusPx > DepthPatch.MaxRadius)
                throw new ArgumentException("published hand settings: PatchRadiusPx 0…5");
            if (!(MinMovingShare >= 0 && MinMovingShare < 1))
                throw new ArgumentException("published hand settings: MinMovingShare at least 0, below 1");
        }
    }
}
