using System;
using LaserTracking.Geometry;

namespace LaserTracking.Calibration
{
    /// <summary>
    /// Gauss-Newton equations of a bundle adjustment in their block form: cameras U, each board V, and W between them. The boards are
    /// eliminated first (Schur complement; Triggs et al. 2000, section 6), so that what is solved has the size of the cameras' unknowns.
    /// </summary>
    internal sealed class NormalEquations
    {
        private const int BoardUnknowns = 6;

        private readonly int[] _starts;
        private readonly int _cameraUnknowns;
        private readonly double[,] _u;
        private readonly double[] _cameraGradient;
        private readonly double[][,] _w;
        private readonly double[][,] _v;
        private readonly double[][] _boardGradients;

        private NormalEquations(BundleCamera[] cameras, int boards)
        {
            _starts = new int[cameras.Length];
            for (int c = 0; c < cameras.Length; c++)
            {
                _starts[c] = _cameraUnknowns;
                _cameraUnknowns += cameras[c].Unknowns;
            }

            _u = new double[_cameraUnknowns, _cameraUnknowns];
            _cameraGradient = new double[_cameraUnknowns];
            _w = new double[boards][,];
            _v = new double[boards][,];
            _boardGradients = new double[boards][];
            for (int b = 0; b < boards; b++)
            {
                _w[b] = new double[_cameraUnknowns, BoardUnknowns];
                _v[b] = new double[BoardUnknowns, BoardUnknowns];
                _boardGradients[b] = new double[BoardUnknowns];
            }
        }

        /// <summary>Sum of squared distances, px².</summary>
        public double Cost { get; private set; }

        /// <summary>Number of points.</summary>
        public int Points { get; private set; }

        /// <summary>Unknowns in all.</summary>
        public int Unknowns => _cameraUnknowns + BoardUnknowns * _v.Length;

        /// <summary>Root mean square distance, px.</summary>
        public double RmsPx => Math.Sqrt(Cost / Points);

        /// <summary>Null when the state makes no camera or puts a point behind one.</summary>
        public static NormalEquations? TryBuild(BundleCamera[] cameras, BundleObservation[] observations, BundleState state)
        {
            var lenses = new LensCamera[cameras.Length];
            for (int c = 0; c < cameras.Length; c++)
            {
                if (!CameraParameters.TryMakeCamera(state.Lenses[c], cameras[c].Width, cameras[c].Height, out LensCamera? camera))
                    return null;
                lenses[c] = camera!;
            }

            var equations = new NormalEquations(cameras, state.Boards.Length);
            foreach (BundleObservation observation in observations)
            {
                if (!equations.TryAdd(cameras[observation.Camera], lenses[observation.Camera], observation, state))
                    return null;
            }

            return double.IsNaN(equations.Cost) || double.IsInfinity(equations.Cost) ? null : equations;
        }

        /// <summary>The step that solves the equations damped after Marquardt (1963), diagonal times 1 + λ; null when they are singular.</summary>
        public double[]? TryStep(double damping)
        {
            if (!TryReduce(damping, out double[,] reduced, out double[] cameraStep, out double[][,] reductions, out double[][] boardSteps) || !Cholesky.TryFactor(reduced))
                return null;
            Cholesky.Solve(reduced, cameraStep);
            var step = new double[Unknowns];
            cameraStep.CopyTo(step, 0);
            for (int b = 0; b < _v.Length; b++)
            {
                Span<double> board = step.AsSpan(_cameraUnknowns + BoardUnknowns * b, BoardUnknowns);
                for (int k = 0; k < BoardUnknowns; k++)
                {
                    board[k] = boardSteps[b][k];
                    for (int i = 0; i < _cameraUnknowns; i++)
                        board[k] -= reductions[b][i, k] * cameraStep[i];
                }
            }

            return step;
        }

        /// <summary>Standard deviations of the cameras' unknowns for measurement noise of sigma px along each axis.</summary>
        public double[] StandardDeviations(double sigmaPx)
        {
            double[,] covariance = Covariance(sigmaPx);
            var deviations = new double[_cameraUnknowns];
            for (int i = 0; i < deviations.Length; i++)
                deviations[i] = Math.Sqrt(covariance[i, i]);
            return deviations;
        }

