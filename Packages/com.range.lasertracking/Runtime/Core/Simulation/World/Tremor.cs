using System;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// The restless part of one person's aim as a function of time: tremor whose frequency wanders, a weaker second peak (two
    /// thirds of people have several), and slow sway. Angles in radians.
    /// </summary>
    internal sealed class Tremor
    {
        private const double WanderRateHz = 0.4;

        private readonly double _amplitudeRad;
        private readonly double _swayRad;
        private readonly double _wanderRad;
        private readonly double[] _phases = new double[12];

        public Tremor(TremorSettings settings, int seed, int shooter)
        {
            for (int i = 0; i < _phases.Length; i++)
                _phases[i] = 2 * Math.PI * CounterRandom.Uniform(seed, RandomStream.Tremor, shooter, 100 + i);
            FrequencyHz = settings.FrequencyHz > 0
                ? settings.FrequencyHz
                : Math.Min(12, Math.Max(4, 7 + 1.3 * CounterRandom.Gaussian(seed, RandomStream.Tremor, shooter, 0)));
            // Log-normal about 0.5 mrad of peak angle; its 95 % interval spans the published population.
            double drawn = Math.Min(1.9, Math.Max(0.08, 0.5 * Math.Exp(0.65 * CounterRandom.Gaussian(seed, RandomStream.Tremor, shooter, 1)))) / Math.Sqrt(2);
            AmplitudeMrad = settings.AmplitudeMrad >= 0 ? settings.AmplitudeMrad : drawn;
            _amplitudeRad = AmplitudeMrad / 1000;
            _swayRad = settings.SwayMrad / 1000;
            // A phase of m sin(2π w t) moves the frequency by m w cos(2π w t), whose standard deviation is m w / √2.
            _wanderRad = settings.WanderHz * Math.Sqrt(2) / WanderRateHz;
        }

        public double FrequencyHz { get; }

        /// <summary>Root mean square along each axis.</summary>
        public double AmplitudeMrad { get; }

        public Vector2D AngleRad(double timeS)
        {
            double w = 2 * Math.PI * timeS;
            double wander = _wanderRad * Math.Sin(w * WanderRateHz + _phases[0]);
            return new Vector2D(Axis(w, wander, 1), Axis(w, wander, 6));
        }

        private double Axis(double w, double wander, int p)
        {
            double fast = 0.94 * Math.Sin(w * FrequencyHz + wander + _phases[p]) +
                          0.34 * Math.Sin(w * FrequencyHz * 1.45 + wander + _phases[p + 1]);
            double slow = 0.8 * Math.Sin(w * 0.31 + _phases[p + 2]) + 0.5 * Math.Sin(w * 0.62 + _phases[p + 3]) +
                          0.33 * Math.Sin(w * 0.97 + _phases[p + 4]);
            return Math.Sqrt(2) * (_amplitudeRad * fast + _swayRad * slow);
        }
    }
}
