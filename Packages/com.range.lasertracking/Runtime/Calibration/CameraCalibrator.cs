using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Geometry;

namespace LaserTracking.Calibration
{
    /// <summary>
    /// Determines a camera from views of a flat board (Zhang 2000): closed form first, then bundle adjustment. Views that do not fit
    /// the others are named and left out; what the views do not determine is named and refused.
    /// </summary>
    public static class CameraCalibrator
    {
        // Corners are hardly ever found better than this; noise-free input must not hide what is undetermined.
        private const double LeastNoisePx = 0.1;

        // What may be off by more than this share at one standard deviation is of no use: focal lengths by their own, the centre by the
        // picture's width, the lens by half the picture's width, at its edge (in the corners even good sets are no better).
        private const double UsableShare = 0.02;

        // Focal lengths and centres that are known worse than usual are said with how well; from here on they count as not determined.
        private const double OpenShare = 0.05;

        // However sure the fit believes to be: parallel boards give two equations for four numbers, the rest comes from the lens model.
        private const double CertainlyParallelDegrees = 1, ParallelDeviations = 6, ParallelDegrees = 8;

        /// <param name="views">At least one; three that are tilted differently are the practical minimum, twenty are usual.</param>
        /// <param name="width">Picture width in pixels.</param>
        /// <param name="height">Picture height in pixels.</param>
        /// <param name="model">Which coefficients of the lens are sought.</param>
        /// <param name="keepsAll">Also views that do not fit the others.</param>
        /// <param name="calibration">Null when refused.</param>
        /// <param name="reason">Why it was refused, one line; empty on success.</param>
        public static bool TryCalibrate(IReadOnlyList<BoardView> views, int width, int height, LensModel model, bool keepsAll, out CameraCalibration? calibration, out string reason)
        {
            calibration = null;
            var leftOut = new List<LeftOutView>();
            var notes = new List<string>();
            List<BoardView> used = WithoutMirrored(views, leftOut, notes, out bool isMirrored);
            if (!HasEnoughPoints(used, model, out reason))
                return false;
            int[] free = CameraParameters.Free(model);
            Fit? fit;
            while (true)
            {
                fit = Fit.Of(used, width, height, free);
                if (fit == null)
                {
                    reason = "the views fit no camera: check that all are of one board, seen by one camera";
                    return false;
                }

                int outlier = OutlierViews.Find(fit.PerViewRmsPx, out double median);
                if (keepsAll || outlier < 0 || 4 * leftOut.Count >= views.Count)
                    break;
                leftOut.Add(new LeftOutView(used[outlier].Name, FormattableString.Invariant(
                    $"its error is {fit.PerViewRmsPx[outlier]:F2} px where {median:F2} px is usual: blurred, moved, or its corners are badly found")));
                used.RemoveAt(outlier);
            }

            List<string> undetermined = Undetermined(fit, out bool isParallel);
            if (undetermined.Count > 0)
            {
                string why = used.Count == 1 ? "one view is not enough" : isParallel ? FormattableString.Invariant($"the views are all parallel, as far as one can tell (within {fit.LeastAngleDegrees:F1}°)")
                    : FormattableString.Invariant($"{used.Count} views with tilts that differ by {fit.LargestAngleDegrees():F0}° at most and an error of {fit.RmsPx:F2} px are not enough");
                reason = $"{why}: not determined: {string.Join(", ", undetermined)}; take views tilted by 20° to 40°, some about each axis";
                return false;
            }

            // From the highest order on; k1 stays, alone it is confused with nothing.
            var held = new List<string>();
            while (free.Length > 5 && fit.LensDeviationPx() > UsableShare * 0.5 * width)
            {
                held.Insert(0, CameraParameters.NameOf(free[^1]));
                free = free.AsSpan(0, free.Length - 1).ToArray();
                if (!(Fit.Of(used, width, height, free) is Fit simpler))
                    break;
                fit = simpler;
            }

            NoteWeak(fit, notes);
            if (held.Count > 0)
                notes.Add($"the views do not determine {string.Join(", ", held)}: held at 0; for these, take views that reach to the edges of the picture");
            calibration = new CameraCalibration(fit.Camera, model, fit.RmsPx, used, fit.PerViewRmsPx, fit.State.Boards, fit.StandardDeviations(fit.AxisSigmaPx), leftOut, notes, isMirrored);
            return true;
        }

