using System;

namespace LaserTracking.Health
{
    /// <summary>How far a list of slopes lies displaced against an earlier one: the normalised correlation's peak.</summary>
    internal static class SlopeMatch
    {
        private const double LeastFit = 0.8;
        private const double StillFit = 0.95;

        /// <param name="now">The list.</param>
        /// <param name="then">The earlier one, as long.</param>
        /// <param name="reach">Largest displacement looked for, bins.</param>
        /// <param name="leastSlope">Mean square slope worth matching.</param>
        /// <param name="shift">Bins, with fractions.</param>
        /// <returns>False where there is too little to see or nothing fits.</returns>
        public static bool TryFind(int[] now, int[] then, int reach, long leastSlope, out double shift)
        {
            shift = 0;
            if (now.Length != then.Length)
                return false;
            int first = reach + 1, end = now.Length - reach - 1;
            long energy = Energy(then, first, end);
            if (energy < leastSlope * (end - first))
                return false;
            double best = Fit(now, then, 0, first, end, energy), before = Fit(now, then, -1, first, end, energy), after = Fit(now, then, 1, first, end, energy), last = 0;
            int at = 0;

            // Nearly always nothing has moved: then the search is spared.
            bool isAtRest = best >= StillFit && best > before && best > after;
            if (!isAtRest)
            {
                best = before = after = 0;
                at = int.MinValue;
            }

            for (int d = -reach; d <= reach && !isAtRest; d++)
            {
                double fit = Fit(now, then, d, first, end, energy);
                if (at == d - 1)
                    after = fit;
                if (fit > best)
                {
                    best = fit;
                    before = last;
                    after = 0;
                    at = d;
                }

                last = fit;
            }

            if (best < LeastFit || at == -reach || at == reach)
                return false;
            double bend = before - 2 * best + after;
            shift = at + (bend < 0 ? 0.5 * (before - after) / bend : 0);
            return true;
        }

        /// <summary>Whether a list has enough slope to be found again.</summary>
        public static bool IsWorth(int[] then, int reach, long leastSlope)
        {
            int first = reach + 1, end = then.Length - reach - 1;
            return Energy(then, first, end) >= leastSlope * (end - first);
        }

        private static long Energy(int[] then, int first, int end)
        {
            long energy = 0;
            for (int i = first; i < end; i++)
                energy += (long)then[i] * then[i];
            return energy;
        }

        private static double Fit(int[] now, int[] then, int d, int first, int end, long energy)
        {
            long product = 0, square = 0;
            for (int i = first; i < end; i++)
            {
                int value = now[i + d];
                product += (long)value * then[i];
                square += (long)value * value;
            }

            return square == 0 ? 0 : product / Math.Sqrt((double)square * energy);
        }
    }
}
