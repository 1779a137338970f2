using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Calibration
{
    /// <summary>
    /// Least squares over cameras and boards by Levenberg-Marquardt with analytic derivatives. One camera or several, any of their
    /// numbers known or sought: mono and stereo calibration and the pose of a single board are the same problem.
    /// </summary>
    internal static class BundleAdjuster
    {
        private const int MaximumSteps = 200;
        private const double Settled = 1e-13;

        /// <summary>The state that fits best, from a start that may be rough; null when already the start puts points behind a camera.</summary>
        public static BundleState? Solve(BundleCamera[] cameras, BundleObservation[] observations, BundleState start, out NormalEquations? equations)
        {
            equations = NormalEquations.TryBuild(cameras, observations, start);
            if (equations == null)
                return null;
            BundleState state = start;
            double damping = 1e-3;
            for (int i = 0; i < MaximumSteps; i++)
            {
                double before = equations.Cost;
                if (!TryImprove(cameras, observations, ref state, ref equations, ref damping) || before - equations.Cost <= Settled * before)
                    break;
            }

            return state;
        }

        /// <summary>Root mean square distance of each board over all its views, px.</summary>
        public static double[] BoardRmsPx(BundleObservation[] observations, LensCamera[] cameras, BundleState state)
        {
            var squares = new double[state.Boards.Length];
            var points = new int[squares.Length];
            foreach (BundleObservation observation in observations)
            {
                foreach (Vector2D residual in ResidualsPx(observation, cameras[observation.Camera], state))
                    squares[observation.Board] += residual.LengthSquared;
                points[observation.Board] += observation.View.ImagePx.Length;
            }

            for (int b = 0; b < squares.Length; b++)
                squares[b] = points[b] > 0 ? Math.Sqrt(squares[b] / points[b]) : 0;
            return squares;
        }

        /// <summary>Measured minus projected, px, point by point.</summary>
        public static IEnumerable<Vector2D> ResidualsPx(BundleObservation observation, LensCamera camera, BundleState state)
        {
            Pose pose = state.Rigs[observation.Camera] * state.Boards[observation.Board];
            for (int i = 0; i < observation.View.BoardMm.Length; i++)
            {
                Vector2D onBoard = observation.View.BoardMm[i];
                camera.TryProject(pose.TransformPoint(new Vector3D(onBoard.X, onBoard.Y, 0)), out Vector2D pixel);
                yield return observation.View.ImagePx[i] - pixel;
            }
        }

        private static bool TryImprove(BundleCamera[] cameras, BundleObservation[] observations, ref BundleState state, ref NormalEquations equations, ref double damping)
        {
            for (; damping < 1e12; damping *= 10)
            {
                double[]? step = equations.TryStep(damping);
                if (step == null)
                    continue;
                BundleState moved = state.Moved(cameras, step);
                NormalEquations? after = NormalEquations.TryBuild(cameras, observations, moved);
                if (after == null || !(after.Cost < equations.Cost))
                    continue;
                state = moved;
                equations = after;
                damping = Math.Max(damping / 10, 1e-12);
                return true;
            }

            return false;
        }
    }
}
