using System;

namespace LaserTracking.Hands.Model
{
    /// <summary>Settings of <see cref="LandmarkHandTracker"/>.</summary>
    public sealed class LandmarkHandSettings
    {
        /// <summary>Side of the first square around a hand, mm: a hand and a third of it to each side. The model bears ±20 %.</summary>
        public double RegionMm { get; set; } = 270;

        /// <summary>Runs of the network in one frame, 2 or more: what bounds the time. A new hand takes 2, one whose forearm points at the camera 5.</summary>
        public int MaxRunsPerFrame { get; set; } = 6;

        /// <summary>After a failure the same hand is tried again only after this time, microseconds: a fist around a grip may never be seen.</summary>
        public long RetryUs { get; set; } = 500_000;

        /// <summary>
        /// Least length of the forearm's direction as seen, 0…1 (1: across the line of sight). Below it, about 20 degrees, the
        /// picture does not tell how the hand is turned, and four rotations are tried.
        /// </summary>
        public double MinAxisInPicture { get; set; } = 0.35;

        /// <summary>Largest bend of the wrist against the forearm in the picture, radians: a hand seen upside down is none.</summary>
        public double MaxWristBendRad { get; set; } = 1.75;

        /// <summary>Largest ratio, either way, between the palm's length by depth and by the model: tells a hand from its picture.</summary>
        public double MaxScaleRatio { get; set; } = 1.7;

        /// <summary>Standard deviation of the landmarks' palm across the line of sight, mm.</summary>
        public double PalmSigmaMm { get; set; } = 15;

        /// <exception cref="ArgumentException">A value is outside its range.</exception>
        public void Validate()
        {
            Check(RegionMm > 0 && PalmSigmaMm > 0, "lengths above zero");
            Check(MaxRunsPerFrame >= 2, "at least two runs a frame");
            Check(RetryUs >= 0, "times not below zero");
            Check(MinAxisInPicture > 0 && MinAxisInPicture <= 1, "the axis' least length within 0…1");
            Check(MaxWristBendRad > 0 && MaxScaleRatio > 1, "a wrist bend above 0 and a ratio above 1");
        }

        private static void Check(bool isValid, string rule)
        {
            if (!isValid)
                throw new ArgumentException("hand model: " + rule);
        }
    }
}
