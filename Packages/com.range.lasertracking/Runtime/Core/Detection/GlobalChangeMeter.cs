using System;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    /// <summary>
    /// What happened to the whole picture at once: the camera was moved by a few pixels, or its exposure changed. Measured on patches
    /// spread over the picture: displacement by the sums along their rows and columns against remembered ones, believed when most patches
    /// agree; brightness by the ratio to the last frame, believed when most pixels agree: things that move in the picture have no say.
    /// </summary>
    internal sealed unsafe class GlobalChangeMeter
    {
        private const int Across = 6, Down = 4, Patches = Across * Down;
        private const int Size = 32, Search = 5, Reach = Search + 1, Window = Size + 2 * Reach;
        private const int SampleStep = 3;

        /// <summary>Displacements below this are the measurement's own, working px.</summary>
        private const double Rest = 0.25;

        private const double MinAgreement = 0.6;
        private const double AgreementPx = 0.4;
        private const double MinGainChange = 0.015;

        /// <summary>No exposure changes by more from one frame to the next: a flash of the screen does, and adds light instead.</summary>
        private const double SmallestGain = 0.55, LargestGain = 1.8;
        private const int DarkestForRatio = 24, BrightestForRatio = 245;

        /// <summary>Frames after which a patch that does not fit any more shows something else now.</summary>
        private const int RenewAfter = 8;

        private const int UnsteadyFrames = 15;

        private byte[] _now = new byte[Patches * Window * Window];
        private byte[] _before = new byte[Patches * Window * Window];
        private readonly int[] _columns = new int[Patches * Window];
        private readonly int[] _rows = new int[Patches * Window];
        private readonly float[] _columnReference = new float[Patches * Size];
        private readonly float[] _rowReference = new float[Patches * Size];
        private readonly int[] _misfits = new int[Patches];
        private readonly double[] _shiftX = new double[Patches];
        private readonly double[] _shiftY = new double[Patches];
        private readonly double[] _sorted = new double[Patches];
        private readonly int[] _ratios = new int[256];
        private readonly double[] _slopes = new double[Size + 2 * Search];
        private readonly double[] _expected = new double[Size];
        private readonly ulong[] _reciprocals = new ulong[256];
        private double _noise;
        private int _width, _height, _factor, _frames, _steadyFrames;

        /// <summary>The picture's content lies this much further right than it used to, whole working px.</summary>
        public int ShiftX { get; private set; }

        /// <summary>The same downwards.</summary>
        public int ShiftY { get; private set; }

        /// <summary>The camera rests neither where it used to be nor whole pixels beside: edges do not meet their own past.</summary>
        public bool IsBetweenPixels { get; private set; }

        /// <summary>The camera has moved lately: what is seen flickers at every edge.</summary>
        public bool IsUnsteady => _steadyFrames < UnsteadyFrames;

        /// <summary>Brightness through that of the last frame; exactly 1 while it does not change as a whole.</summary>
        public double Gain { get; private set; } = 1;

        public GlobalChangeMeter()
        {
            // Rounded up, a product's upper half is the exact quotient of what is far below 2^32.
            for (int divisor = 1; divisor < 256; divisor++)
                _reciprocals[divisor] = ((1UL << 32) + (ulong)divisor - 1) / (ulong)divisor;
        }

        public void Reset(int workingWidth, int workingHeight, int factor)
        {
            _width = workingWidth;
            _height = workingHeight;
            _factor = factor;
            _frames = 0;
            _steadyFrames = UnsteadyFrames;
            ShiftX = ShiftY = 0;
            IsBetweenPixels = false;
            Gain = 1;
        }

        /// <summary>In place of <see cref="Measure"/>: the camera is where it was at first, and as bright as in the last frame.</summary>
        public void Hold()
        {
            Gain = 1;
            ShiftX = ShiftY = 0;
            IsBetweenPixels = false;
            _steadyFrames++;
        }

        public void Measure(Image image, double noise)
        {
            Gain = 1;
            IsBetweenPixels = false;
            _steadyFrames++;
            _noise = noise;
            if (_width < 3 * Window || _height < 3 * Window)
                return;
            (_now, _before) = (_before, _now);
            for (int patch = 0; patch < Patches; patch++)
                Read(image, patch);
            if (_frames > 0)
                MeasureGain();
            for (int patch = 0; patch < Patches; patch++)
            {
                SumUp(patch);
                _shiftX[patch] = _frames == 0 ? double.NaN : Match(_columns, patch * Window, _columnReference, patch * Size);
                _shiftY[patch] = _frames == 0 ? double.NaN : Match(_rows, patch * Window, _rowReference, patch * Size);
            }

            if (_frames++ > 0)
                Decide();
            for (int patch = 0; patch < Patches; patch++)
                Learn(patch);
        }

        private int LeftOf(int patch) => (_width - Window) * (2 * (patch % Across) + 1) / (2 * Across);

        private int TopOf(int patch) => (_height - Window) * (2 * (patch / Across) + 1) / (2 * Down);

        /// <summary>The patch in working size: green or luma, straight from the raw picture; the mean of two where one stands for two.</summary>
        private void Read(Image image, int patch)
        {
            int target = patch * Window * Window, left = LeftOf(patch) * _factor, top = TopOf(patch) * _factor;
            int bytes = image.Format == PixelFormat.Bgra32 ? 4 : image.Format == PixelFormat.Yuy2 ? 2 : 1, offset = image.Format == PixelFormat.Bgra32 ? 1 : 0;
            fixed (byte* now = _now)
            {
                for (int y = 0; y < Window; y++)
                {
                    // Patches end a twelfth of the free width before the border: no pixel beyond an odd width is read.
                    byte* row = image.Pixels + Math.Min(image.Height - 1, top + y * _factor) * (long)image.Stride + left * bytes + offset;
                    byte* line = now + target + y * Window;
                    if (_factor == 1)
                    {
                        for (int x = 0; x < Window; x++)
                            line[x] = row[x * bytes];
                    }
                    else
                    {
                        for (int x = 0; x < Window; x++)
                            line[x] = (byte)(row[2 * x * bytes] + row[(2 * x + 1) * bytes] + 1 >> 1);
                    }
                }
            }
        }

        private void MeasureGain()
        {
            // Ratios in sixty-fourths: the median, then the mean of those near it.
            Array.Clear(_ratios, 0, _ratios.Length);
            int count = 0;
            for (int i = 0; i < _now.Length; i += SampleStep)
            {
                int now = _now[i], before = _before[i];
                if (before < DarkestForRatio || before > BrightestForRatio || now > BrightestForRatio)
                    continue;
                _ratios[Math.Min(255, (int)((ulong)(64 * now + before / 2) * _reciprocals[before] >> 32))]++;
                count++;
            }

            if (count < _now.Length / SampleStep / 20)
                return;
            int median = 0;
            for (int below = _ratios[0]; 2 * below < count; below += _ratios[++median])
            {
            }

            int width = 2 + median / 20, near = 0;
            long sumNow = 0, sumBefore = 0;
            for (int i = 0; i < _now.Length; i += SampleStep)
            {
                int now = _now[i], before = _before[i];
                if (before < DarkestForRatio || before > BrightestForRatio || now > BrightestForRatio || Math.Abs(64 * now - median * before) > width * before)
                    continue;
                near++;
                sumNow += now;
                sumBefore += before;
            }

            double gain = near > MinAgreement * count ? sumNow / (double)sumBefore : 1;
            if (Math.Abs(gain - 1) > MinGainChange && gain > SmallestGain && gain < LargestGain)
                Gain = gain;
        }

        private void SumUp(int patch)
        {
            int first = patch * Window;
            Array.Clear(_columns, first, Window);
            fixed (byte* now = _now)
            fixed (int* columns = _columns)
            {
                for (int y = 0; y < Window; y++)
                {
                    byte* row = now + (first + y) * Window;
                    int sum = 0;
                    for (int x = Reach; x < Reach + Size; x++)
                        sum += row[x];
                    _rows[first + y] = sum;
                    if (y < Reach || y >= Reach + Size)
                        continue;
                    for (int x = 0; x < Window; x++)
                        columns[first + x] += row[x];
                }
            }
        }

        /// <summary>Displacement of the sums' slopes against the remembered ones, with fractions; NaN: nothing to hold on to.</summary>
        private double Match(int[] sums, int first, float[] reference, int offset)
        {
            double best = double.PositiveInfinity, before = 0, after = 0, last = 0, sum = 0;
            int bestShift = 0;
            for (int i = 0; i < _slopes.Length; i++)
                _slopes[i] = Slope(sums, first + Reach - Search + i);
            for (int i = 0; i < Size; i++)
                _expected[i] = reference[offset + i] * Gain;
            for (int shift = -Search; shift <= Search; shift++)
            {
                double difference = 0;
                ReadOnlySpan<double> slopes = _slopes.AsSpan(Search + shift, Size), expected = _expected.AsSpan(0, Size);
                for (int i = 0; i < expected.Length && i < slopes.Length; i++)
                    difference += Math.Abs(slopes[i] - expected[i]);

                sum += difference;
                if (difference < best)
                {
                    best = difference;
                    bestShift = shift;
                    before = last;
                    after = double.NaN;
                }
                else if (shift == bestShift + 1)
                {
                    after = difference;
                }

                last = difference;
            }

            // Slopes must stand out of the noise; a clear minimum stands well below the average.
            double average = sum / (2 * Search + 1);
            if (average < Size * (6 + 10 * _noise) || best > 0.45 * average || bestShift == -Search || bestShift == Search)
                return double.NaN;
            double denominator = 2 * (Math.Max(before, after) - best);
            return bestShift + (denominator > 0 ? (before - after) / denominator : 0);
        }

        private void Decide()
        {
            bool isXKnown = TryAgree(_shiftX, out double x), isYKnown = TryAgree(_shiftY, out double y);
            if (!isXKnown && !isYKnown)
                return;
            if (!isXKnown)
                x = 0;
            if (!isYKnown)
                y = 0;
            if (Math.Abs(x) < Rest)
                x = 0;
            if (Math.Abs(y) < Rest)
                y = 0;
            int shiftX = (int)Math.Round(x), shiftY = (int)Math.Round(y);
            IsBetweenPixels = Math.Abs(x - shiftX) > Rest / 2 || Math.Abs(y - shiftY) > Rest / 2;
            if (shiftX != ShiftX || shiftY != ShiftY || IsBetweenPixels)
                _steadyFrames = 0;
            ShiftX = shiftX;
            ShiftY = shiftY;
        }

        private bool TryAgree(double[] shifts, out double median)
        {
            int count = 0;
            foreach (double shift in shifts)
            {
                if (!double.IsNaN(shift))
                    _sorted[count++] = shift;
            }

            median = 0;
            if (count < 3)
                return false;
            Array.Sort(_sorted, 0, count);
            median = _sorted[count / 2];
            int agree = 0;
            for (int i = 0; i < count; i++)
            {
                if (Math.Abs(_sorted[i] - median) <= AgreementPx)
                    agree++;
            }

            return agree >= MinAgreement * count;
        }

        /// <summary>The reference follows slowly, in its own place; what has not fitted for a while is replaced.</summary>
        private void Learn(int patch)
        {
            bool fits = Math.Abs(_shiftX[patch] - ShiftX) <= 1 || Math.Abs(_shiftY[patch] - ShiftY) <= 1;
            _misfits[patch] = fits ? 0 : _misfits[patch] + 1;
            bool isRenewed = _frames == 1 || _misfits[patch] > RenewAfter;
            if (isRenewed)
                _misfits[patch] = 0;
            float follow = isRenewed ? 1 : 0.1f, gain = (float)Gain;
            for (int i = 0; i < Size; i++)
            {
                Follow(ref _columnReference[patch * Size + i], Slope(_columns, patch * Window + i + Reach + ShiftX), follow, gain);
                Follow(ref _rowReference[patch * Size + i], Slope(_rows, patch * Window + i + Reach + ShiftY), follow, gain);
            }
        }

        // Reach leaves a place on either side of the outermost displacement.
        private static int Slope(int[] sums, int at) => sums[at + 1] - sums[at - 1];

        private static void Follow(ref float reference, int slope, float follow, float gain)
        {
            reference *= gain;
            reference += follow * (slope - reference);
        }
    }
}
