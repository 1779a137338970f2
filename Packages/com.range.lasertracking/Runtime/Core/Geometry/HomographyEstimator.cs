using System;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// Fits a homography to point pairs by the direct linear transform on normalised points (Hartley 1997). Refuses what has no
    /// trustworthy answer and says why. <see cref="HomographyFit"/> refines it. For set-up, not for the frame loop: it allocates.
    /// </summary>
    public static class HomographyEstimator
    {
        private const double MinimumRelativeArea = 1e-6;
        private const double MinimumRelativeEigenvalue = 1e-12;

        /// <summary>The mapping that takes from[i] to to[i], exact for four points, least algebraic error for more.</summary>
        /// <param name="from">At least four points, any unit.</param>
        /// <param name="to">As many, any unit.</param>
        /// <param name="homography">Valid only when true is returned.</param>
        /// <param name="reason">Why it was refused, one line; empty on success.</param>
        public static bool TryFit(ReadOnlySpan<Vector2D> from, ReadOnlySpan<Vector2D> to, out Homography homography, out string reason)
        {
            homography = Homography.Identity;
            if (!CheckPoints(from, to, out reason))
                return false;

            PointNormalization fromScale = PointNormalization.Of(from), toScale = PointNormalization.Of(to);
            double[,] normal = NormalMatrix(from, fromScale, to, toScale);
            SymmetricEigen.Decompose(normal, out double[] values, out double[,] vectors);
            if (values[1] <= MinimumRelativeEigenvalue * values[8])
            {
                reason = "the points do not fix the mapping: too many of them lie on one line";
                return false;
            }

            var h = new double[9];
            for (int i = 0; i < 9; i++)
                h[i] = vectors[i, 0];
            Homography normalized;
            try
            {
                normalized = new Homography(h);
                if (Math.Abs(normalized.Determinant) < 1e-12)
                {
                    reason = "the points give a mapping that folds the plane into a line";
                    return false;
                }
            }
            catch (ArgumentException)
            {
                reason = "the points give a mapping without an inverse";
                return false;
            }

            homography = toScale.Matrix.Inverse * normalized * fromScale.Matrix;
            return CheckHorizon(homography, from, out reason);
        }

        private static bool CheckPoints(ReadOnlySpan<Vector2D> from, ReadOnlySpan<Vector2D> to, out string reason)
        {
            reason = string.Empty;
            if (from.Length != to.Length)
                reason = FormattableString.Invariant($"{from.Length} points against {to.Length}: every point needs its partner");
            else if (from.Length < 4)
                reason = FormattableString.Invariant($"{from.Length} points: a homography needs at least four");
            for (int i = 0; i < from.Length && reason.Length == 0; i++)
            {
                if (!from[i].IsFinite || !to[i].IsFinite)
                    reason = FormattableString.Invariant($"point {i + 1} is not finite");
            }

            if (reason.Length == 0 && from.Length == 4)
                return CheckFour(from, out reason) && CheckFour(to, out reason);
            return reason.Length == 0;
        }

        /// <summary>With four points, three on one line (or two in one place) leave the mapping undetermined.</summary>
        private static bool CheckFour(ReadOnlySpan<Vector2D> points, out string reason)
        {
            double extent = 0;
            for (int i = 1; i < 4; i++)
                extent = Math.Max(extent, (points[i] - points[0]).LengthSquared);
            for (int i = 0; i < 4; i++)
            {
                for (int j = i + 1; j < 4; j++)
                {
                    if (!((points[i] - points[j]).LengthSquared > MinimumRelativeArea * MinimumRelativeArea * extent))
                    {
                        reason = FormattableString.Invariant($"corners {i + 1} and {j + 1} lie in one place");
                        return false;
                    }

                    for (int k = j + 1; k < 4; k++)
                    {
                        double area = Math.Abs(Vector2D.Cross(points[j] - points[i], points[k] - points[i]));
                        if (!(area > MinimumRelativeArea * extent))
                        {
                            reason = FormattableString.Invariant($"corners {i + 1}, {j + 1} and {k + 1} lie on one line");
                            return false;
                        }
                    }
                }
            }

            reason = string.Empty;
            return true;
        }

        /// <summary>All points must lie on one side of the horizon: otherwise the quad is folded, its corners are out of order.</summary>
        private static bool CheckHorizon(Homography homography, ReadOnlySpan<Vector2D> from, out string reason)
        {
            double[] m = homography.ToArray();
            int positive = 0;
            foreach (Vector2D p in from)
                positive += m[6] * p.X + m[7] * p.Y + m[8] > 0 ? 1 : 0;
            reason = positive == 0 || positive == from.Length ? string.Empty
                : from.Length > 4 ? "the points cross: they do not come in one order on both sides, or some are far off"
                : "the corners cross: give them in order around the screen (top-left, top-right, bottom-right, bottom-left)";
            return reason.Length == 0;
        }

        private static double[,] NormalMatrix(ReadOnlySpan<Vector2D> from, PointNormalization fromScale, ReadOnlySpan<Vector2D> to, PointNormalization toScale)
        {
            var normal = new double[9, 9];
            var row = new double[9];
            for (int i = 0; i < from.Length; i++)
            {
                Vector2D p = fromScale.Apply(from[i]), q = toScale.Apply(to[i]);
                for (int equation = 0; equation < 2; equation++)
                {
                    double target = equation == 0 ? q.X : q.Y;
                    Array.Clear(row, 0, 9);
                    row[equation * 3] = p.X;
                    row[equation * 3 + 1] = p.Y;
                    row[equation * 3 + 2] = 1;
                    row[6] = -target * p.X;
                    row[7] = -target * p.Y;
                    row[8] = -target;
                    for (int r = 0; r < 9; r++)
                    for (int c = 0; c < 9; c++)
                        normal[r, c] += row[r] * row[c];
                }
            }

            return normal;
        }
    }
}
