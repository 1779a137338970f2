using System;

namespace LaserTracking.Calibration
{
    /// <summary>Finds the view that does not belong with the others: blurred, moved during the exposure, or badly found corners.</summary>
    internal static class OutlierViews
    {
        // Real sets spread: the worst of 27 good views of a wide lens lies at 2.3 times the median, 5 spreads above it.
        private const double MedianFactor = 3;
        private const double SpreadFactor = 7;
        private const double NegligiblePx = 0.05;
        private const int Fewest = 5;

        /// <summary>Index of the worst view when it is an outlier, else −1. Never with fewer than five views: no majority to judge by.</summary>
        /// <param name="rmsPx">Root mean square distance of each view.</param>
        /// <param name="medianPx">What is usual among them.</param>
        public static int Find(double[] rmsPx, out double medianPx)
        {
            medianPx = Median(rmsPx);
            if (rmsPx.Length < Fewest)
                return -1;
            int worst = 0;
            var deviations = new double[rmsPx.Length];
            for (int i = 0; i < rmsPx.Length; i++)
            {
                deviations[i] = Math.Abs(rmsPx[i] - medianPx);
                worst = rmsPx[i] > rmsPx[worst] ? i : worst;
            }

            // The median deviation is 0.674 standard deviations of a normal distribution.
            double spread = Median(deviations) / 0.674;
            double limit = Math.Max(NegligiblePx, Math.Max(MedianFactor * medianPx, medianPx + SpreadFactor * spread));
            return rmsPx[worst] > limit ? worst : -1;
        }

        private static double Median(double[] values)
        {
            var sorted = (double[])values.Clone();
            Array.Sort(sorted);
            return sorted.Length == 0 ? 0 : (sorted[(sorted.Length - 1) / 2] + sorted[sorted.Length / 2]) / 2;
        }
    }
}