        /// <summary>A board that all views show mirrored is a mirrored picture; one view alone has its corners in the wrong order.</summary>
        private static List<BoardView> WithoutMirrored(IReadOnlyList<BoardView> views, List<LeftOutView> leftOut, List<string> notes, out bool isPictureMirrored)
        {
            ILookup<bool, BoardView> byOrder = views.ToLookup(IsMirrored);
            isPictureMirrored = byOrder[true].Count() > byOrder[false].Count();
            if (isPictureMirrored)
                notes.Add("the boards appear mirrored: if the points run the wrong way round, the camera's numbers are right all the same; if the picture is mirrored, they hold only while it stays so");
            foreach (BoardView view in byOrder[!isPictureMirrored])
                leftOut.Add(new LeftOutView(view.Name, "its points run the other way round than in the other views"));
            return byOrder[isPictureMirrored].ToList();
        }

        private static bool IsMirrored(BoardView view)
        {
            Vector2D center = default;
            foreach (Vector2D point in view.BoardMm)
                center += point * (1.0 / view.BoardMm.Length);
            if (!HomographyEstimator.TryFit(view.BoardMm, view.ImagePx, out Homography homography, out _))
                return false;
            homography.Jacobian(center, out double xx, out double xy, out double yx, out double yy);
            return xx * yy - xy * yx < 0;
        }

        private static bool HasEnoughPoints(List<BoardView> views, LensModel model, out string reason)
        {
            int measured = 2 * views.Sum(view => view.ImagePx.Length), sought = CameraParameters.Free(model).Length + 6 * views.Count;
            reason = views.Count == 0 ? "no view of a board" : measured > sought ? string.Empty
                : FormattableString.Invariant($"{measured} measured numbers cannot determine {sought} unknowns: take more views");
            return reason.Length == 0;
        }

        /// <summary>Names of the focal lengths and centres that the views leave open.</summary>
        private static List<string> Undetermined(Fit fit, out bool isParallel)
        {
            double[] deviations = fit.StandardDeviations(fit.JudgedSigmaPx);
            double angle = fit.LargestAngleDegrees();
            bool isCertainlyParallel = angle < Math.Max(CertainlyParallelDegrees, ParallelDeviations * fit.TiltDeviationDegrees());
            PinholeCamera pinhole = fit.Camera.Pinhole;
            double[] usable = Scales(pinhole).Select(scale => OpenShare * scale).ToArray();
            isParallel = isCertainlyParallel || fit.LeastAngleDegrees < ParallelDegrees;
            return Enumerable.Range(0, 4).Where(i => isCertainlyParallel || !(deviations[i] <= usable[i]) || (i < 2 && fit.HasRival)).Select(CameraParameters.NameOf).ToList();
        }

        /// <summary>What focal lengths and centre are measured by.</summary>
        private static double[] Scales(PinholeCamera pinhole) => new double[] { pinhole.FocalXPx, pinhole.FocalYPx, pinhole.Width, pinhole.Width };

        /// <summary>Adds a note on what is known, but not well.</summary>
        private static void NoteWeak(Fit fit, List<string> notes)
        {
            double[] deviations = fit.StandardDeviations(fit.JudgedSigmaPx), scales = Scales(fit.Camera.Pinhole);
            string[] weak = Enumerable.Range(0, 4).Where(i => deviations[i] > UsableShare * scales[i])
                .Select(i => FormattableString.Invariant($"{CameraParameters.NameOf(i)} to {deviations[i]:F0} px ({100 * deviations[i] / scales[i]:F1} %)")).ToArray();
            if (weak.Length > 0)
                notes.Add($"the views determine {string.Join(", ", weak)} only: take more views, tilted by 20° to 40° about both axes");
        }

