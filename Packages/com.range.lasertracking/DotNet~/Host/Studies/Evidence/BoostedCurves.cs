using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Detection;

namespace LaserTracking.Host.Studies.Evidence
{
    /// <summary>A generalised additive logistic model of step functions: log-odds are a base and one value for each feature.</summary>
    internal sealed class BoostedCurves
    {
        /// <summary>Steps smaller than this are none.</summary>
        private const double LeastStep = 1e-6;

        /// <summary>
        /// No measure says more for a dot: where one errs (the picture's brightest lags behind an exposure step) the others outvote it.
        /// Taken off after learning: a curve held while it is learned lets the others shrink beside it.
        /// </summary>
        private const double MostLogOdds = 3;

        /// <param name="baseLogOdds">Before anything is measured.</param>
        /// <param name="edges">Each feature's, rising.</param>
        /// <param name="values">Each feature's values below, between and above its edges.</param>
        public BoostedCurves(double baseLogOdds, float[][] edges, double[][] values)
        {
            Base = baseLogOdds;
            Edges = new float[edges.Length][];
            Values = new double[edges.Length][];
            for (int feature = 0; feature < edges.Length; feature++)
                Join(edges[feature], values[feature].Select(v => Math.Min(v, MostLogOdds)).ToArray(), out Edges[feature], out Values[feature]);
        }

        public double Base { get; }

        /// <summary>Each feature's edges at which its value changes.</summary>
        public float[][] Edges { get; }

        /// <summary>One more for each feature than edges.</summary>
        public double[][] Values { get; }

        public double LogOdds(ReadOnlySpan<float> features)
        {
            double sum = Base;
            for (int feature = 0; feature < features.Length; feature++)
            {
                int step = 0;
                while (step < Edges[feature].Length && features[feature] >= Edges[feature][step])
                    step++;
                sum += Values[feature][step];
            }

            return sum;
        }

        /// <summary>For a detector to weigh candidates by.</summary>
        /// <param name="measures">What each feature is called and is a reason for.</param>
        public DotEvidence ToEvidence(TestOutcome[] measures) =>
            new(Base, measures.Select((m, i) => new EvidenceCurve(m.What, m.Reason, Edges[i], Values[i].Select(v => (float)v).ToArray())).ToArray());

        private static void Join(float[] edges, double[] values, out float[] joinedEdges, out double[] joinedValues)
        {
            var keptEdges = new List<float>();
            var keptValues = new List<double> { values[0] };
            for (int i = 0; i < edges.Length; i++)
            {
                if (Math.Abs(values[i + 1] - keptValues[^1]) <= LeastStep)
                    continue;
                keptEdges.Add(edges[i]);
                keptValues.Add(values[i + 1]);
            }

            joinedEdges = keptEdges.ToArray();
            joinedValues = keptValues.ToArray();
        }
    }
}
