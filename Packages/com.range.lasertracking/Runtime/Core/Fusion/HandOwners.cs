using System;
using LaserTracking.Geometry;
using LaserTracking.Hands;

namespace LaserTracking.Fusion
{
    /// <summary>
    /// Whose each hand is at the moment of a shot. The tracker gives an arm to the head over its rear end, which is a neighbour's where arms
    /// cross; where the weapon itself is seen, its bearing and its distance from the point somebody aims over say more. A hand has one owner, and
    /// whose weapon is seen fires with no other hand. Bounded, without allocation.
    /// </summary>
    internal sealed class HandOwners
    {
        /// <summary>A muzzle known worse than this was not seen.</summary>
        private const double WeaponSigmaMm = 25;

        /// <summary>A sighting farther off in time says no more where the weapon is: two frames of the slowest camera 1.</summary>
        private const long SameTimeUs = 50_000;

        /// <summary>How much a hand still counts however badly it fits: a lowered weapon, a bent elbow, a bearing taken from two arms.</summary>
        private const double MisfitShare = 0.02;

        /// <summary>Hands less likely theirs are not looked at.</summary>
        private const double MinShare = 0.002;

        private readonly HandCamera _camera;
        private readonly FusionSettings _settings;
        private readonly SightLines _sights;

        /// <summary>Column by column, <see cref="FusionSettings.MaxHands"/> wide.</summary>
        private readonly double[] _owned;
        private readonly double[] _weapons;
        private readonly bool[] _isWeaponSeen;

        public HandOwners(HandCamera camera, FusionSettings settings, SightLines sights)
        {
            _camera = camera;
            _settings = settings;
            _sights = sights;
            _owned = new double[settings.MaxHands * settings.MaxHands];
            _weapons = new double[settings.MaxHands];
            _isWeaponSeen = new bool[settings.MaxHands];
        }

        /// <param name="hands">At the moment of the shot.</param>
        /// <param name="keys">The columns: persons, or minus the track of a hand whose person is unknown.</param>
        public void ShareOut(ReadOnlySpan<PairedHand> hands, ReadOnlySpan<int> keys)
        {
            Array.Clear(_weapons, 0, _weapons.Length);
            for (int i = 0; i < hands.Length; i++)
            {
                _isWeaponSeen[i] = Math.Abs(hands[i].DeltaUs) <= SameTimeUs && hands[i].Hand.MuzzleSigmaMm <= WeaponSigmaMm;
                double sum = 0;
                for (int k = 0; k < keys.Length; k++)
                    sum += _owned[k * _settings.MaxHands + i] = Weight(hands[i].Hand, keys[k]);
                for (int k = 0; sum > 0 && k < keys.Length; k++)
                {
                    ref double owned = ref _owned[k * _settings.MaxHands + i];
                    owned /= sum;
                    if (_isWeaponSeen[i])
                        _weapons[k] = Math.Min(1, _weapons[k] + owned);
                }
            }
        }

        /// <summary>Probability that the weapon of a column is among those seen just then.</summary>
        public double WeaponShare(int column) => _weapons[column];

        /// <summary>Probability that a hand is the one with which this column fires.</summary>
        public double Share(int column, int hand) =>
            _owned[column * _settings.MaxHands + hand] * (_isWeaponSeen[hand] ? 1 : 1 - _weapons[column]);

        /// <summary>How well a weapon's own picture agrees with a direction in screen space, 0…1; 1 where it is not seen.</summary>
        public double BearingFit(in HandObservation hand, Vector3D direction)
        {
            Vector3D weapon = _camera.PoseInScreenMm.TransformDirection(hand.WeaponDirection);
            if (weapon.LengthSquared == 0)
                return 1;
            double turn = Math.Atan2(weapon.X * direction.Z - weapon.Z * direction.X, weapon.X * direction.X + weapon.Z * direction.Z);
            return Fit(turn / _settings.BearingSigmaRad);
        }

        private double Weight(in HandObservation hand, int key)
        {
            bool isOwn = ShotHypotheses.KeyOf(hand) == key;
            if (key < 0)
                return isOwn ? 1 : 0;
            double weight = isOwn ? 1 : _settings.NeighbourShare;
            if (_sights.TryReachError(key, _camera.ToScreenM(hand.MuzzleMm), out double errors, out Vector3D sight))
                weight *= Fit(errors) * BearingFit(hand, sight);
            else if (!isOwn)
                return 0;
            return weight < MinShare ? 0 : weight;
        }

        private static double Fit(double errors) => MisfitShare + (1 - MisfitShare) * Math.Exp(-0.5 * errors * errors);
    }
}
