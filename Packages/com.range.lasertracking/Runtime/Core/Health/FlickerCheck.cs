using System;
using LaserTracking.Session;

namespace LaserTracking.Health
{
    /// <summary>
    /// Whether lamps on mains current make the picture flicker, as a whole or in travelling bands (rolling shutter). The changes from
    /// frame to frame of sixteen bands of rows are searched for the one frequency that all of them share; which mains it beats
    /// against follows from the frame rate. Beats slower than one a second change little from frame to frame and do no harm.
    /// </summary>
    internal sealed class FlickerCheck
    {
        private const int Bands = 16;
        private const int Frames = 48;
        private const int FramesBetween = 16;

        /// <summary>Frequencies tried: half a period of the window apart.</summary>
        private const int Frequencies = Frames;

        private const double LowestHz = 1;

        /// <summary>A change larger than this is something that moves, levels.</summary>
        private const int LargestChange = 40;

        private const int Darkest = 8, Brightest = 245;

        /// <summary>Share of all change that lies within the peak.</summary>
        private const double LeastShare = 0.5;

        private readonly PictureMonitorSettings _settings;
        private readonly float[] _changes = new float[Bands * Frames];
        private readonly float[] _cosine = new float[2 * Frames];
        private readonly double[] _power = new double[Frequencies + 1];
        private int _count;
        private long _firstUs;
        private Condition _flicker;

        public FlickerCheck(PictureMonitorSettings settings)
        {
            _settings = settings;
            for (int i = 0; i < _cosine.Length; i++)
                _cosine[i] = (float)Math.Cos(Math.PI * i / Frames);
        }

        public void Update(SampleGrid grid, HealthWriter health)
        {
            if (grid.FrameCount <= 1 || grid.Rows < Bands)
            {
                _count = 0;
                return;
            }

            if (_count == 0)
                _firstUs = health.TimeUs;
            for (int band = 0; band < Bands; band++)
                _changes[band * Frames + _count] = Change(grid, band * grid.Rows / Bands, (band + 1) * grid.Rows / Bands);
            if (++_count < Frames)
                return;
            double intervalS = (health.TimeUs - _firstUs) * 1e-6 / (Frames - 1);
            if (intervalS > 0)
                Analyse(intervalS, health);
            Array.Copy(_changes, FramesBetween, _changes, 0, _changes.Length - FramesBetween);
            _count -= FramesBetween;
            _firstUs += (long)(intervalS * 1e6 * FramesBetween);
        }

        /// <summary>Mean change of the samples at rest since the last frame, levels.</summary>
        private static float Change(SampleGrid grid, int firstRow, int endRow)
        {
            byte[] now = grid.Green, before = grid.GreenBefore;
            int sum = 0, count = 0;
            for (int i = firstRow * grid.Columns; i < endRow * grid.Columns; i++)
            {
                int level = now[i], change = level - before[i];
                if (level < Darkest || level > Brightest || change > LargestChange || change < -LargestChange)
                    continue;
                sum += change;
                count++;
            }

            return count < 8 ? 0 : (float)sum / count;
        }

        private void Analyse(double intervalS, HealthWriter health)
        {
            double total = 0;
            Array.Clear(_power, 0, _power.Length);
            for (int band = 0; band < Bands; band++)
            {
                for (int k = 0; k < Frames; k++)
                    total += _changes[band * Frames + k] * _changes[band * Frames + k];
                for (int f = 1; f <= Frequencies; f++)
                {
                    Transform(band, f, out double real, out double imaginary);
                    _power[f] += real * real + imaginary * imaginary;
                }
            }

            double rate = 1 / intervalS;
            int best = 0;
            for (int f = 1; f <= Frequencies; f++)
            {
                if (f * rate / (2 * Frames) >= LowestHz && _power[f] > _power[best])
                    best = f;
            }

            // A sine of amplitude a has the transform a·N/2, at half the frame rate a·N; changes are 2 sin(ω/2) times the values.
            double full = best == Frequencies ? Frames : Frames / 2.0;
            double change = Math.Sqrt(_power[best] / Bands) / full, levels = best == 0 ? 0 : change / (2 * Math.Sin(Math.PI * best / (2 * Frames)));
            double share = total > 0 ? change * change * Bands * full / total : 0;
            bool isFlicker = levels >= _settings.FlickerLevels && share >= LeastShare;
            if (_flicker.Update(isFlicker, levels < 0.7 * _settings.FlickerLevels || share < 0.6 * LeastShare, health.TimeUs, 0, 2_000_000) && _flicker.IsOn)
                health.Say(HealthKind.Flicker, levels, Text(best * rate / (2 * Frames), rate, levels, IsBanded(best)));
        }

        private void Transform(int band, int frequency, out double real, out double imaginary)
        {
            // The frequency is frequency/2 periods a window: the angle of frame k is π·frequency·k/Frames.
            float re = 0, im = 0;
            int row = band * Frames;
            for (int k = 0; k < Frames; k++)
            {
                int angle = frequency * k % (2 * Frames), quarter = angle - Frames / 2;
                re += _changes[row + k] * _cosine[angle];
                im += _changes[row + k] * _cosine[quarter < 0 ? quarter + 2 * Frames : quarter];
            }

            real = re;
            imaginary = im;
        }

        /// <summary>The bands of rows do not change together.</summary>
        private bool IsBanded(int frequency)
        {
            double real = 0, imaginary = 0;
            for (int band = 0; band < Bands; band++)
            {
                Transform(band, frequency, out double re, out double im);
                real += re;
                imaginary += im;
            }

            return real * real + imaginary * imaginary < 0.6 * Bands * _power[frequency];
        }

        private string Text(double beatHz, double rate, double levels, bool isBanded)
        {
            double off50 = Math.Abs(Alias(100, rate) - beatHz), off60 = Math.Abs(Alias(120, rate) - beatHz), tolerance = 0.5 + rate / Frames;
            string what = FormattableString.Invariant($"{(isBanded ? "bands of light travel through the picture" : "the whole picture flickers")} (±{levels:F1} levels, {beatHz:F1} a second)");
            bool is50 = off50 <= tolerance && off50 <= off60, is60 = off60 <= tolerance && !is50;
            if (!is50 && !is60)
                return what + " and not with the mains: set the exposure to a whole period of the projector, 16.67 ms at 60 Hz";
            double period = is50 ? 10 : 25.0 / 3;
            string choices = 2 * period <= 1000 / rate ? FormattableString.Invariant($"{period:0.##} or {2 * period:0.##}") : FormattableString.Invariant($"{period:0.##}");
            return what + FormattableString.Invariant($" from lamps on {(is50 ? 50 : 60)} Hz mains: set the exposure to {choices} ms");
        }

        private static double Alias(double frequency, double rate) => Math.Abs(frequency - rate * Math.Round(frequency / rate));
    }
}
