using LaserTracking.Detection;
using LaserTracking.Geometry;

namespace LaserTracking.Fusion
{
    /// <summary>What is remembered of one shooter.</summary>
    internal struct ShooterRecord
    {
        /// <summary>Who it is among those seen: a person, or minus the track of a hand.</summary>
        public int Key;

        /// <summary>Where they last stood: their eyes, screen space; null where only a hand is known.</summary>
        public Vector3D? EyesM;

        /// <summary>Where their muzzle was last seen, screen space; null: never.</summary>
        public Vector3D? MuzzleM;

        public long SeenUs;

        private int _green;
        private int _red;
        private int _infrared;

        /// <summary>Halved from here on, so that a changed weapon counts after a while.</summary>
        private const int MaxCount = 16;

        public void Count(LaserColor color)
        {
            if (color == LaserColor.Green)
                _green++;
            else if (color == LaserColor.Red)
                _red++;
            else if (color == LaserColor.Infrared)
                _infrared++;
            if (_green + _red + _infrared <= MaxCount)
                return;
            _green /= 2;
            _red /= 2;
            _infrared /= 2;
        }

        /// <summary>
        /// How much likelier this colour is from this shooter than from somebody of whom nothing is known (each of three colours
        /// alike); 1 for an unknown colour or a shooter of whom no colour is known.
        /// </summary>
        public double ColorFactor(LaserColor color, double keptProbability)
        {
            int total = _green + _red + _infrared;
            if (color == LaserColor.Unknown || total == 0)
                return 1;
            int same = color == LaserColor.Green ? _green : color == LaserColor.Red ? _red : _infrared;
            double share = same / (double)total;
            return 3 * (share * keptProbability + (1 - share) * (1 - keptProbability) / 2);
        }
    }
}
