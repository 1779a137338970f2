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

        // A focal length or centre that may be off by this share of the focal length is not determined.
        private const double UndeterminedShare = 0.05;
        private const double ParallelDegrees = 8;

        // However sure the fit believes to be: parallel boards give two equations for four numbers, the rest comes from the lens model.
        private const double CertainlyParallelDegrees = 1;

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
            List<BoardView> used = WithoutMirrored(views, leftOut, notes);
            if (!HasEnoughPoints(used, model, out reason))
                return false;
            Fit? fit;
            while (true)
            {
                fit = Fit.Of(used, width, height, model);
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

            double[] deviations = fit.StandardDeviations(Math.Max(fit.AxisSigmaPx, LeastNoisePx));
            string undetermined = Undetermined(fit, deviations);
            double spread = LargestAngleDegrees(fit.State.Boards);
            if (undetermined.Length == 0 && spread < CertainlyParallelDegrees)
                undetermined = string.Join(", ", Enumerable.Range(0, 4).Select(CameraParameters.NameOf));
            if (undetermined.Length > 0)
            {
                string why = spread < ParallelDegrees
                    ? FormattableString.Invariant($"the views are all parallel, as far as one can tell (within {spread:F1}°)")
                    : FormattableString.Invariant($"{used.Count} views with tilts that differ by {spread:F0}° at most are not enough");
                reason = $"{why}: not determined: {undetermined}; take views tilted by 20° and more, some about each axis";
                return false;
            }

            calibration = new CameraCalibration(fit.Camera, model, fit.RmsPx, used, fit.PerViewRmsPx, fit.State.Boards, fit.StandardDeviations(fit.AxisSigmaPx), leftOut, notes);
            return true;
        }

        /// <summary>A board that all views show mirrored is a mirrored picture; one view alone has its corners in the wrong order.</summary>
        private static List<BoardView> WithoutMirrored(IReadOnlyList<BoardView> views, List<LeftOutView> leftOut, List<string> notes)
        {
            ILookup<bool, BoardView> byOrder = views.ToLookup(IsMirrored);
            bool isPictureMirrored = byOrder[true].Count() > byOrder[false].Count();
            if (isPictureMirrored)
                notes.Add("the boards appear mirrored: is the picture mirrored, or do the points run the wrong way round?");
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
        private static string Undetermined(Fit fit, double[] deviations)
        {
            double limit = UndeterminedShare * fit.Camera.Pinhole.FocalXPx;
            return string.Join(", ", Enumerable.Range(0, 4).Where(i => deviations[i] > limit).Select(CameraParameters.NameOf));
        }

        private static double LargestAngleDegrees(Pose[] boards)
        {
            double largest = 0;
            foreach (Pose first in boards)
            foreach (Pose second in boards)
            {
                Vector3D a = first.TransformDirection(new Vector3D(0, 0, 1)), b = second.TransformDirection(new Vector3D(0, 0, 1));
                largest = Math.Max(largest, Math.Atan2(Vector3D.Cross(a, b).Length, Vector3D.Dot(a, b)));
            }

            return largest * 180 / Math.PI;
        }

        /// <summary>One bundle adjustment of one camera.</summary>
        private sealed class Fit
        {
            private readonly NormalEquations _equations;
            private readonly int[] _free;

            private Fit(BundleState state, NormalEquations equations, int[] free, LensCamera camera, double[] perViewRmsPx)
            {
                State = state;
                _equations = equations;
                _free = free;
                Camera = camera;
                PerViewRmsPx = perViewRmsPx;
            }

            public BundleState State { get; }

            public LensCamera Camera { get; }

            public double[] PerViewRmsPx { get; }

            public double RmsPx => _equations.RmsPx;

            /// <summary>Noise along one axis, px: what is left over for each degree of freedom.</summary>
            public double AxisSigmaPx => Math.Sqrt(_equations.Cost / (2 * _equations.Points - _equations.Unknowns));

            public static Fit? Of(IReadOnlyList<BoardView> views, int width, int height, LensModel model)
            {
                double[] parameters = InitialFocalLengths.Guess(views, width, height);
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
                var state = new BundleState(new[] { parameters }, new[] { Pose.Identity }, boards);
                BundleState? solved = state;
                NormalEquations? equations = null;
                foreach (LensModel step in model == LensModel.Rational8 ? new[] { LensModel.Brown5, model } : new[] { model })
                {
                    BundleCamera[] cameras = { new BundleCamera(width, height, CameraParameters.Free(step), false) };
                    solved = BundleAdjuster.Solve(cameras, observations, solved, out equations);
                    if (solved == null)
                        return null;
                }

                if (!CameraParameters.TryMakeCamera(solved.Lenses[0], width, height, out LensCamera? camera))
                    return null;
                return new Fit(solved, equations!, CameraParameters.Free(model), camera!, BundleAdjuster.BoardRmsPx(observations, new[] { camera! }, solved));
            }

            public double[] StandardDeviations(double sigmaPx)
            {
                double[] free = _equations.StandardDeviations(sigmaPx);
                var all = new double[CameraParameters.Count];
                for (int i = 0; i < _free.Length; i++)
                    all[_free[i]] = free[i];
                return all;
            }
        }
    }
}
