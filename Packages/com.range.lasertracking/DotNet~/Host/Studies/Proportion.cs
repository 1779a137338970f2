using System;

namespace LaserTracking.Host.Studies
{
    /// <summary>So many of so many, with the interval that holds the true share with 95 % (Wilson's score interval, 1927).</summary>
    internal readonly record struct Proportion(int Count, int Of)
    {
        private const double Z = 1.959963984540054;

        /// <summary>NaN when there is nothing.</summary>
        public double Share => Of == 0 ? double.NaN : Count / (double)Of;

        public double Low => Of == 0 ? 0 : Math.Max(0, Middle - HalfWidth);

        public double High => Of == 0 ? 1 : Math.Min(1, Middle + HalfWidth);

        private double Middle => (Share + Z * Z / (2.0 * Of)) / (1 + Z * Z / Of);

        private double HalfWidth => Z / (1 + Z * Z / Of) * Math.Sqrt(Share * (1 - Share) / Of + Z * Z / (4.0 * Of * Of));

        public override string ToString() => Of == 0
            ? "–"
            : FormattableString.Invariant($"{Count} of {Of}, {100 * Share:F1} % ({100 * Low:F1}–{100 * High:F1})");
    }
}
