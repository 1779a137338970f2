using System;

namespace LaserTracking.Hands
{
    /// <summary>
    /// Where the torsos are, per column of space. The distance in one surface is the median over a shoulder's width, weighted by area,
    /// so that several people who touch each other keep their own; what is not an arm is gathered over all surfaces of a frame.
    /// </summary>
    internal sealed class TorsoProfile
    {
        private const double BinMm = 50;
        private const int ColumnBins = 160;
        private const int DepthBins = 240;

        private const double SlackMm = 1500;
        private const double MinHeightMm = 400;
        private const double OutstandingMm = 100;

        /// <summary>A body shows at least so much of what the largest of its surface shows; an arm a fifteenth.</summary>
        private const double BodyShare = 0.25;

        /// <summary>A camera turned up or down by 35°.</summary>
        private const double MaxSlope = 0.7;

        private readonly double _depthBinMm;
        private readonly int _reach;
        private readonly int[] _histogram = new int[ColumnBins * DepthBins];
        private readonly int[] _window = new int[DepthBins];
        private readonly float[] _median = new float[ColumnBins];
        private readonly long[] _windowTotal = new long[ColumnBins];
        private readonly double[] _columnWeight = new double[ColumnBins];
        private readonly double[] _columnY = new double[ColumnBins];
        private readonly double[] _columnZ = new double[ColumnBins];
        private readonly double[] _columnLine = new double[ColumnBins];
        private readonly double[] _weight = new double[ColumnBins];
        private readonly double[] _weightedZ = new double[ColumnBins];
        private readonly float[] _top = new float[ColumnBins];
        private double _slope;

        public TorsoProfile(DepthHandSettings settings)
        {
            _depthBinMm = (settings.FarMm + 2 * SlackMm) / (DepthBins - 1);
            _reach = Math.Max(1, (int)Math.Round(settings.TorsoHalfWidthMm / BinMm));
        }

        /// <summary>Forgets all torsos of the frame before.</summary>
        public void Clear()
        {
            Array.Clear(_weight, 0, _weight.Length);
            Array.Clear(_weightedZ, 0, _weightedZ.Length);
            for (int column = 0; column < ColumnBins; column++)
                _top[column] = float.MaxValue;
        }

        /// <summary>Counts a cell as part of a person without counting it for where the torso is: a head that seems to float.</summary>
        public void AddTop(double xMm, double yMm)
        {
            int column = ColumnOf(xMm);
            _top[column] = Math.Min(_top[column], (float)yMm);
        }

        /// <summary>Height (y) of the crown above the torso's middle; false when nothing is seen there.</summary>
        public bool TryTop(double middleXMm, out double yMm)
        {
            int centre = ColumnOf(middleXMm);
            float top = float.MaxValue;
            for (int k = Math.Max(0, centre - 2); k <= Math.Min(ColumnBins - 1, centre + 2); k++)
                top = Math.Min(top, _top[k]);
            yMm = top;
            return top < float.MaxValue;
        }

        /// <summary>Measures one surface, for <see cref="BodyZ"/>.</summary>
        public void Build(DepthGrid grid, ReadOnlySpan<int> cells)
        {
            _slope = 0;
            MeasureSlope(grid, cells, double.MaxValue);
            // Once more without what stands out: an arm held before the chest tilts the body.
            MeasureSlope(grid, cells, OutstandingMm);
            int low = ColumnBins, high = -1;
            Array.Clear(_histogram, 0, _histogram.Length);
            foreach (int cell in cells)
            {
                float z = grid.Z[cell];
                int row = cell / grid.Width, column = ColumnOf(grid.RayX[cell - row * grid.Width] * z);
                low = Math.Min(low, column);
                high = Math.Max(high, column);
                int depth = (int)((z - _slope * grid.RayY[row] * z + SlackMm) / _depthBinMm);
                _histogram[column * DepthBins + Math.Max(0, Math.Min(DepthBins - 1, depth))] += 1 + (int)(z * z / 65536);
            }

            long most = 0;
            for (int column = low; column <= high; column++)
            {
                _median[column] = (float)((MedianBin(column, low, high, out _windowTotal[column]) + 0.5) * _depthBinMm - SlackMm);
                most = Math.Max(most, _windowTotal[column]);
            }

            FillBesideBodies(low, high, (long)(most * BodyShare));
        }

