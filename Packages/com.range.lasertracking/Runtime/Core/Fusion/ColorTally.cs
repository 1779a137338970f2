using LaserTracking.Detection;

namespace LaserTracking.Fusion
{
    /// <summary>How many shots of each colour somebody has fired; parts of shots where it is not sure who did.</summary>
    internal struct ColorTally
    {
        /// <summary>Halved from here on, so that a changed weapon counts after a while.</summary>
        private const double MaxCount = 16;

        private double _green;
        private double _red;
        private double _infrared;

        public void Count(LaserColor color, double share)
        {
            if (color == LaserColor.Green)
                _green += share;
            else if (color == LaserColor.Red)
                _red += share;
            else if (color == LaserColor.Infrared)
                _infrared += share;
            if (_green + _red + _infrared <= MaxCount)
                return;
            _green /= 2;
            _red /= 2;
            _infrared /= 2;
        }

        /// <summary>
        /// How much likelier this colour is from them than from somebody of whom nothing is known (each of three colours alike, which
        /// counts as half a shot seen); 1 for an unknown colour.
        /// </summary>
        public double Factor(LaserColor color, double keptProbability)
        {
            const double unseen = 0.5;
            double total = _green + _red + _infrared;
            if (color == LaserColor.Unknown)
                return 1;
            double same = color == LaserColor.Green ? _green : color == LaserColor.Red ? _red : _infrared;
            double share = (same + unseen / 3) / (total + unseen);
            return 3 * (share * keptProbability + (1 - share) * (1 - keptProbability) / 2);
        }
    }
}
