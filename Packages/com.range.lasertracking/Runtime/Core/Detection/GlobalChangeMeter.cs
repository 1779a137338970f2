using System;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>
    /// What happened to the whole picture at once: the camera was moved by a few pixels, or its exposure changed. Measured on patches
    /// spread over the picture: displacement by the sums along their rows and columns against remembered ones, believed when most patches
    /// agree; brightness by the ratio to the last frame, believed when most pixels agree: things that move in the picture have no say.
    /// </summary>
    internal sealed unsafe class GlobalChangeMeter
    {
        private const int Patches = PatchBands.Count, Size = PatchKernel.Size, Window = PatchKernel.Window;

        /// <summary>Displacements below this are the measurement's own, working px.</summary>
        private const double Rest = 0.25;

        private const double MinAgreement = 0.6;
        private const double AgreementPx = 0.4;
        private const double MinGainChange = 0.015;

        /// <summary>No exposure changes by more from one frame to the next: a flash of the screen does, and adds light instead.</summary>
        private const double SmallestGain = 0.55, LargestGain = 1.8;

        /// <summary>Share of all samples, one in so many, that must be neither dark nor clipped.</summary>
        private const int LeastUsable = 60;

        /// <summary>Frames after which a patch that does not fit any more shows something else now.</summary>
        private const int RenewAfter = 8;

        private const int UnsteadyFrames = 15;

        private readonly KernelRunner _kernels;
        private byte[] _now = new byte[Patches * PatchBands.Area];
        private byte[] _before = new byte[Patches * PatchBands.Area];
        private readonly int[] _columns = new int[Patches * Window];
        private readonly int[] _rows = new int[Patches * Window];
        private readonly float[] _columnReference = new float[Patches * Size];
        private readonly float[] _rowReference = new float[Patches * Size];
        private readonly int[] _misfits = new int[Patches];
        private readonly double[] _shiftX = new double[Patches];
        private readonly double[] _shiftY = new double[Patches];
        private readonly double[] _sorted = new double[Patches];
        private readonly int[] _ratios;
        private readonly long[] _sums;
        private readonly ulong[] _reciprocals = new ulong[256];
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

        public GlobalChangeMeter(KernelRunner kernels)
        {
            _kernels = kernels;
            _ratios = new int[256 * kernels.BandCount];
            _sums = new long[3 * kernels.BandCount];
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
            if (_width < 3 * Window || _height < 3 * Window)
                return;
            (_now, _before) = (_before, _now);
            Read(image);
            if (_frames > 0)
            {
                MeasureGain();
                Match(noise);
            }
            else
            {
                Array.Fill(_shiftX, double.NaN);
                Array.Fill(_shiftY, double.NaN);
            }

            if (_frames++ > 0)
                Decide();
            for (int patch = 0; patch < Patches; patch++)
                Learn(patch);
        }

        private void Read(Image image)
        {
            fixed (byte* now = _now)
            fixed (int* columns = _columns, rows = _rows)
            {
                var work = new PatchBands { Source = image, Width = _width, Height = _height, Factor = _factor, Patches = now, Columns = columns, Rows = rows };
                _kernels.Run(&work, Patches);
            }
        }

        private void Match(double noise)
        {
            fixed (int* columns = _columns, rows = _rows)
            fixed (float* columnReference = _columnReference, rowReference = _rowReference)
            fixed (double* shiftX = _shiftX, shiftY = _shiftY)
            {
                var work = new PatchMatchBands
                {
                    Gain = Gain,
                    Noise = noise,
                    Columns = columns,
                    Rows = rows,
                    ColumnReference = columnReference,
                    RowReference = rowReference,
                    ShiftX = shiftX,
                    ShiftY = shiftY,
                };
                _kernels.Run(&work, Patches);
            }
        }

        /// <summary>Ratios in sixty-fourths: the median, then the mean of those near it.</summary>
        private void MeasureGain()
        {
            RunRatios(-1, 0);
            int count = 0;
            for (int i = 0; i < _ratios.Length; i++)
            {
                count += _ratios[i];
                if (i >= 256)
                    _ratios[i % 256] += _ratios[i];
            }

            if (count < _now.Length / LeastUsable)
                return;
            int median = 0;
            for (int below = _ratios[0]; 2 * below < count; below += _ratios[++median])
            {
            }

            RunRatios(median, 2 + median / 20);
            long near = 0, sumNow = 0, sumBefore = 0;
            for (int i = 0; i < _sums.Length; i += 3)
            {
                near += _sums[i];
                sumNow += _sums[i + 1];
                sumBefore += _sums[i + 2];
            }

            double gain = near > MinAgreement * count ? sumNow / (double)sumBefore : 1;
            if (Math.Abs(gain - 1) > MinGainChange && gain > SmallestGain && gain < LargestGain)
                Gain = gain;
        }

        private void RunRatios(int middle, int width)
        {
            fixed (byte* now = _now, before = _before)
            fixed (ulong* reciprocals = _reciprocals)
            fixed (int* ratios = _ratios)
            fixed (long* sums = _sums)
            {
                var work = new RatioBands
                {
                    Now = now,
                    Before = before,
                    Length = _now.Length,
                    BandCount = _kernels.BandCount,
                    Middle = middle,
                    Width = width,
                    Reciprocals = reciprocals,
                    Ratios = ratios,
                    Sums = sums,
                };
                _kernels.Run(&work, work.BandCount);
            }
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
            fixed (int* columns = _columns, rows = _rows)
            {
                for (int i = 0; i < Size; i++)
                {
                    Follow(ref _columnReference[patch * Size + i], PatchKernel.Slope(columns + patch * Window, i + PatchKernel.Reach + ShiftX), follow, gain);
                    Follow(ref _rowReference[patch * Size + i], PatchKernel.Slope(rows + patch * Window, i + PatchKernel.Reach + ShiftY), follow, gain);
                }
            }
        }

        private static void Follow(ref float reference, int slope, float follow, float gain)
        {
            reference *= gain;
            reference += follow * (slope - reference);
        }
    }
}
