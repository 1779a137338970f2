using System;

namespace LaserTracking.Hands
{
    /// <summary>
    /// How far away the torsos in one connected surface are, per column of space: the median over a shoulder's width, weighted by
    /// surface. Several people who touch each other keep their own distances.
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
        private readonly float[] _torsoZ = new float[ColumnBins];
        private readonly double[] _torsoWeight = new double[ColumnBins];

        public TorsoProfile(DepthHandSettings settings)
        {
            _depthBinMm = settings.FarMm / (DepthBins - 1);
            _reach = Math.Max(1, (int)Math.Round(settings.TorsoHalfWidthMm / BinMm));
        }

        public void Build(DepthGrid grid, ReadOnlySpan<int> cells)
        {
            int low = ColumnBins, high = -1;
            Array.Clear(_histogram, 0, _histogram.Length);
            Array.Clear(_torsoWeight, 0, _torsoWeight.Length);
            foreach (int cell in cells)
            {
                float z = grid.Z[cell];
                int column = ColumnOf(grid.RayX[cell % grid.Width] * z);
                low = Math.Min(low, column);
                high = Math.Max(high, column);
                _histogram[column * DepthBins + (int)(z / _depthBinMm)] += 1 + (int)(z * z / 65536);
            }

            for (int column = low; column <= high; column++)
                _torsoZ[column] = (float)((MedianBin(column, low, high) + 0.5) * _depthBinMm);
        }

        public float TorsoZ(double xMm) => _torsoZ[ColumnOf(xMm)];

        /// <summary>Counts a cell as part of the torso, for <see cref="MiddleXMm"/>.</summary>
        public void AddTorso(double xMm, float z) => _torsoWeight[ColumnOf(xMm)] += z * z;

        /// <summary>Middle of the torso nearest to x: three steps of mean shift over a body's width.</summary>
        public double MiddleXMm(double xMm)
        {
            double middle = xMm;
            for (int step = 0; step < 3; step++)
            {
                int centre = ColumnOf(middle), reach = _reach + _reach / 2;
                double sum = 0, weights = 0;
                for (int k = Math.Max(0, centre - reach); k <= Math.Min(ColumnBins - 1, centre + reach); k++)
                {
                    sum += _torsoWeight[k] * ((k - ColumnBins / 2 + 0.5) * BinMm);
                    weights += _torsoWeight[k];
                }

                if (!(weights > 0))
                    return middle;
                middle = sum / weights;
            }

            return middle;
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
