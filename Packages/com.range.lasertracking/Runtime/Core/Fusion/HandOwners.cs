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
        /// <summary>A column's point of aim and how far before it they hold a weapon; not known of a hand without a person.</summary>
        private struct Arm
        {
            public bool IsKnown;
            public Vector3D PivotM;
            public double ReachM;
            public double ReachSigmaM;
        }

        /// <summary>A muzzle known worse than this was not seen.</summary>
        private const double WeaponSigmaMm = 25;

        /// <summary>Nor was a hand known worse than this. One that is seen without its weapon, lowered or end-on, mostly is the one that holds it.</summary>
        private const double HandSigmaMm = 60;
        private const double HandShare = 0.8;

        /// <summary>A sighting farther off in time says no more where the weapon is: two frames of the slowest camera 1.</summary>
        private const long SameTimeUs = 50_000;

        /// <summary>How much one's own hand still counts however badly it fits: a lowered weapon, a bent elbow, a bearing taken from two arms.</summary>
        private const double MisfitShare = 0.02;

        /// <summary>Weight of a hand's being held out by nobody: one that fits badly hangs down.</summary>
        private const double NobodysShare = 0.01;

        /// <summary>Hands less likely theirs are not looked at.</summary>
        private const double MinShare = 0.002;

        private readonly HandCamera _camera;
        private readonly FusionSettings _settings;
        private readonly SightLines _sights;

        /// <summary>Column by column, <see cref="FusionSettings.MaxHands"/> wide.</summary>
        private readonly double[] _owned;
        private readonly Arm[] _arms;
        private readonly double[] _weapons;
        private readonly double[] _visible;
        private readonly bool[] _isWeaponSeen;

        public HandOwners(HandCamera camera, FusionSettings settings, SightLines sights)
        {
            _camera = camera;
            _settings = settings;
            _sights = sights;
            _owned = new double[settings.MaxHands * settings.MaxHands];
            _arms = new Arm[settings.MaxHands];
            _weapons = new double[settings.MaxHands];
            _visible = new double[settings.MaxHands];
            _isWeaponSeen = new bool[settings.MaxHands];
        }

        /// <param name="hands">At the moment of the shot.</param>
        /// <param name="keys">The columns: persons, or minus the track of a hand whose person is unknown.</param>
        public void ShareOut(ReadOnlySpan<PairedHand> hands, ReadOnlySpan<int> keys)
        {
            Array.Clear(_weapons, 0, _weapons.Length);
            Array.Clear(_visible, 0, _visible.Length);
            for (int k = 0; k < keys.Length; k++)
                _arms[k].IsKnown = keys[k] > 0 && _sights.TryReach(keys[k], out _arms[k].PivotM, out _arms[k].ReachM, out _arms[k].ReachSigmaM);
            for (int i = 0; i < hands.Length; i++)
                ShareOut(i, hands[i], keys);
        }

        /// <summary>Probability that the hand with which a column would fire is among those seen just then.</summary>
        public double Visible(int column) => _visible[column];

        /// <summary>Whether a hand's weapon is seen just then.</summary>
        public bool IsWeaponSeen(int hand) => _isWeaponSeen[hand];

        /// <summary>Probability that a hand is the one with which this column fires.</summary>
        public double Share(int column, int hand) =>
            _owned[column * _settings.MaxHands + hand] * (_isWeaponSeen[hand] ? 1 : 1 - _weapons[column]);

        /// <summary>How well a weapon's own picture agrees with a direction in screen space, 0…1; 1 where it is not seen.</summary>
        public double BearingFit(in HandObservation hand, Vector3D direction)
        {
            if (hand.WeaponDirection.LengthSquared == 0)
                return 1;
            Vector3D weapon = _camera.PoseInScreenMm.TransformDirection(hand.WeaponDirection);
            double errors = Vector3D.Turn(weapon, direction) / _settings.BearingSigmaRad;
            return AtLeast(Math.Exp(-0.5 * errors * errors));
        }

        private void ShareOut(int i, in PairedHand pair, ReadOnlySpan<int> keys)
        {
            bool isNow = Math.Abs(pair.DeltaUs) <= SameTimeUs;
            _isWeaponSeen[i] = isNow && pair.Hand.MuzzleSigmaMm <= WeaponSigmaMm;
            bool isHandSeen = isNow && pair.Hand.MuzzleSigmaMm <= HandSigmaMm;
            Vector3D muzzle = _camera.ToScreenM(pair.Hand.MuzzleMm);
            double sum = NobodysShare;
            for (int k = 0; k < keys.Length; k++)
                sum += _owned[k * _settings.MaxHands + i] = Weight(pair.Hand, muzzle, keys[k], _arms[k]);
            for (int k = 0; k < keys.Length; k++)
            {
                ref double owned = ref _owned[k * _settings.MaxHands + i];
                owned /= sum;
                if (_isWeaponSeen[i])
                    _weapons[k] = Math.Min(1, _weapons[k] + owned);
                double hand = isHandSeen && !_isWeaponSeen[i] && owned > 0 ? HandShare * owned * ReachFit(muzzle, _arms[k]) : 0;
                _visible[k] = Math.Max(_visible[k], Math.Max(_weapons[k], hand));
            }
        }

        private double Weight(in HandObservation hand, Vector3D muzzleM, int key, in Arm arm)
        {
            bool isOwn = ShotHypotheses.KeyOf(hand) == key;
            if (!arm.IsKnown)
                return isOwn ? 1 : 0;
            double reach = ReachFit(muzzleM, arm), weight = isOwn ? AtLeast(reach) : _settings.NeighbourShare * reach;
            return weight < MinShare ? 0 : weight * BearingFit(hand, muzzleM - arm.PivotM);
        }

        private static double ReachFit(Vector3D muzzleM, in Arm arm)
        {
            double errors = ((muzzleM - arm.PivotM).Length - arm.ReachM) / arm.ReachSigmaM;
            return Math.Exp(-0.5 * errors * errors);
        }

        private static double AtLeast(double fit) => MisfitShare + (1 - MisfitShare) * fit;
    }
}