        /// <summary>
        /// Of the cameras' unknowns, for measurement noise of sigma px along each axis. What is not determined gets huge numbers, never
        /// infinity.
        /// </summary>
        public double[,] Covariance(double sigmaPx)
        {
            var covariance = new double[_cameraUnknowns, _cameraUnknowns];
            if (_cameraUnknowns == 0)
                return covariance;
            if (!TryReduce(1e-12, out double[,] reduced, out _, out _, out _))
            {
                for (int i = 0; i < _cameraUnknowns; i++)
                    covariance[i, i] = double.MaxValue;
                return covariance;
            }

            // Scaled to a diagonal of ones: what is left small is a combination that the views do not determine.
            var scaled = new double[_cameraUnknowns, _cameraUnknowns];
            for (int i = 0; i < _cameraUnknowns; i++)
            for (int j = 0; j < _cameraUnknowns; j++)
                scaled[i, j] = reduced[i, j] / Math.Sqrt(Math.Max(double.Epsilon, _u[i, i] * _u[j, j]));
            SymmetricEigen.Decompose(scaled, out double[] values, out double[,] vectors);
            for (int i = 0; i < _cameraUnknowns; i++)
            for (int j = 0; j < _cameraUnknowns; j++)
            {
                double sum = 0;
                for (int k = 0; k < _cameraUnknowns; k++)
                    sum += vectors[i, k] * vectors[j, k] / Math.Max(values[k], 1e-14);
                covariance[i, j] = sigmaPx * sigmaPx * sum / Math.Max(double.Epsilon, Math.Sqrt(_u[i, i] * _u[j, j]));
            }

            return covariance;
        }

        /// <summary>Standard deviation of a board's tilt about the camera's x and y, the larger one, radians, were the cameras known.</summary>
        public double TiltDeviation(int board, double sigmaPx)
        {
            double[,] factor = Damped(_v[board], 1e-12);
            if (!Cholesky.TryFactor(factor))
                return double.PositiveInfinity;
            double[,] inverse = Cholesky.Inverse(factor);
            return sigmaPx * Math.Sqrt(Math.Max(inverse[0, 0], inverse[1, 1]));
        }

        /// <summary>U − W V⁻¹ Wᵀ and its right side, of each board V⁻¹ Wᵀ (a row a camera unknown) and V⁻¹ g; false where a board's V is singular.</summary>
        private bool TryReduce(double damping, out double[,] reduced, out double[] right, out double[][,] reductions, out double[][] boardSteps)
        {
            reductions = new double[_v.Length][,];
            boardSteps = new double[_v.Length][];
            reduced = Damped(_u, damping);
            right = (double[])_cameraGradient.Clone();
            var column = new double[BoardUnknowns];
            for (int b = 0; b < _v.Length; b++)
            {
                double[,] factor = Damped(_v[b], damping), w = _w[b];
                if (!Cholesky.TryFactor(factor))
                    return false;
                boardSteps[b] = (double[])_boardGradients[b].Clone();
                Cholesky.Solve(factor, boardSteps[b]);
                reductions[b] = new double[_cameraUnknowns, BoardUnknowns];
                for (int i = 0; i < _cameraUnknowns; i++)
                {
                    for (int k = 0; k < BoardUnknowns; k++)
                    {
                        column[k] = w[i, k];
                        right[i] -= w[i, k] * boardSteps[b][k];
                    }

                    Cholesky.Solve(factor, column);
                    for (int k = 0; k < BoardUnknowns; k++)
                        reductions[b][i, k] = column[k];
                    for (int j = 0; j < _cameraUnknowns; j++)
                    for (int k = 0; k < BoardUnknowns; k++)
                        reduced[j, i] -= w[j, k] * column[k];
                }
            }

            return true;
        }

        private static double[,] Damped(double[,] block, double damping)
        {
            var damped = (double[,])block.Clone();
            for (int i = 0; i < damped.GetLength(0); i++)
                damped[i, i] = block[i, i] * (1 + damping) + double.Epsilon;
            return damped;
        }

