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

        internal DetectionAdvice(AdvisorSettings settings, PowerLadder[] ladders, RegionAdvice[] regions, Func<double, double> levelsOf, double intervalUs, double exposureUs, int maxWaitFrames, string gain)
        {
            _settings = settings;
            _ladders = ladders;
            Regions = regions;
            IntervalUs = intervalUs;
            ExposureUs = exposureUs;
            _maxWaitFrames = maxWaitFrames;
            Gain = gain;
            var whole = new PowerLadder(settings.Gamma);
            foreach (PowerLadder ladder in ladders)
                whole.Add(ladder);
            ShortestMs = whole.ShortestMs(settings.CaughtShare, settings.PowerMw, exposureUs, intervalUs, maxWaitFrames);
            DimmestMw = whole.LeastMw(settings.CaughtShare);
            DimmestLevels = double.IsNaN(DimmestMw) ? double.NaN : levelsOf(DimmestMw);
            if (double.IsNaN(ShortestMs))
                return;
            for (int region = 0; region < ladders.Length; region++)
            {
                if (Probability(region, settings.PowerMw, ShortestMs) < 0.5)
                    BlindRegions++;
            }
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

        /// <summary>Shortest flash of which nine of ten (the share asked for) are caught wherever they fall on the screen, ms; NaN: none.</summary>
        public double ShortestMs { get; }

        /// <summary>Power of a dot that is taken with the same share when it is lit for a whole exposure, mW; NaN: none.</summary>
        public double DimmestMw { get; }

        /// <summary>How far its strongest channel rises in most parts, levels; NaN: none.</summary>
        public double DimmestLevels { get; }

        /// <summary>Parts in which less than half of the flashes of <see cref="ShortestMs"/> are caught.</summary>
        public int BlindRegions { get; }

        /// <summary>One sentence for people, and what to do.</summary>
        public string Sentence
        {
            get
            {
                string laser = FormattableString.Invariant($"{_settings.Color.ToString().ToLowerInvariant()} laser of {_settings.PowerMw:0.###} mW");
                string assumed = _settings.ExposureUs > 0 ? string.Empty : " if the exposure is half a frame", gain = Gain.Length > 0 ? "; " + Gain : string.Empty;
                if (double.IsNaN(ShortestMs))
                    return FormattableString.Invariant($"less than {_settings.CaughtShare * 100:0.#} % of flashes of a {laser} are caught here, however long they are{assumed}{gain}");
                string text = FormattableString.Invariant($"{_settings.CaughtShare * 100:0.#} % of flashes of a {laser} are caught from {ShortestMs:0.#} ms on{assumed}");
                if (BlindRegions > 0)
                    text += FormattableString.Invariant($", hardly any in {BlindRegions} of {Regions.Count} parts of the screen");
                if (!double.IsNaN(DimmestMw))
                    text += FormattableString.Invariant($"; lit for a whole exposure, {DimmestMw:0.###} mW suffice (a rise of {DimmestLevels:F0} levels)");
                return text + gain;
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
    }
}