        /// <summary>One bundle adjustment of one camera.</summary>
        private sealed class Fit
        {
            // A fit is doubted, and begun again elsewhere, from this uncertainty of the focal length on or below this spread of tilts.
            private const double DoubtedShare = 0.005, DoubtedDegrees = 20;

            // Of costs: three standard deviations.
            private const double RivalGain = 9;

            private static readonly double[] Starts = { 0.4, 0.7, 1.2, 2, 4 };

            private readonly NormalEquations _equations;
            private readonly int[] _free;

            private Fit(BundleState state, NormalEquations equations, int[] free, LensCamera camera, BundleObservation[] observations)
            {
                State = state;
                _equations = equations;
                _free = free;
                Camera = camera;
                PerViewRmsPx = BundleAdjuster.BoardRmsPx(observations, new[] { camera }, state);
            }

            public BundleState State { get; }

            public LensCamera Camera { get; }

            public double[] PerViewRmsPx { get; }

            /// <summary>Another focal length, further off than what is usable, fits nearly as well.</summary>
            public bool HasRival { get; private set; }

            /// <summary>The largest angle between two boards in that of the equally good fits which has them most alike.</summary>
            public double LeastAngleDegrees { get; private set; }

            public double RmsPx => _equations.RmsPx;

            /// <summary>Noise along one axis, px: what is left over for each degree of freedom.</summary>
            public double AxisSigmaPx => Math.Sqrt(_equations.Cost / (2 * _equations.Points - _equations.Unknowns));

            /// <summary>The noise by which is judged what is determined, px.</summary>
            public double JudgedSigmaPx => Math.Max(AxisSigmaPx, LeastNoisePx);

            /// <summary>The fit from Zhang's focal length, and where that is doubtful the best of several: nearly parallel boards have more than one minimum.</summary>
            public static Fit? Of(IReadOnlyList<BoardView> views, int width, int height, int[] free)
            {
                double[] guess = InitialFocalLengths.Guess(views, width, height);
                Fit? best = From(guess, views, width, height, free);
                if (best != null && best.StandardDeviations(best.JudgedSigmaPx)[0] <= DoubtedShare * best.Camera.Pinhole.FocalXPx && best.LargestAngleDegrees() >= DoubtedDegrees)
                {
                    best.LeastAngleDegrees = best.LargestAngleDegrees();
                    return best;
                }

                var all = new List<Fit>();
                if (best != null)
                    all.Add(best);
                foreach (double start in Starts)
                {
                    guess[0] = guess[1] = start * width;
                    if (From(guess, views, width, height, free) is Fit other)
                        all.Add(other);
                }

                best = all.OrderBy(fit => fit._equations.Cost).FirstOrDefault();
                if (best != null)
                {
                    double variance = best.JudgedSigmaPx * best.JudgedSigmaPx, focal = best.Camera.Pinhole.FocalXPx;
                    all.RemoveAll(fit => fit._equations.Cost - best._equations.Cost >= RivalGain * variance);
                    best.LeastAngleDegrees = all.Min(fit => fit.LargestAngleDegrees());
                    best.HasRival = all.Any(fit => Math.Abs(fit.Camera.Pinhole.FocalXPx - focal) > 3 * UsableShare * focal);
                }

                return best;
            }

            public double LargestAngleDegrees()
            {
                double largest = 0;
                foreach (Pose first in State.Boards)
                foreach (Pose second in State.Boards)
                {
                    Vector3D a = first.TransformDirection(new Vector3D(0, 0, 1)), b = second.TransformDirection(new Vector3D(0, 0, 1));
                    largest = Math.Max(largest, Math.Atan2(Vector3D.Cross(a, b).Length, Vector3D.Dot(a, b)));
                }

                return largest * 180 / Math.PI;
            }