        /// <summary>
        /// With X_0 = R_b X + T_b and X_c = R_c X_0 + T_c, a turn ω applied on the left moves a turned point t by ω × t, and a row p of
        /// derivatives by X_c therefore by ω·(t × p).
        /// </summary>
        private bool TryAdd(BundleCamera unknowns, LensCamera camera, BundleObservation observation, BundleState state)
        {
            Pose board = state.Boards[observation.Board], rig = state.Rigs[observation.Camera];
            int[] free = unknowns.FreeLens;
            int own = unknowns.Unknowns, all = own + BoardUnknowns;
            var sums = new LocalSums(all);
            Span<double> byPoint = stackalloc double[6], byPinhole = stackalloc double[8], byDistortion = stackalloc double[16];
            Span<double> row = stackalloc double[all];
            for (int i = 0; i < observation.View.BoardMm.Length; i++)
            {
                Vector2D onBoard = observation.View.BoardMm[i];
                Vector3D turned = board.TransformDirection(new Vector3D(onBoard.X, onBoard.Y, 0));
                Vector3D turnedByRig = rig.TransformDirection(turned + board.Position);
                if (!camera.TryProject(turnedByRig + rig.Position, out Vector2D pixel, byPoint, byPinhole, byDistortion))
                    return false;
                Vector2D residual = observation.View.ImagePx[i] - pixel;
                for (int axis = 0; axis < 2; axis++)
                {
                    var p = new Vector3D(byPoint[axis * 3], byPoint[axis * 3 + 1], byPoint[axis * 3 + 2]);
                    for (int k = 0; k < free.Length; k++)
                        row[k] = free[k] < 4 ? byPinhole[axis * 4 + free[k]] : byDistortion[axis * 8 + free[k] - 4];
                    if (unknowns.IsPoseFree)
                        Put(row.Slice(free.Length), Vector3D.Cross(turnedByRig, p), p);
                    Vector3D q = rig.InverseTransformDirection(p);
                    Put(row.Slice(own), Vector3D.Cross(turned, q), q);
                    sums.Add(row, axis == 0 ? residual.X : residual.Y);
                }

                Cost += residual.LengthSquared;
                Points++;
            }

            Scatter(sums, _starts[observation.Camera], own, observation.Board);
            return true;
        }

        private static void Put(Span<double> row, Vector3D rotation, Vector3D translation)
        {
            row[0] = rotation.X;
            row[1] = rotation.Y;
            row[2] = rotation.Z;
            row[3] = translation.X;
            row[4] = translation.Y;
            row[5] = translation.Z;
        }

        private void Scatter(LocalSums sums, int start, int own, int board)
        {
            for (int i = 0; i < own; i++)
            {
                for (int j = 0; j < own; j++)
                    _u[start + i, start + j] += sums.Normal(i, j);
                for (int j = 0; j < BoardUnknowns; j++)
                    _w[board][start + i, j] += sums.Normal(i, own + j);
                _cameraGradient[start + i] += sums.Gradient[i];
            }

            for (int i = 0; i < BoardUnknowns; i++)
            {
                for (int j = 0; j < BoardUnknowns; j++)
                    _v[board][i, j] += sums.Normal(own + i, own + j);
                _boardGradients[board][i] += sums.Gradient[own + i];
            }
        }

        /// <summary>JᵀJ and Jᵀr of one view.</summary>
        private sealed class LocalSums
        {
            private readonly double[] _lower;
            private readonly int _size;

            public LocalSums(int size)
            {
                _size = size;
                _lower = new double[size * size];
                Gradient = new double[size];
            }

            public double[] Gradient { get; }

            public double Normal(int i, int j) => i >= j ? _lower[i * _size + j] : _lower[j * _size + i];

            public void Add(ReadOnlySpan<double> row, double residual)
            {
                for (int i = 0; i < row.Length; i++)
                {
                    double factor = row[i];
                    Span<double> sums = _lower.AsSpan(i * _size, i + 1);
                    for (int j = 0; j < sums.Length; j++)
                        sums[j] += factor * row[j];
                    Gradient[i] += factor * residual;
                }
            }
        }
    }
}
