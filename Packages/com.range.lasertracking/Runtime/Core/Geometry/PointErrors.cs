using System;

namespace LaserTracking.Geometry
{
    /// <summary>How far mapped points lie from where they should, over a set of points. All zero for an empty set.</summary>
    public readonly struct PointErrors
    {
        private PointErrors(int count, double rms, double median, double p95, double max)
        {
            Count = count;
            Rms = rms;
            Median = median;
            P95 = p95;
            Max = max;
        }

        public int Count { get; }

        public double Rms { get; }

        public double Median { get; }

        public double P95 { get; }

        public double Max { get; }

        /// <summary>Distances between the homography's image of from[i] and to[i], times a factor (1000 turns m into mm).</summary>
        public static PointErrors Of(Homography homography, ReadOnlySpan<Vector2D> from, ReadOnlySpan<Vector2D> to, double factor)
        {
            if (from.Length == 0)
                return default;
            var errors = new double[from.Length];
            for (int i = 0; i < errors.Length; i++)
                errors[i] = (homography.Map(from[i]) - to[i]).Length * factor;

            return Of(errors);
        }

        /// <summary>Of distances; sorts them.</summary>
        public static PointErrors Of(double[] errors)
        {
            if (errors.Length == 0)
                return default;
            double squares = 0;
            foreach (double error in errors)
                squares += error * error;
            Array.Sort(errors);
            int last = errors.Length - 1;
            double median = (errors[last / 2] + errors[(last + 1) / 2]) / 2;
            return new PointErrors(errors.Length, Math.Sqrt(squares / errors.Length), median, errors[(int)Math.Ceiling(0.95 * last)], errors[last]);
        }
    }
}
