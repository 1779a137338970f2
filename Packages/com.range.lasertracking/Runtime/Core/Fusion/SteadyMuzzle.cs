using System;
using LaserTracking.Geometry;

namespace LaserTracking.Fusion
{
    /// <summary>
    /// Where a weapon is that holds still for its shot: the mean of its last sightings. Two thirds of what a seen muzzle errs is different in every
    /// frame, and by 3 mm over an arm's length one line of fire differs from another.
    /// </summary>
    internal static class SteadyMuzzle
    {
        /// <summary>Over how long before the shot: aiming settles for 0.15 s and more. And after it, where that was seen: one frame.</summary>
        private const long BeforeUs = 170_000;
        private const long AfterUs = 40_000;

        /// <summary>It holds still where its sightings lie that close together: noise makes 3 to 4 mm of a weapon at rest, a swing 10 mm a frame.</summary>
        private const double StillMm = 8;

        /// <summary>Only muzzles known that well: one that is guessed errs alike in every frame.</summary>
        private const double MaxSigmaMm = 8;

        /// <summary>Share of the variance that all sightings have in common. Measured on the simulated range.</summary>
        private const double CommonShare = 0.36;

        /// <summary>Sets muzzle and its standard deviation; false, with the hand as it was, where it moves or was seen once only.</summary>
        public static bool TryFind(HandHistory history, long timeUs, ref PairedHand hand)
        {
            if (hand.Hand.MuzzleSigmaMm > MaxSigmaMm)
                return false;
            int count = history.Steady(hand.Hand.TrackId, timeUs - BeforeUs, timeUs + AfterUs, StillMm, out Vector3D muzzle);
            if (count < 2)
                return false;
            hand.Hand.MuzzleMm = muzzle;
            hand.Hand.MuzzleSigmaMm *= Math.Sqrt(CommonShare + (1 - CommonShare) / count);
            return true;
        }
    }
}