        /// <summary>Where an arm reaches out beside the body, it would be its own torso: there counts the nearest column that has one.</summary>
        private void FillBesideBodies(int low, int high, long needed)
        {
            for (int column = low; column <= high; column++)
            {
                if (_windowTotal[column] >= needed)
                    continue;
                int step = 1;
                while (!IsBody(column - step) && !IsBody(column + step))
                    step++;
                _median[column] = _median[IsBody(column - step) ? column - step : column + step];
            }

            bool IsBody(int column) => column >= low && column <= high && _windowTotal[column] >= needed;
        }

        /// <summary>Distance at which the body itself is expected at this place of the surface measured last.</summary>
        public double BodyZ(double xMm, double yMm) => _median[ColumnOf(xMm)] + _slope * yMm;

        /// <summary>
        /// How z grows downwards on a standing body: the camera is seldom level. Least squares within the columns of space, so that
        /// several people at several distances do not look like a slope.
        /// </summary>
        private void MeasureSlope(DepthGrid grid, ReadOnlySpan<int> cells, double limitMm)
        {
            bool isFirst = limitMm == double.MaxValue;
            if (!isFirst)
            {
                for (int column = 0; column < ColumnBins; column++)
                    _columnLine[column] = (_columnZ[column] - _slope * _columnY[column]) / _columnWeight[column];
            }

            Array.Clear(_columnWeight, 0, ColumnBins);
            Array.Clear(_columnY, 0, ColumnBins);
            Array.Clear(_columnZ, 0, ColumnBins);
            double yy = 0, yz = 0;
            foreach (int cell in cells)
            {
                double z = grid.Z[cell], w = z * z;
                int row = cell / grid.Width, column = ColumnOf(grid.RayX[cell - row * grid.Width] * z);
                double y = grid.RayY[row] * z;
                if (!isFirst && _columnLine[column] + _slope * y - z > limitMm)
                    continue;
                _columnWeight[column] += w;
                _columnY[column] += w * y;
                _columnZ[column] += w * z;
                yy += w * y * y;
                yz += w * y * z;
            }

            double total = 0;
            for (int column = 0; column < ColumnBins; column++)
            {
                double w = _columnWeight[column];
                if (!(w > 0))
                    continue;
                total += w;
                yy -= _columnY[column] * _columnY[column] / w;
                yz -= _columnY[column] * _columnZ[column] / w;
            }

            // Of a surface that is not high there is no telling.
            bool isHigh = yy > total * MinHeightMm * MinHeightMm / 12;
            _slope = isHigh ? Math.Max(-MaxSlope, Math.Min(MaxSlope, yz / yy)) : 0;
        }

        /// <summary>Counts a cell as part of a torso.</summary>
        public void AddTorso(double xMm, double yMm, float z)
        {
            int column = ColumnOf(xMm);
            _top[column] = Math.Min(_top[column], (float)yMm);
            _weight[column] += z * z;
            _weightedZ[column] += (double)z * z * z;
        }

        /// <summary>Middle and distance of the torso nearest to x, by three steps of mean shift over a body's width; false when there is none.</summary>
        public bool TryTorso(double xMm, out double middleXMm, out double zMm)
        {
            middleXMm = xMm;
            zMm = 0;
            for (int step = 0; step < 3; step++)
            {
                int centre = ColumnOf(middleXMm), reach = _reach + _reach / 2;
                double sum = 0, weights = 0, sumZ = 0;
                for (int k = Math.Max(0, centre - reach); k <= Math.Min(ColumnBins - 1, centre + reach); k++)
                {
                    sum += _weight[k] * ((k - ColumnBins / 2 + 0.5) * BinMm);
                    weights += _weight[k];
                    sumZ += _weightedZ[k];
                }

                if (!(weights > 0))
                    return step > 0;
                middleXMm = sum / weights;
                zMm = sumZ / weights;
            }

            return true;
        }

        private int MedianBin(int column, int low, int high, out long total)
        {
            Array.Clear(_window, 0, _window.Length);
            total = 0;
            for (int k = Math.Max(low, column - _reach); k <= Math.Min(high, column + _reach); k++)
            {
                for (int d = 0; d < DepthBins; d++)
                {
                    _window[d] += _histogram[k * DepthBins + d];
                    total += _histogram[k * DepthBins + d];
                }
            }

            long sum = 0;
            int median = 0;
            while (median < DepthBins - 1 && (sum += _window[median]) * 2 < total)
                median++;
            return median;
        }

        private static int ColumnOf(double xMm)
        {
            int column = (int)Math.Floor(xMm / BinMm) + ColumnBins / 2;
            return column < 0 ? 0 : column >= ColumnBins ? ColumnBins - 1 : column;
        }
    }
}
