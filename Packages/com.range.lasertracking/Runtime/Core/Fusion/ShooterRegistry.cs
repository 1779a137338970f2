using System;
using LaserTracking.Detection;
using LaserTracking.Geometry;

namespace LaserTracking.Fusion
{
    /// <summary>Who has fired so far. Numbers are given in the order of first shots and stay with the person, also over a lost track.</summary>
    internal sealed class ShooterRegistry
    {
        /// <summary>More people than ever stand on one range; further ones stay unknown.</summary>
        public const int MaxShooters = 32;

        private readonly FusionSettings _settings;
        private readonly ShooterRecord[] _shooters = new ShooterRecord[MaxShooters];
        private int _count;

        public ShooterRegistry(FusionSettings settings) => _settings = settings;

        public void Clear() => _count = 0;

        /// <summary>Notes where a hand is now.</summary>
        public void See(int key, Vector3D muzzleM, long timeUs)
        {
            for (int i = 0; i < _count; i++)
            {
                if (_shooters[i].Key != key)
                    continue;
                _shooters[i].MuzzleM = muzzleM;
                _shooters[i].SeenUs = Math.Max(_shooters[i].SeenUs, timeUs);
            }
        }

        /// <summary>The number of the shooter who this is, or 0 when nobody of that place has fired yet.</summary>
        /// <param name="key">A person, or minus the track of a hand.</param>
        /// <param name="eyesM">Where they stand, if known.</param>
        /// <param name="hand">Where their hand is, if seen.</param>
        /// <param name="timeUs">When.</param>
        /// <param name="visible">All keys seen at that time: a shooter who is among them is not taken over from afar.</param>
        public int Find(int key, Vector3D? eyesM, in FusedShot hand, long timeUs, ReadOnlySpan<int> visible)
        {
            for (int i = 0; i < _count; i++)
            {
                if (_shooters[i].Key == key)
                    return i + 1;
            }

            int best = 0;
            double bestDistance = double.MaxValue;
            for (int i = 0; i < _count; i++)
            {
                ref readonly ShooterRecord record = ref _shooters[i];
                double distance = record.EyesM is Vector3D stood && eyesM is Vector3D stands ? (stood - stands).Length
                    : record.MuzzleM is Vector3D muzzle && hand.HasMuzzle ? (muzzle - hand.MuzzleM).Length : double.MaxValue;
                double reach = visible.IndexOf(record.Key) >= 0 ? _settings.SameWeaponM : _settings.RelinkM;
                if (distance > reach || distance >= bestDistance || Math.Abs(timeUs - record.SeenUs) > _settings.RelinkUs)
                    continue;
                best = i + 1;
                bestDistance = distance;
            }

            return best;
        }

        public double ColorFactor(int shooter, LaserColor color) =>
            shooter == 0 ? 1 : _shooters[shooter - 1].Colors.Factor(color, _settings.ColorKeptProbability);

        /// <summary>Notes a shot; gives a new number for shooter 0. Returns 0 when there is no room for another person.</summary>
        public int Fired(int shooter, int key, Vector3D? eyesM, in FusedShot hand, long timeUs, LaserColor color)
        {
            if (shooter == 0)
            {
                if (_count == MaxShooters)
                    return 0;
                _shooters[_count] = default;
                shooter = ++_count;
            }

            ref ShooterRecord record = ref _shooters[shooter - 1];
            record.Key = key;
            record.EyesM = eyesM;
            if (hand.HasMuzzle)
                record.MuzzleM = hand.MuzzleM;
            record.SeenUs = Math.Max(record.SeenUs, timeUs);
            record.Colors.Count(color, 1);
            return shooter;
        }
    }
}
