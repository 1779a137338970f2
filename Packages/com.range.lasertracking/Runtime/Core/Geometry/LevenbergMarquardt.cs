using System;

namespace LaserTracking.Geometry
{
    /// <summary>
    /// Least squares of a few parameters (Levenberg 1944, Marquardt 1963), the damping scaled by the diagonal and led by the gain
    /// (Nielsen 1999). Runs on until nothing improves: stopping early is what makes programs disagree. Allocates.
    /// </summary>
    internal static class LevenbergMarquardt
    {
        private const int MaxSteps = 200;

        /// <summary>Fills the residuals and, unless null, their derivatives (a row a residual); false where the model has no value.</summary>
        public delegate bool Model(double[] parameters, double[] residuals, double[,]? derivatives);

        /// <summary>Improves the parameters in place.</summary>
        /// <param name="model">What to fit.</param>
        /// <param name="parameters">The start, then the result.</param>
        /// <param name="residualCount">At least as many as parameters.</param>
        /// <param name="squares">The least sum of squared residuals.</param>
        /// <param name="inverseNormal">(JᵀJ)⁻¹ there: times the residuals' variance it is the parameters' covariance.</param>
        /// <returns>False when the model has no value at the start or the parameters are not determined.</returns>
        public static bool TryMinimize(Model model, double[] parameters, int residualCount, out double squares, out double[,] inverseNormal)
        {
            int n = parameters.Length;
            inverseNormal = new double[n, n];
            double[] residuals = new double[residualCount], trial = new double[n], step = new double[n], gradient = new double[n];
            var derivatives = new double[residualCount, n];
            var normal = new double[n, n];
            if (!model(parameters, residuals, derivatives))
            {
                squares = double.NaN;
                return false;
            }

            squares = Sum(residuals);
            Accumulate(residuals, derivatives, normal, gradient);
            double damping = 1e-6, growth = 2;
            for (int i = 0; i < MaxSteps; i++)
            {
                var damped = (double[,])normal.Clone();
                for (int k = 0; k < n; k++)
                {
                    damped[k, k] *= 1 + damping;
                    step[k] = -gradient[k];
                }

                double next = double.PositiveInfinity, expected = 0;
                if (Cholesky.TryFactor(damped))
                {
                    Cholesky.Solve(damped, step);
                    for (int k = 0; k < n; k++)
                    {
                        trial[k] = parameters[k] + step[k];
                        expected += step[k] * (damping * normal[k, k] * step[k] - gradient[k]);
                    }

                    // What is to be gained lies below the rounding of the sum itself.
                    if (!(expected > 1e-18 * squares))
                        break;
                    next = model(trial, residuals, null) ? Sum(residuals) : double.PositiveInfinity;
                }

                if (next < squares)
                {
                    double gain = 2 * (squares - next) / expected - 1;
                    damping = Math.Max(1e-12, damping * Math.Max(1.0 / 3, 1 - gain * gain * gain));
                    growth = 2;
                    Array.Copy(trial, parameters, n);
                    squares = next;
                    model(parameters, residuals, derivatives);
                    Accumulate(residuals, derivatives, normal, gradient);
                }
                else
                {
                    damping *= growth;
                    growth *= 2;
                    if (damping > 1e12)
                        break;
                }
            }

            if (!Cholesky.TryFactor(normal))
                return false;
            inverseNormal = Cholesky.Inverse(normal);
            return true;
        }

        private static double Sum(double[] residuals)
        {
            double sum = 0;
            foreach (double r in residuals)
                sum += r * r;
            return double.IsNaN(sum) ? double.PositiveInfinity : sum;
        }

        private static void Accumulate(double[] residuals, double[,] derivatives, double[,] normal, double[] gradient)
        {
            int n = gradient.Length;
            Array.Clear(normal, 0, normal.Length);
            Array.Clear(gradient, 0, n);
            for (int i = 0; i < residuals.Length; i++)
            for (int row = 0; row < n; row++)
            {
                gradient[row] += derivatives[i, row] * residuals[i];
                for (int column = 0; column < n; column++)
                    normal[row, column] += derivatives[i, row] * derivatives[i, column];
            }
        }
    }
}
