using System;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// The plane through most of many measured points, some of which belong to other things: least median of squares over fixed
    /// triples (Rousseeuw 1984), then total least squares on what lies near. Immutable. Fitting allocates.
    /// </summary>
    public sealed class PlaneFit
    {
        private const int Triples = 200;
        private const int Refinements = 5;

        // Median of |x| of a unit Gaussian, and how many standard deviations still belong.
        private const double MedianOfUnit = 0.6745;
        private const double NearSigmas = 3;
        private const double LeastSigma = 1e-6;

        private PlaneFit(Plane3D plane, double sigma, int near, int count)
        {
            Plane = plane;
            Sigma = sigma;
            NearCount = near;
            Count = count;
        }

        /// <summary>Its normal points away from the origin.</summary>
        public Plane3D Plane { get; }

        /// <summary>Standard deviation of the near points' distances from it.</summary>
        public double Sigma { get; }

        /// <summary>Points that belong to it.</summary>
        public int NearCount { get; }

        /// <summary>Points that were given.</summary>
        public int Count { get; }

        /// <param name="points">At least three, any unit; more than half of them on the plane.</param>
        /// <param name="fit">Valid only when true is returned.</param>
        /// <param name="reason">Why it was refused, one line; empty on success.</param>
        public static bool TryFit(ReadOnlySpan<Vector3D> points, out PlaneFit? fit, out string reason)
        {
            fit = null;
            if (points.Length < 3)
            {
                reason = FormattableString.Invariant($"{points.Length} points: a plane needs three");
                return false;
            }

            foreach (Vector3D point in points)
            {
                if (point.IsFinite)
                    continue;
                reason = "a point is not finite";
                return false;
            }

            var distances = new double[points.Length];
            if (!TryStart(points, distances, out Plane3D plane, out double sigma))
            {
                reason = "the points lie on one line and fix no plane";
                return false;
            }

            int near = 0;
            for (int i = 0; i < Refinements; i++)
            {
                if (!TryTotalLeastSquares(points, plane, NearSigmas * sigma, out plane, out near))
                {
                    reason = "the points lie on one line and fix no plane";
                    return false;
                }

                sigma = RobustSigma(points, plane, distances);
            }

            reason = string.Empty;
            fit = new PlaneFit(plane, SigmaOfNear(points, plane, NearSigmas * sigma), near, points.Length);
            return true;
        }

        private static bool TryStart(ReadOnlySpan<Vector3D> points, double[] distances, out Plane3D best, out double sigma)
        {
            best = default;
            sigma = double.PositiveInfinity;
            uint state = 12345;
            for (int i = 0; i < Triples; i++)
            {
                Vector3D a = points[Next(points.Length)], b = points[Next(points.Length)], c = points[Next(points.Length)];
                Vector3D normal = Vector3D.Cross(b - a, c - a);
                if (!(normal.Length > 1e-9 * (b - a).Length * (c - a).Length))
                    continue;
                var plane = new Plane3D(normal, a);
                double found = RobustSigma(points, plane, distances);
                if (found < sigma)
                    (best, sigma) = (plane, found);
            }

            return !double.IsInfinity(sigma);

            // A fixed sequence: the same points always give the same plane.
            int Next(int count)
            {
                state = unchecked(state * 1664525 + 1013904223);
                return (int)((ulong)state * (ulong)count >> 32);
            }
        }

        private static double RobustSigma(ReadOnlySpan<Vector3D> points, Plane3D plane, double[] distances)
        {
            for (int i = 0; i < points.Length; i++)
                distances[i] = Math.Abs(plane.SignedDistance(points[i]));
            Array.Sort(distances);
            return Math.Max(LeastSigma, distances[distances.Length / 2] / MedianOfUnit);
        }

        private static bool TryTotalLeastSquares(ReadOnlySpan<Vector3D> points, Plane3D start, double limit, out Plane3D plane, out int near)
        {
            near = 0;
            Vector3D sum = default;
            foreach (Vector3D point in points)
            {
                if (Math.Abs(start.SignedDistance(point)) > limit)
                    continue;
                sum += point;
                near++;
            }

            Vector3D center = sum * (1.0 / Math.Max(1, near));
            var scatter = new double[3, 3];
            foreach (Vector3D point in points)
            {
                if (Math.Abs(start.SignedDistance(point)) > limit)
                    continue;
                Vector3D d = point - center;
                scatter[0, 0] += d.X * d.X;
                scatter[0, 1] += d.X * d.Y;
                scatter[0, 2] += d.X * d.Z;
                scatter[1, 1] += d.Y * d.Y;
                scatter[1, 2] += d.Y * d.Z;
                scatter[2, 2] += d.Z * d.Z;
            }

            scatter[1, 0] = scatter[0, 1];
            scatter[2, 0] = scatter[0, 2];
            scatter[2, 1] = scatter[1, 2];
            SymmetricEigen.Decompose(scatter, out double[] values, out double[,] vectors);
            var normal = new Vector3D(vectors[0, 0], vectors[1, 0], vectors[2, 0]);
            plane = new Plane3D(Vector3D.Dot(normal, center) < 0 ? -normal : normal, center);
            return near >= 3 && values[1] > 1e-12 * values[2];
        }

        private static double SigmaOfNear(ReadOnlySpan<Vector3D> points, Plane3D plane, double limit)
        {
            double squares = 0;
            int count = 0;
            foreach (Vector3D point in points)
            {
                double distance = plane.SignedDistance(point);
                if (Math.Abs(distance) > limit)
                    continue;
                squares += distance * distance;
                count++;
            }

            return Math.Sqrt(squares / Math.Max(1, count - 3));
        }
    }
}
