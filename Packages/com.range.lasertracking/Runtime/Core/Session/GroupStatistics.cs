using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Session
{
    /// <summary>
    /// The usual measures of a group of hits in a target's plane, in the unit of the points. Standard deviations divide by n − 1;
    /// radii are taken about the group's own centre.
    /// </summary>
    public readonly struct GroupStatistics
    {
        private GroupStatistics(int count, Vector2D center, Vector2D deviation, double meanRadius, double medianRadius, double extremeSpread)
        {
            Count = count;
            Center = center;
            StandardDeviation = deviation;
            MeanRadius = meanRadius;
            MedianRadius = medianRadius;
            ExtremeSpread = extremeSpread;
        }

        public int Count { get; }

        /// <summary>Mean of the points.</summary>
        public Vector2D Center { get; }

        /// <summary>Horizontal and vertical; zero for fewer than two points.</summary>
        public Vector2D StandardDeviation { get; }

        /// <summary>Mean distance from the centre.</summary>
        public double MeanRadius { get; }

        /// <summary>Radius about the centre that holds half of the points (the group's own CEP50).</summary>
        public double MedianRadius { get; }

        /// <summary>Largest distance between two points.</summary>
        public double ExtremeSpread { get; }

        /// <summary>Statistics of any number of points; all zero for none.</summary>
        public static GroupStatistics Of(IReadOnlyList<Vector2D> points)
        {
            int n = points.Count;
            if (n == 0)
                return default;
            Vector2D sum = default;
            foreach (Vector2D point in points)
                sum += point;
            Vector2D center = sum * (1.0 / n);
            var radii = new double[n];
            double xx = 0, yy = 0, radiusSum = 0, spreadSquared = 0;
            for (int i = 0; i < n; i++)
            {
                Vector2D d = points[i] - center;
                xx += d.X * d.X;
                yy += d.Y * d.Y;
                radii[i] = d.Length;
                radiusSum += radii[i];
                for (int j = 0; j < i; j++)
                    spreadSquared = Math.Max(spreadSquared, (points[i] - points[j]).LengthSquared);
            }

            Array.Sort(radii);
            double median = (radii[(n - 1) / 2] + radii[n / 2]) / 2;
            var deviation = n > 1 ? new Vector2D(Math.Sqrt(xx / (n - 1)), Math.Sqrt(yy / (n - 1))) : default;
            return new GroupStatistics(n, center, deviation, radiusSum / n, median, Math.Sqrt(spreadSquared));
        }
    }
}
