using System;
using LaserTracking.Detection;
using LaserTracking.Session;

namespace LaserTracking.Health
{
    /// <summary>Whether the picture leaves a dot room above it, and whether there is a picture at all.</summary>
    internal sealed class BrightnessCheck
    {
        private const long SaturatedAfterUs = 500_000;
        private const long DarkAfterUs = 2_000_000;
        private const long EndAfterUs = 1_000_000;

        /// <summary>Share of the samples that may be brighter than what counts as the brightest parts: dots, lamps.</summary>
        private const double BrightShare = 0.005;

        private readonly PictureMonitorSettings _settings;
        private readonly int _fullLevel;
        private readonly int[] _smallest = new int[256];
        private readonly int[] _largest = new int[256];
        private Condition _saturated;
        private Condition _dark;

        public BrightnessCheck(PictureMonitorSettings settings, ShotDetectorSettings limits)
        {
            _settings = settings;
            _fullLevel = 256 - (int)Math.Ceiling(DotRoom.LeastRiseLevels(limits, 0));
        }

        public void Update(SampleGrid grid, HealthWriter health)
        {
            if (grid.ScreenCount == 0)
                return;
            Array.Clear(_smallest, 0, 256);
            Array.Clear(_largest, 0, 256);
            byte[] blue = grid.Blue, green = grid.Green, red = grid.Red;
            bool[] isOnScreen = grid.IsOnScreen;
            for (int i = 0; i < grid.Count; i++)
            {
                if (isOnScreen[i])
                    _smallest[Math.Min(blue[i], Math.Min(green[i], red[i]))]++;
                _largest[Math.Max(blue[i], Math.Max(green[i], red[i]))]++;
            }

            int full = 0;
            for (int level = _fullLevel; level < 256; level++)
                full += _smallest[level];
            double share = full / (double)grid.ScreenCount;
            double limit = _settings.SaturatedShareLimit;
            if (_saturated.Update(share > limit, share < 0.6 * limit, health.TimeUs, SaturatedAfterUs, EndAfterUs))
            {
                health.Say(HealthKind.Overexposed, share, _saturated.IsOn
                    ? FormattableString.Invariant($"{share * 100:F0} % of the screen is so bright that a dot has no room above it: ") + ExposureAdvice.Text(_settings, Brightest(_smallest, grid.ScreenCount))
                    : "the picture is no longer over-exposed");
            }

            int brightest = Brightest(_largest, grid.Count);
            if (_dark.Update(brightest < _settings.DarkLevel, brightest > 1.4 * _settings.DarkLevel, health.TimeUs, DarkAfterUs, EndAfterUs))
            {
                health.Say(HealthKind.Underexposed, brightest, _dark.IsOn
                    ? FormattableString.Invariant($"the picture is almost black (its brightest parts reach {brightest} of 255): ") + (brightest < 3 ? "uncover the lens, or raise the exposure" : ExposureAdvice.Text(_settings, brightest))
                    : "the picture is bright enough again");
            }
        }

        private static int Brightest(int[] histogram, int count)
        {
            int level = 255;
            for (int above = histogram[255]; level > 0 && above <= count * BrightShare; above += histogram[level])
                level--;
            return level;
        }
    }
}
