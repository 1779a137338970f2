using System;

namespace LaserTracking.Detection
{
    /// <summary>
    /// How the camera sees what the projector is given, learned on the run: one tone curve a channel for the whole screen, and a gain
    /// and an offset for each cell and channel (vignetting, hot spot, lamps). Outliers pull only so far, so lasers and people do not
    /// spoil it. Learned from looks where rendered pictures are even, for these forgive a geometry that is not exact.
    /// </summary>
    internal sealed unsafe class ColorTransfer
    {
        private const int Nodes = 17;
        private const double MinRate = 0.002;
        private const double MaxPull = 15;
        private const double CellKeep = 0.99;

        /// <summary>Variance of a cell's tones, levels squared, from which they say more of its gain than the rest of the screen does.</summary>
        private const double Ridge = 400;

        /// <summary>Looks at which a cell has half a say about its gain and offset.</summary>
        private const double FewLooks = 10;

        /// <summary>Looks at a tone from which it counts as seen.</summary>
        private const double MinNodeWeight = 4;

        /// <summary>Looks at a tone from which a single one pulls only so far.</summary>
        private const double SureWeight = 150;

        /// <summary>Frames until the curve is good enough to tell cells apart, and to be used.</summary>
        private const int CurveFrames = 8;

        private readonly double[] _nodes = new double[3 * Nodes];
        private readonly double[] _weights = new double[3 * Nodes];
        private readonly double[] _curves = new double[3 * 256];
        private readonly double[] _gains = new double[CellBlend.Length];
        private readonly double[] _offsets = new double[CellBlend.Length];
        private readonly double[] _sums = new double[5 * 3 * ScreenGrid.CellCount];
        private readonly int[] _errors = new int[64];
        private int _frames;
        private int _looks;
        private double _error;
        private double _sum;
        private double _sumOfSquares;

        public ColorTransfer() => Reset();

        /// <summary>Of each cell for blue, green, red; as <see cref="CellBlend"/> takes them.</summary>
        public double[] Gains => _gains;

        /// <summary>The same, levels.</summary>
        public double[] Offsets => _offsets;

        public bool IsLearned => _frames >= CurveFrames;

        /// <summary>Mean squared error through the variance of what was seen (or through 12 levels squared, if that is more), of late.</summary>
        public double ErrorShare { get; private set; }

        /// <summary>
        /// Temporal noise of the picture, levels (one standard deviation), from looks at quite even content; 0: there were too few. Does
        /// not mistake moving content for noise, as differences between frames do.
        /// </summary>
        public double Noise { get; set; }

        public void Reset()
        {
            for (int i = 0; i < _nodes.Length; i++)
                _nodes[i] = i % Nodes * 16;
            Array.Clear(_weights, 0, _weights.Length);
            Array.Clear(_offsets, 0, _offsets.Length);
            Array.Clear(_sums, 0, _sums.Length);
            for (int i = 0; i < _gains.Length; i++)
                _gains[i] = 1;
            _frames = 0;
            Noise = 0;
            ErrorShare = 1;
            BuildCurves();
        }

        public void BeginFrame()
        {
            _looks = 0;
            Array.Clear(_errors, 0, _errors.Length);
            _error = _sum = _sumOfSquares = 0;
        }

        /// <summary>One look at one channel (0 blue, 1 green, 2 red).</summary>
        /// <param name="cell">Cell of the grid.</param>
        /// <param name="channel">Which one.</param>
        /// <param name="level">What was rendered, 0…255.</param>
        /// <param name="seen">What the camera shows there.</param>
        /// <param name="isQuiteEven">What differs from the expected there is noise.</param>
        public void Learn(int cell, int channel, int level, int seen, bool isQuiteEven)
        {
            int at = 3 * cell + channel;
            double tone = _curves[256 * channel + level];
            double expected = _gains[at] * tone + _offsets[at], error = seen - expected;
            _looks++;
            if (isQuiteEven)
                _errors[(int)Math.Min(63, 2 * Math.Abs(error))]++;
            _error += Math.Min(error * error, 60 * 60);
            _sum += seen;
            _sumOfSquares += seen * seen;
            int node = channel * Nodes + (level >> 4);
            double upper = (level & 15) / 16.0;
            bool isSure = _weights[node] * (1 - upper) + _weights[node + 1] * upper > SureWeight;

            // The curve is the screen's mean, whatever the cells say: else curve and cells could drift apart together.
            double away = seen - (_nodes[node] + upper * (_nodes[node + 1] - _nodes[node])), pull = isSure ? Math.Max(-MaxPull, Math.Min(MaxPull, away)) : away;
            Pull(node, 1 - upper, pull);
            Pull(node + 1, upper, pull);
            if (_frames < CurveFrames || !isSure)
                return;
            fixed (double* sums = &_sums[5 * at])
            {
                double value = expected + Math.Max(-MaxPull, Math.Min(MaxPull, error));
                sums[0] = CellKeep * sums[0] + 1;
                sums[1] = CellKeep * sums[1] + tone;
                sums[2] = CellKeep * sums[2] + value;
                sums[3] = CellKeep * sums[3] + tone * tone;
                sums[4] = CellKeep * sums[4] + tone * value;
            }
        }

