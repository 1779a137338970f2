using System;
using System.Collections.Generic;
using System.Globalization;
using System.Linq;

namespace LaserTracking.Host.Studies.Evidence
{
    /// <summary>Where each feature's steps may lie: at quantiles, rounded to the four digits that are written.</summary>
    internal sealed class FeatureBins
    {
        private readonly float[][] _edges;

        private FeatureBins(float[][] edges) => _edges = edges;

        public int FeatureCount => _edges.Length;

        /// <param name="samples">A row of features each; none is NaN.</param>
        /// <param name="bins">At most so many for each feature.</param>
        public static FeatureBins Of(IReadOnlyList<float[]> samples, int bins)
        {
            var edges = new float[samples[0].Length][];
            for (int feature = 0; feature < edges.Length; feature++)
            {
                float[] sorted = samples.Select(s => s[feature]).ToArray();
                Array.Sort(sorted);
                edges[feature] = Enumerable.Range(1, bins - 1).Select(i => Rounded(Quantile(sorted, i / (double)bins))).Distinct().ToArray();
            }

            return new FeatureBins(edges);
        }

        /// <summary>Rising; a value at or above an edge lies beyond it.</summary>
        public float[] EdgesOf(int feature) => _edges[feature];

        /// <summary>The bin of each sample's value of one feature.</summary>
        public byte[] Digitize(IReadOnlyList<float[]> samples, int feature)
        {
            var bins = new byte[samples.Count];
            for (int i = 0; i < bins.Length; i++)
                bins[i] = (byte)Bin(feature, samples[i][feature]);
            return bins;
        }

        private int Bin(int feature, float value)
        {
            int bin = 0;
            foreach (float edge in _edges[feature])
                bin += value >= edge ? 1 : 0;
            return bin;
        }

        /// <summary>Between the two samples beside it in proportion.</summary>
        private static double Quantile(float[] sorted, double share)
        {
            double at = share * (sorted.Length - 1);
            int below = (int)at, above = Math.Min(below + 1, sorted.Length - 1);
            return sorted[below] + (at - below) * (sorted[above] - (double)sorted[below]);
        }

        private static float Rounded(double value) => float.Parse(value.ToString("G4", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
    }
}