            /// <summary>How well the tilt of a board in the middle among them is known, from the noise that there is.</summary>
            public double TiltDeviationDegrees()
            {
                double[] all = Enumerable.Range(0, State.Boards.Length).Select(board => _equations.TiltDeviation(board, AxisSigmaPx)).OrderBy(value => value).ToArray();
                return all[all.Length / 2] * 180 / Math.PI;
            }

            /// <summary>
            /// Standard deviation of the displacement by the lens in the middle of the picture's left or right edge, px: of a pixel, so that a focal length
            /// that is not known, which scales the coefficients, does not count here.
            /// </summary>
            public double LensDeviationPx()
            {
                double[,] covariance = _equations.Covariance(JudgedSigmaPx);
                double[] parameters = CameraParameters.Of(Camera);
                PinholeCamera pinhole = Camera.Pinhole;
                var edge = new Vector2D(2 * pinhole.CenterXPx < pinhole.Width ? pinhole.Width : 0, 0.5 * pinhole.Height);
                var derivatives = new Vector2D[_free.Length];
                for (int i = 0; i < _free.Length; i++)
                {
                    double step = _free[i] < 4 ? 1 : 1e-4, at = parameters[_free[i]];
                    parameters[_free[i]] = at + step;
                    Vector2D after = Displacement(parameters, edge);
                    parameters[_free[i]] = at - step;
                    derivatives[i] = (after - Displacement(parameters, edge)) * (0.5 / step);
                    parameters[_free[i]] = at;
                }

                double variance = 0;
                for (int i = 0; i < _free.Length; i++)
                for (int k = 0; k < _free.Length; k++)
                    variance += covariance[i, k] * Vector2D.Dot(derivatives[i], derivatives[k]);
                return Math.Sqrt(Math.Max(0, variance));
            }

            public double[] StandardDeviations(double sigmaPx)
            {
                double[] free = _equations.StandardDeviations(sigmaPx);
                var all = new double[CameraParameters.Count];
                for (int i = 0; i < _free.Length; i++)
                    all[_free[i]] = free[i];
                return all;
            }

            private static Vector2D Displacement(double[] p, Vector2D pixel)
            {
                var ray = new Vector2D((pixel.X - p[2]) / p[0], (pixel.Y - p[3]) / p[1]);
                Vector2D off = BrownDistortion.FromOpenCv(p.AsSpan(4, 8)).Distort(ray, stackalloc double[4], stackalloc double[16]) - ray;
                return new Vector2D(p[0] * off.X, p[1] * off.Y);
            }

            private static Fit? From(double[] parameters, IReadOnlyList<BoardView> views, int width, int height, int[] free)
            {
                if (!CameraParameters.TryMakeCamera(parameters, width, height, out LensCamera? guess))
                    return null;
                var boards = new Pose[views.Count];
                var observations = new BundleObservation[views.Count];
                for (int i = 0; i < boards.Length; i++)
                {
                    if (!PlanarPoseEstimator.TryEstimate(views[i], guess!, out PlanarPose? pose, out _))
                        return null;
                    boards[i] = pose!.Pose;
                    observations[i] = new BundleObservation(0, i, views[i]);
                }

                // The rational model has long flat valleys; from the common one it starts in the right one.
                BundleState? solved = new BundleState(new[] { (double[])parameters.Clone() }, new[] { Pose.Identity }, boards);
                NormalEquations? equations = null;
                int[] common = CameraParameters.Free(LensModel.Brown5);
                foreach (int[] step in free.Length > common.Length ? new[] { common, free } : new[] { free })
                {
                    solved = BundleAdjuster.Solve(new[] { new BundleCamera(width, height, step, false) }, observations, solved, out equations);
                    if (solved == null)
                        return null;
                }

                return CameraParameters.TryMakeCamera(solved.Lenses[0], width, height, out LensCamera? camera) ? new Fit(solved, equations!, free, camera!, observations) : null;
            }
        }
    }
}