        /// <summary>Ends a frame in which there was something to learn from.</summary>
        public void EndFrame()
        {
            if (_looks < 30)
                return;
            double mean = _sum / _looks, variance = Math.Max(144, _sumOfSquares / _looks - mean * mean);
            double follow = _frames <= CurveFrames ? 1 : 0.15;
            ErrorShare += follow * (_error / _looks / variance - ErrorShare);
            MeasureNoise();
            _frames = Math.Min(_frames + 1, 1_000_000);
            BuildCurves();
            for (int at = 0; at < 3 * ScreenGrid.CellCount && IsLearned; at++)
                FitCell(at);
        }

        /// <summary>The median error, in bins of half a level.</summary>
        private void MeasureNoise()
        {
            int count = 0;
            foreach (int errors in _errors)
                count += errors;
            if (count < 60)
                return;
            int bin = 0, below = 0;
            while (2 * (below + _errors[bin]) < count)
                below += _errors[bin++];
            double median = 0.5 * (bin + (0.5 * count - below) / _errors[bin]);
            Noise = Math.Max(0.5, median / 0.6745);
        }

        /// <summary>Tables for <see cref="ExpectationKernel.Transfer"/>, raised by this share.</summary>
        public void FillTone(byte* tone, double slack)
        {
            for (int channel = 0; channel < 3; channel++)
            {
                int last = 0;
                for (int segment = 0; segment < 16; segment++)
                {
                    double start = _curves[256 * channel + 16 * segment], end = segment < 15 ? _curves[256 * channel + 16 * segment + 16] : 2 * _curves[256 * channel + 255] - _curves[256 * channel + 239];
                    int low = Math.Max(last, CellBlend.Level(start * (1 + slack))), high = Math.Max(low, CellBlend.Level(end * (1 + slack)));
                    tone[32 * channel + segment] = (byte)low;
                    tone[32 * channel + 16 + segment] = (byte)(high - low);
                    last = high;
                }
            }
        }

        private void Pull(int node, double share, double error)
        {
            if (share <= 0)
                return;
            _weights[node] += share;
            _nodes[node] += (_weights[node] < 1 / MinRate ? 1 / _weights[node] : MinRate) * share * error;
        }

        /// <summary>Through the tones seen so far, never falling; beyond the brightest seen on in proportion, below the darkest as dark.</summary>
        private void BuildCurves()
        {
            for (int channel = 0; channel < 3; channel++)
            {
                int before = -1;
                double last = 0;
                for (int node = 0; node < Nodes; node++)
                {
                    if (_weights[channel * Nodes + node] < MinNodeWeight)
                        continue;
                    double value = Math.Max(last, _nodes[channel * Nodes + node]);
                    Line(channel, before < 0 ? 0 : 16 * before, before < 0 ? value : last, 16 * node, value);
                    before = node;
                    last = value;
                }

                double end = before < 0 ? 256 : before == 0 ? last + 256 : last * 16 / before;
                Line(channel, before < 0 ? 0 : 16 * before, last, 256, end);
            }
        }

        private void Line(int channel, int from, double start, int to, double end)
        {
            for (int level = from; level <= Math.Min(255, to); level++)
                _curves[256 * channel + level] = to == from ? end : start + (end - start) * (level - from) / (to - from);
        }

        /// <summary>Least squares, drawn towards gain 1 as long as the cell has not shown enough different tones.</summary>
        private void FitCell(int at)
        {
            double count = _sums[5 * at];
            if (count < 3)
                return;
            double tone = _sums[5 * at + 1] / count, value = _sums[5 * at + 2] / count;
            double variance = _sums[5 * at + 3] / count - tone * tone, common = _sums[5 * at + 4] / count - tone * value;
            double gain = Math.Max(0.3, Math.Min(1.9, (common + Ridge) / (variance + Ridge)));

            // Of the difference to the whole screen so much as there were looks.
            double say = count / (count + FewLooks);
            gain = 1 + say * (gain - 1);
            _gains[at] = gain;
            _offsets[at] = Math.Max(-100, Math.Min(100, tone + say * (value - tone) - gain * tone));
        }
    }
}
