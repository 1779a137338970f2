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
        private const int DepthBins = 160;

        private readonly double _depthBinMm;
        private readonly int _reach;
        private readonly int[] _histogram = new int[ColumnBins * DepthBins];
        private readonly int[] _window = new int[DepthBins];
        private readonly float[] _medianZ = new float[ColumnBins];
        private readonly double[] _weight = new double[ColumnBins];
        private readonly double[] _weightedZ = new double[ColumnBins];

        public TorsoProfile(DepthHandSettings settings)
        {
            _depthBinMm = settings.FarMm / (DepthBins - 1);
            _reach = Math.Max(1, (int)Math.Round(settings.TorsoHalfWidthMm / BinMm));
        }

        /// <summary>Forgets all torsos of the frame before.</summary>
        public void Clear()
        {
            Array.Clear(_weight, 0, _weight.Length);
            Array.Clear(_weightedZ, 0, _weightedZ.Length);
        }

        /// <summary>Measures one surface, for <see cref="MedianZ"/>.</summary>
        public void Build(DepthGrid grid, ReadOnlySpan<int> cells)
        {
            int low = ColumnBins, high = -1;
            Array.Clear(_histogram, 0, _histogram.Length);
            foreach (int cell in cells)
            {
                float z = grid.Z[cell];
                int column = ColumnOf(grid.RayX[cell % grid.Width] * z);
                low = Math.Min(low, column);
                high = Math.Max(high, column);
                _histogram[column * DepthBins + (int)(z / _depthBinMm)] += 1 + (int)(z * z / 65536);
            }

            for (int column = low; column <= high; column++)
                _medianZ[column] = (float)((MedianBin(column, low, high) + 0.5) * _depthBinMm);
        }

        /// <summary>Distance of what stands at x in the surface measured last.</summary>
        public float MedianZ(double xMm) => _medianZ[ColumnOf(xMm)];

        /// <summary>Counts a cell as part of a torso.</summary>
        public void AddTorso(double xMm, float z)
        {
            int column = ColumnOf(xMm);
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

        private int MedianBin(int column, int low, int high)
        {
            Array.Clear(_window, 0, _window.Length);
            long total = 0;
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
