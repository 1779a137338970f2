using System;
using LaserTracking.Session;

namespace LaserTracking.Health
{
    /// <summary>
    /// Whether the whole picture grew brighter, darker or differently coloured by one factor, as when a camera sets its exposure or
    /// white balance by itself. What moves, or changes in a part of the picture only, does not share the factor.
    /// </summary>
    internal sealed class ExposureCheck
    {
        private const long ReferenceUs = 500_000;
        private const long StepUs = 90_000;
        private const long QuietUs = 5_000_000;

        /// <summary>A projected flash is over sooner.</summary>
        private const long LastsUs = 150_000;

        private const int PerOctave = 256;
        private const int Bins = 2 * PerOctave + 1;

        /// <summary>Levels from which the logarithm is fine enough, and up to which nothing clips.</summary>
        private const int Darkest = 20, Brightest = 240;

        private const double LeastUsable = 0.15, LeastCoherent = 0.75;

        /// <summary>A sample shares the factor within this, log2: six per cent.</summary>
        private const int Tolerance = 22;

        private readonly PictureMonitorSettings _settings;
        private readonly int _limit;
        private readonly int[] _logarithm = new int[256];
        private readonly int[] _histogram = new int[Bins];
        private readonly byte[][] _old = { Array.Empty<byte>(), Array.Empty<byte>(), Array.Empty<byte>() };
        private readonly byte[][] _recent = { Array.Empty<byte>(), Array.Empty<byte>(), Array.Empty<byte>() };
        private long _recentUs;
        private long _checkedUs;
        private int _references;
        private Condition _exposure;
        private Condition _color;

        public ExposureCheck(PictureMonitorSettings settings)
        {
            _settings = settings;
            _limit = (int)Math.Round(Math.Log(1 + settings.ExposureChange) / Math.Log(2) * PerOctave);
            for (int level = 1; level < 256; level++)
                _logarithm[level] = (int)Math.Round(Math.Log(level) / Math.Log(2) * PerOctave);
        }

        public void Update(SampleGrid grid, HealthWriter health)
        {
            long now = health.TimeUs;
            if (grid.FrameCount == 1 || now < _checkedUs)
            {
                _references = 0;
                _recentUs = now;
                Keep(grid);
            }

            if (now - _checkedUs < StepUs && now >= _checkedUs)
                return;
            _checkedUs = now;
            if (_references > 0)
                Compare(grid, health);
            if (now - _recentUs < ReferenceUs)
                return;
            _recentUs = now;
            Keep(grid);
        }

        private void Keep(SampleGrid grid)
        {
            for (int c = 0; c < 3; c++)
            {
                (_old[c], _recent[c]) = (_recent[c], _old[c]);
                if (_recent[c].Length != grid.Count)
                    _recent[c] = new byte[grid.Count];
                Array.Copy(grid.Channel(c), _recent[c], grid.Count);
                if (_old[c].Length != grid.Count)
                    _old[c] = (byte[])_recent[c].Clone();
            }

            _references++;
        }

        private void Compare(SampleGrid grid, HealthWriter health)
        {
            bool isKnown = TryFactor(grid, 1, out int green);
            bool isExposure = isKnown && Math.Abs(green) >= _limit;
            if (_exposure.Update(isExposure, !isExposure, health.TimeUs, LastsUs, QuietUs) && _exposure.IsOn)
            {
                double factor = Math.Pow(2, green * _settings.Gamma / PerOctave);
                string how = factor > 1
                    ? FormattableString.Invariant($"{(factor - 1) * 100:F0} % more light")
                    : FormattableString.Invariant($"{(1 - factor) * 100:F0} % less light");
                health.Say(HealthKind.ExposureChange, factor, $"the whole picture has {how} than a second ago: lock the camera's exposure, or leave the room's light as it is");
            }

            int blue = 0, red = 0;
            bool isColored = isKnown && TryFactor(grid, 0, out blue) && TryFactor(grid, 2, out red);
            blue = isColored ? blue - green : 0;
            red = isColored ? red - green : 0;
            int most = Math.Abs(red) >= Math.Abs(blue) ? red : blue;
            bool isColor = Math.Abs(most) >= _limit;
            if (_color.Update(isColor, !isColor, health.TimeUs, LastsUs, QuietUs) && _color.IsOn)
            {
                double factor = Math.Pow(2, most / (double)PerOctave);
                string name = most == red ? "red" : "blue";
                health.Say(HealthKind.ColorChange, factor, FormattableString.Invariant($"the whole picture's {name} changed by {(factor - 1) * 100:+0;-0} % against its green within a second: lock the camera's white balance"));
            }
        }

        /// <summary>The factor that most of the samples share, log2 times 256, against half a second to a second ago.</summary>
        private bool TryFactor(SampleGrid grid, int channel, out int factor)
        {
            Array.Clear(_histogram, 0, Bins);
            byte[] now = grid.Channel(channel), old = _old[channel];
            int count = 0;
            for (int i = 0; i < now.Length; i++)
            {
                if (now[i] < Darkest || now[i] > Brightest || old[i] < Darkest || old[i] > Brightest)
                    continue;
                int ratio = _logarithm[now[i]] - _logarithm[old[i]] + PerOctave;
                _histogram[ratio < 0 ? 0 : ratio >= Bins ? Bins - 1 : ratio]++;
                count++;
            }

            factor = 0;
            if (count < LeastUsable * grid.Count)
                return false;
            int middle = 0, below = 0;
            while (2 * (below + _histogram[middle]) < count)
                below += _histogram[middle++];
            int coherent = 0;
            for (int bin = Math.Max(0, middle - Tolerance); bin <= Math.Min(Bins - 1, middle + Tolerance); bin++)
                coherent += _histogram[bin];
            factor = middle - PerOctave;
            return coherent >= LeastCoherent * count;
        }
    }
}
