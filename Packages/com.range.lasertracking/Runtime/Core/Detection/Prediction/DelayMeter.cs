using System;
#if NET8_0_OR_GREATER
using System.Numerics;
#endif

namespace LaserTracking.Detection
{
    /// <summary>
    /// Measures the delay between drawing and seeing: how the camera's cells changed since the last frame is correlated with how the
    /// rendered ones did, averaged over the exposure, for every delay on a fine grid; the best one, interpolated, wins. Forgets within
    /// a second, so that it follows. As in Samadani's cross-talk reduction (2010), nothing needs to be synchronised.
    /// </summary>
    internal sealed unsafe class DelayMeter
    {
        private const long StepUs = 4_000;
        private const double Keep = 0.95;

        /// <summary>Frames with motion after which a delay can be known.</summary>
        private const double MinFrames = 5;

        /// <summary>Steps to either side of a known delay that are still looked at.</summary>
        private const int Near = 10;

        /// <summary>Mean squared change of a cell's brightness below which nothing moves: noise does as much.</summary>
        private const double MinEnergy = 40 * 40;

        private readonly PredictionSettings _settings;
        private readonly double[] _common;
        private readonly double[] _drawn;
        private readonly double[] _seen;
        private readonly double[] _frames;
        private readonly int[] _now = new int[ScreenGrid.CellCount];
        private readonly int[] _past = new int[ScreenGrid.CellCount];
        private readonly short[] _before = new short[ScreenGrid.CellCount];
        private bool _hasBefore;
        private long _beforeUs;
        private int _best = -1;

        public DelayMeter(PredictionSettings settings)
        {
            _settings = settings;
            int count = (int)((settings.MaxDelayUs - settings.MinDelayUs) / StepUs) + 1;
            _common = new double[count];
            _drawn = new double[count];
            _seen = new double[count];
            _frames = new double[count];
        }

        public bool IsKnown => _best >= 0;

        /// <summary>From drawing to mid-exposure.</summary>
        public long DelayUs { get; private set; }

        /// <summary>Delays up to this far to either side fit about as well.</summary>
        public long UncertaintyUs { get; private set; }

        /// <summary>0…1.</summary>
        public double Correlation { get; private set; }

        public void Reset()
        {
            Forget();
            _hasBefore = false;
        }

        /// <summary>Takes the cells of the next camera frame. The caller holds the history's gate.</summary>
        public void Update(RenderedFrameHistory history, long timeUs, short[] cells, bool[] isHidden)
        {
            if (_hasBefore && timeUs > _beforeUs && timeUs - _beforeUs < 500_000)
            {
                double energy = 0;
                int count = 0;
                for (int i = 0; i < cells.Length; i++)
                {
                    int change = cells[i] - _before[i];
                    if (isHidden[i])
                        continue;
                    energy += (double)change * change;
                    count++;
                }

                if (energy > MinEnergy * count)
                    Correlate(history, timeUs, cells, isHidden, energy);
            }

            Array.Copy(cells, _before, cells.Length);
            _beforeUs = timeUs;
            _hasBefore = true;
        }

        private void Correlate(RenderedFrameHistory history, long timeUs, short[] cells, bool[] isHidden, double energy)
        {
            int first = IsKnown ? Math.Max(0, _best - Near) : 0, last = IsKnown ? Math.Min(_common.Length - 1, _best + Near) : _common.Length - 1;
            for (int d = first; d <= last; d++)
            {
                long delay = _settings.MinDelayUs + d * StepUs;
                if (!TryBlend(history, timeUs - delay, _now) || !TryBlend(history, _beforeUs - delay, _past))
                    continue;
                double common = 0, drawn = 0;
                for (int i = 0; i < cells.Length; i++)
                {
                    if (isHidden[i])
                        continue;
                    double change = (_now[i] - _past[i]) * (1.0 / 256);
                    common += change * (cells[i] - _before[i]);
                    drawn += change * change;
                }

                _common[d] = Keep * _common[d] + common;
                _drawn[d] = Keep * _drawn[d] + drawn;
                _seen[d] = Keep * _seen[d] + energy;
                _frames[d] = Keep * _frames[d] + 1;
            }

            Choose(first, last);
        }

        private double Score(int d) =>
            _frames[d] >= MinFrames * 0.8 && _common[d] > 0 ? _common[d] / Math.Sqrt(_drawn[d] * _seen[d] + 1) : 0;

        private void Choose(int first, int last)
        {
            int best = first;
            for (int d = first + 1; d <= last; d++)
            {
                if (Score(d) > Score(best))
                    best = d;
            }

            double score = Score(best);
            if (score < (IsKnown ? 0.6 : 1) * _settings.MinCorrelation)
            {
                if (IsKnown)
                    Forget();
                return;
            }

            Correlation = score;
            _best = best;

            // Where the curve of scores is as high as makes no difference lies the uncertainty.
            double enough = score - Math.Max(0.004, 0.15 * (1 - score));
            int low = best, high = best;
            while (low > first && Score(low - 1) >= enough)
                low--;
            while (high < last && Score(high + 1) >= enough)
                high++;
            double offset = 0;
            if (best > first && best < last)
            {
                double left = Score(best - 1), right = Score(best + 1), bend = left - 2 * score + right;
                if (bend < -1e-9)
                    offset = 0.5 * (left - right) / bend;
            }

            DelayUs = _settings.MinDelayUs + (long)((best + offset) * StepUs);
            UncertaintyUs = Math.Max(high - best, best - low) * StepUs;
        }

        private void Forget()
        {
            Array.Clear(_common, 0, _common.Length);
            Array.Clear(_drawn, 0, _drawn.Length);
            Array.Clear(_seen, 0, _seen.Length);
            Array.Clear(_frames, 0, _frames.Length);
            _best = -1;
            Correlation = 0;
        }

        /// <summary>256 times what the cells showed on average over an exposure around this time of drawing.</summary>
        private bool TryBlend(RenderedFrameHistory history, long middleUs, int[] target)
        {
            long exposure = Math.Max(1000, _settings.ExposureUs), begin = middleUs - exposure / 2, end = begin + exposure;
            if (history.Count == 0 || history.At(history.Count - 1).TimeUs > begin || history.EndUs(0) < end)
                return false;
            Array.Clear(target, 0, target.Length);
            fixed (int* sums = target)
            {
                for (int age = 0; age < history.Count; age++)
                {
                    RenderedPicture picture = history.At(age);
                    long share = Math.Min(end, history.EndUs(age)) - Math.Max(begin, picture.TimeUs);
                    if (share <= 0)
                        continue;
                    int weight = (int)((share * 256 + exposure / 2) / exposure);
                    fixed (short* cells = picture.Cells)
                        AddWeighed(cells, weight, sums);

                    if (picture.TimeUs <= begin)
                        break;
                }
            }

            return true;
        }

        /// <summary>Adds so many times the cells to their sums.</summary>
        internal static void AddWeighed(short* cells, int weight, int* sums)
        {
            int i = 0;
#if NET8_0_OR_GREATER
            for (; i + Vector<short>.Count <= ScreenGrid.CellCount; i += Vector<short>.Count)
            {
                Vector.Widen(Vector.Load(cells + i), out Vector<int> low, out Vector<int> high);
                int* upper = sums + i + Vector<int>.Count;
                Vector.Store(Vector.Load(sums + i) + low * weight, sums + i);
                Vector.Store(Vector.Load(upper) + high * weight, upper);
            }
#endif
            for (; i < ScreenGrid.CellCount; i++)
                sums[i] += weight * cells[i];
        }
    }
}
