using System;

namespace LaserTracking.Detection
{
    /// <summary>How often dots of rising power were taken: a curve from nothing to everything, in steps of one and a half.</summary>
    internal sealed class PowerLadder
    {
        public const int Steps = 26;
        private const double FirstMw = 2e-4;
        private const double Ratio = 1.5;
        private const double ShortestTriedMs = 1, LongestMs = 300;

        private readonly int[] _taken = new int[Steps];
        private readonly int[] _conclusive = new int[Steps];

        private readonly double _gamma;
        private double _background;
        private double _perMw;

        /// <param name="gamma">Display value = linear light^(1/gamma).</param>
        public PowerLadder(double gamma) => _gamma = gamma;

        /// <summary>Dots tried at each step.</summary>
        public int Tried { get; private set; }

        /// <summary>Power of a step, lit for a whole exposure, mW.</summary>
        public static double PowerMw(int step) => FirstMw * Math.Pow(Ratio, step);

        /// <param name="backgroundLight">Linear light of the place's strongest channel, 0…1.</param>
        /// <param name="lightPerMw">What a milliwatt adds to it.</param>
        public void BeginTry(double backgroundLight, double lightPerMw)
        {
            Tried++;
            _background += backgroundLight;
            _perMw += lightPerMw;
        }

        /// <summary>Mean display value of the background, 0…1.</summary>
        public double Background => Math.Pow(_background / Tried, 1 / _gamma);

        /// <summary>How far a power raises the strongest channel, share of full brightness.</summary>
        public double Rise(double powerMw) => Tried == 0 ? 0 : Math.Pow(Math.Min(1, (_background + powerMw * _perMw) / Tried), 1 / _gamma) - Background;

        /// <summary>The power for a rise.</summary>
        private double PowerFor(double rise) => (Math.Pow(Math.Min(1, Background + rise), _gamma) - _background / Tried) * Tried / _perMw;

        public void Take(int step, bool isConclusive)
        {
            _taken[step]++;
            if (isConclusive)
                _conclusive[step]++;
        }

        /// <summary>Takes another one's dots in.</summary>
        public void Add(PowerLadder other)
        {
            Tried += other.Tried;
            _background += other._background;
            _perMw += other._perMw;
            for (int step = 0; step < Steps; step++)
            {
                _taken[step] += other._taken[step];
                _conclusive[step] += other._conclusive[step];
            }
        }

        /// <summary>Probability that a flash is caught.</summary>
        public double Caught(double powerMw, double pulseUs, double exposureUs, double intervalUs, int maxWaitFrames) => FlashTiming.Caught(
            pulseUs, exposureUs, intervalUs, maxWaitFrames, share => Taken(powerMw * share), share => Conclusive(powerMw * share),
            share => share < 0 ? PowerFor(-share) / powerMw : Rise(powerMw * share));

        /// <summary>Length from which this share of flashes is caught, ms; NaN: at no length up to 300 ms.</summary>
        public double ShortestMs(double share, double powerMw, double exposureUs, double intervalUs, int maxWaitFrames)
        {
            double CaughtOf(double ms) => Caught(powerMw, ms * 1000, exposureUs, intervalUs, maxWaitFrames);

            // What lasts longer and is not conclusive becomes scenery: longer is not always better, so the first length that suffices counts.
            double low = 0, high = ShortestTriedMs;
            while (high <= LongestMs && CaughtOf(high) < share)
            {
                low = high;
                high *= 1.25;
            }

            if (high > LongestMs)
                return double.NaN;
            for (int i = 0; i < 5; i++)
            {
                double middle = 0.5 * (low + high);
                if (CaughtOf(middle) >= share)
                    high = middle;
                else
                    low = middle;
            }

            return high;
        }

        /// <summary>Share taken at a power, 0…1; between the steps along the power's logarithm.</summary>
        public double Taken(double powerMw) => Share(_taken, powerMw);

        /// <summary>Share of those for which one frame sufficed.</summary>
        public double Conclusive(double powerMw) => Share(_conclusive, powerMw);

        /// <summary>Least power from which this share is taken at every step, mW; NaN: none.</summary>
        public double LeastMw(double share)
        {
            int step = Steps;
            while (step > 0 && _taken[step - 1] >= share * Tried)
                step--;
            if (step == Steps || Tried == 0)
                return double.NaN;
            if (step == 0)
                return FirstMw;
            double below = _taken[step - 1], part = (share * Tried - below) / Math.Max(1e-9, _taken[step] - below);
            return PowerMw(step - 1) * Math.Pow(Ratio, Math.Min(1, part));
        }

        private double Share(int[] counts, double powerMw)
        {
            if (Tried == 0 || powerMw <= 0)
                return 0;
            double at = Math.Log(powerMw / FirstMw) / Math.Log(Ratio);
            if (at <= 0)
                return at < -1 ? 0 : counts[0] * (1 + at) / Tried;
            int low = Math.Min(Steps - 1, (int)at), high = Math.Min(Steps - 1, low + 1);
            double part = Math.Min(1, at - low);
            return (counts[low] + part * (counts[high] - counts[low])) / Tried;
        }
    }
}
