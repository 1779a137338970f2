using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Session;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Studies.Multiuser
{
    /// <summary>Why nobody or somebody else was named: of what can be seen beside the truth the first that applies.</summary>
    internal static class MissReason
    {
        /// <summary>A muzzle farther from the true one is another's, or none.</summary>
        private const double FoundM = 0.1;

        /// <summary>Over an arm's length so much beside the line makes 20 mrad: four times the usual.</summary>
        private const double OffM = 0.015;

        /// <summary>Two lines nearer than three times the usual error cannot be told apart.</summary>
        private const double TogetherRad = 0.012;

        private const int LearnedShots = 3;

        /// <summary>Sightings before the shot that count: two frames of the slowest camera 1.</summary>
        private const double RecentUs = 70_000;

        /// <param name="range">With the truth.</param>
        /// <param name="fired">The shot.</param>
        /// <param name="isArmSeen">Forearm, hand and muzzle lie in camera 1's view.</param>
        /// <param name="hands">All that was said of hands.</param>
        /// <param name="namedBefore">How many of this person's shots had been named rightly.</param>
        public static string Of(SimulatedRange range, TrueShot fired, bool isArmSeen, IEnumerable<HandEvent> hands, int namedBefore)
        {
            if (!isArmSeen)
                return "arm out of view";
            double nearest = double.MaxValue, across = 0;
            foreach (HandEvent hand in hands)
            {
                double seenUs = range.Truth.DepthFrameTimeUs(hand.FrameIndex);
                if (seenUs > fired.SceneTimeUs + 5_000 || seenUs < fired.SceneTimeUs - RecentUs)
                    continue;
                TrueHand truth = range.Truth.HandAt(fired.Shooter, seenUs);
                Vector3D off = hand.MuzzleM - truth.MuzzleM;
                if (off.Length >= nearest)
                    continue;
                nearest = off.Length;
                across = (off - truth.LightDirection * Vector3D.Dot(off, truth.LightDirection)).Length;
            }

            if (nearest > FoundM)
                return "weapon not found";
            if (across > OffM)
                return "muzzle off by more than 15 mm";
            if (NearestOtherRad(range, fired) < TogetherRad)
                return "somebody else aims within 12 mrad";
            return namedBefore < LearnedShots ? "fewer than 3 shots of theirs known" : "other";
        }

        private static double NearestOtherRad(SimulatedRange range, TrueShot fired)
        {
            double nearest = double.MaxValue;
            for (int other = 1; other <= range.Scenario.Shooters.Count; other++)
            {
                TrueHand hand = range.Truth.HandAt(other, fired.SceneTimeUs);
                Vector3D toDot = new Vector3D(fired.ScreenM.X, fired.ScreenM.Y, 0) - hand.MuzzleM;
                if (other != fired.Shooter)
                    nearest = Math.Min(nearest, Math.Atan2(Vector3D.Cross(toDot, hand.LightDirection).Length, Vector3D.Dot(toDot, hand.LightDirection)));
            }

            return nearest;
        }
    }
}
