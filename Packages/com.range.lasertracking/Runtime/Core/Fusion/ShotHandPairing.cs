using System;
using System.Runtime.CompilerServices;
using LaserTracking.Geometry;
using LaserTracking.Hands;

namespace LaserTracking.Fusion
{
    /// <summary>The line from a muzzle to a dot, and how well a dot agrees with an arm.</summary>
    public static class ShotHandPairing
    {
        /// <summary>The published d̂ = v / (|v| + ε) with v = target − muzzle.</summary>
        public static Vector3D Direction(Vector3D targetM, Vector3D muzzleM, double epsilonM)
        {
            Vector3D v = targetM - muzzleM;
            double length = v.Length + epsilonM;
            return length > 0 ? v * (1 / length) : default;
        }

        /// <summary>Angle between two directions of any length, 0…π; NaN when one of them is zero.</summary>
        public static double AngleRad(Vector3D a, Vector3D b) =>
            a.LengthSquared > 0 && b.LengthSquared > 0 ? Math.Atan2(Vector3D.Cross(a, b).Length, Vector3D.Dot(a, b)) : double.NaN;

        /// <summary>
        /// Fills muzzle, line, angle and pair time. False when the muzzle lies behind the screen, from where it cannot light it.
        /// </summary>
        /// <param name="hand">The hand at the shot's time, camera space.</param>
        /// <param name="screenM">The dot on the screen.</param>
        /// <param name="camera">Camera 1.</param>
        /// <param name="settings">ε and the drift.</param>
        /// <param name="shot">Shooter and probability stay zero.</param>
        public static bool TryPair(in PairedHand hand, Vector2D screenM, HandCamera camera, FusionSettings settings, out FusedShot shot)
        {
            var target = new Vector3D(screenM.X, screenM.Y, 0);
            Vector3D muzzle = camera.ToScreenM(hand.Hand.MuzzleMm);
            double drift = settings.MuzzleDriftMPerS * Math.Abs(hand.DeltaUs) * 1e-6 * (hand.IsInterpolated ? 0.25 : 1);
            double sigma = hand.Hand.MuzzleSigmaMm * Axes.MetresPerMillimetre;
            Vector3D axis = camera.PoseInScreenMm.TransformDirection(hand.Hand.AimDirection);
            shot = new FusedShot
            {
                Hand = hand.Hand.IsSideSure ? hand.Hand.Side : HandSide.Unknown,
                HandTrackId = hand.Hand.TrackId,
                HasMuzzle = true,
                MuzzleM = muzzle,
                MuzzleSigmaM = Math.Sqrt(sigma * sigma + drift * drift),
                Direction = Direction(target, muzzle, settings.EpsilonM),
                AimErrorRad = AngleRad(axis, target - muzzle),
                SightErrorRad = AngleRad(camera.PoseInScreenMm.TransformDirection(hand.Hand.SightDirection), target - muzzle),
                PairDeltaUs = hand.DeltaUs,
            };
            return muzzle.Z < 0 && muzzle.IsFinite;
        }

        /// <summary>
        /// Density, per m² of the screen, with which this hand's shots fall where the dot is: normal in the angle between the
        /// line and the sights, or the arm, plus a share of outliers over the half space, seen through the solid angle of the screen there.
        /// </summary>
        /// <param name="hand">The hand at the shot's time.</param>
        /// <param name="shot">As paired.</param>
        /// <param name="screenM">The dot.</param>
        /// <param name="settings">Shares and spreads.</param>
        /// <param name="sightShare">Part of the density that is due to the sights, 0…1.</param>
        /// <param name="weaponShare">How well the weapon's own picture lets it point to the dot, 0…1; counts where the sights do not lead there.</param>
        public static double ScreenDensity(in PairedHand hand, in FusedShot shot, Vector2D screenM, FusionSettings settings, out double sightShare, double weaponShare = 1)
        {
            Vector3D v = new Vector3D(screenM.X, screenM.Y, 0) - shot.MuzzleM;
            double distance = Math.Max(0.1, v.Length);
            double solidAnglePerM2 = Math.Max(0, v.Z / distance) / (distance * distance);
            double anywhere = 1 / (2 * Math.PI);
            double common = CommonVariance(hand, shot, distance, settings);
            double wrist = settings.WristSigmaRad * settings.WristSigmaRad + hand.Hand.AimSigmaRad * hand.Hand.AimSigmaRad + common;
            double sight = hand.Hand.SightSigmaRad * hand.Hand.SightSigmaRad + common;
            double sighted = double.IsNaN(shot.SightErrorRad) ? 0 : double.IsNaN(shot.AimErrorRad) ? 1 : settings.SightedShare;
            double aimed = 0;
            if (sighted > 0)
            {
                // The forearm bears the line out or not; its own angle is far too rough to be more than that.
                double arm = 2 * wrist, straight = double.IsNaN(shot.AimErrorRad) ? 1 : Math.Exp(-shot.AimErrorRad * shot.AimErrorRad / (2 * arm));
                aimed += sighted * SightDensity(shot.SightErrorRad, sight, settings, out _) * (settings.BentArmShare + (1 - settings.BentArmShare) * straight);
            }

            double bySight = (1 - settings.OutlierShare) * aimed;
            if (sighted < 1)
                aimed += (1 - sighted) * weaponShare * (double.IsNaN(shot.AimErrorRad) ? anywhere : Density(shot.AimErrorRad, wrist));
            double density = (1 - settings.OutlierShare) * aimed + settings.OutlierShare * weaponShare * anywhere;
            sightShare = bySight / density;
            return density * solidAnglePerM2;
        }

        /// <summary>Variance about one axis, square radians, of any line over this muzzle: the distance in time, and the muzzle's own error.</summary>
        internal static double CommonVariance(in PairedHand hand, in FusedShot shot, double distanceM, FusionSettings settings)
        {
            double seconds = Math.Abs(hand.DeltaUs) * 1e-6 * (hand.IsInterpolated ? 0.25 : 1);
            double drift = settings.AimDriftRadPerS * seconds, lever = shot.MuzzleSigmaM / Math.Max(0.1, distanceM);
            return drift * drift + lever * lever;
        }

        /// <summary>Density per steradian of light so far beside the line of sight; core is the part of it that is no far worse sighting than it says.</summary>
        internal static double SightDensity(double angleRad, double variance, FusionSettings settings, out double core)
        {
            core = (1 - settings.PoorSightShare) * Density(angleRad, variance);
            return core + settings.PoorSightShare * Density(angleRad, 9 * variance);
        }

        /// <summary>Normal in the two small angles beside a direction, per steradian.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static double Density(double angleRad, double variance) =>
            Math.Exp(-angleRad * angleRad / (2 * variance)) / (2 * Math.PI * variance);
    }
}
