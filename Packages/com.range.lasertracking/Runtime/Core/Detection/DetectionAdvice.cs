using System;
using System.Collections.Generic;

namespace LaserTracking.Detection
{
    /// <summary>What is caught here and what is not, as a map of the screen and in words. Immutable.</summary>
    public sealed class DetectionAdvice
    {
        private readonly PowerLadder[] _ladders;
        private readonly AdvisorSettings _settings;
        private readonly int _maxWaitFrames;

        internal DetectionAdvice(AdvisorSettings settings, PowerLadder[] ladders, RegionAdvice[] regions, double intervalUs, double exposureUs, int maxWaitFrames, string gain)
        {
            _settings = settings;
            _ladders = ladders;
            Regions = regions;
            IntervalUs = intervalUs;
            ExposureUs = exposureUs;
            _maxWaitFrames = maxWaitFrames;
            Gain = gain;
        }

        public int Columns => _settings.Columns;

        public int Rows => _settings.Rows;

        /// <summary>Row by row from the top left.</summary>
        public IReadOnlyList<RegionAdvice> Regions { get; }

        /// <summary>From frame to frame.</summary>
        public double IntervalUs { get; }

        /// <summary>As given, or as assumed.</summary>
        public double ExposureUs { get; }

        /// <summary>What to change to gain most; empty when nothing needs to.</summary>
        public string Gain { get; }

        /// <summary>Parts in which the laser asked about is caught at some length.</summary>
        public int CaughtRegions
        {
            get
            {
                int count = 0;
                foreach (RegionAdvice region in Regions)
                {
                    if (!double.IsNaN(region.ShortestMs))
                        count++;
                }

                return count;
            }
        }

        /// <summary>Shortest flash that is caught in nine of ten of those parts, ms; NaN: none.</summary>
        public double ShortestMs => NineOfTen(region => region.ShortestMs);

        /// <summary>Dimmest dot that is caught in nine of ten of the parts where any is, mW; NaN: none.</summary>
        public double DimmestMw => NineOfTen(region => region.DimmestMw);

        /// <summary>The same as a rise of the strongest channel, levels.</summary>
        public double DimmestLevels => NineOfTen(region => region.DimmestLevels);

        /// <summary>One sentence for people, and what to do.</summary>
        public string Sentence
        {
            get
            {
                string laser = FormattableString.Invariant($"{_settings.Color.ToString().ToLowerInvariant()} laser of {_settings.PowerMw:0.###} mW");
                if (CaughtRegions == 0)
                    return "a " + laser + " is not reliably caught anywhere here" + (Gain.Length > 0 ? "; " + Gain : string.Empty);
                string where = CaughtRegions == Regions.Count ? "all over the screen" : FormattableString.Invariant($"in {CaughtRegions} of {Regions.Count} parts of the screen");
                string text = FormattableString.Invariant($"flashes of a {laser} are caught from {ShortestMs:0.#} ms on {where}{(_settings.ExposureUs > 0 ? string.Empty : " if the exposure is half a frame")}; lit for a whole exposure, {DimmestMw:0.###} mW suffice (a rise of {DimmestLevels:F0} levels)");
                return text + (Gain.Length > 0 ? "; " + Gain : string.Empty);
            }
        }

        /// <summary>Probability, 0…1, that a flash somewhere on the screen at some moment is caught.</summary>
        /// <param name="powerMw">Of the laser asked about, or another of its colour and size.</param>
        /// <param name="pulseMs">Length of the flash.</param>
        public double Probability(double powerMw, double pulseMs)
        {
            double sum = 0;
            for (int region = 0; region < _ladders.Length; region++)
                sum += Probability(region, powerMw, pulseMs);
            return sum / _ladders.Length;
        }

        /// <summary>The same in one part of the screen.</summary>
        public double Probability(int region, double powerMw, double pulseMs)
        {
            return _ladders[region].Caught(powerMw, pulseMs * 1000, ExposureUs, IntervalUs, _maxWaitFrames);
        }

        private double NineOfTen(Func<RegionAdvice, double> value)
        {
            var values = new List<double>();
            foreach (RegionAdvice region in Regions)
            {
                if (!double.IsNaN(value(region)))
                    values.Add(value(region));
            }

            values.Sort();
            return values.Count == 0 ? double.NaN : values[(int)Math.Ceiling(0.9 * values.Count) - 1];
        }
    }
}
