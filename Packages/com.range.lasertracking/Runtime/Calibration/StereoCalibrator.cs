using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Geometry;

namespace LaserTracking.Calibration
{
    /// <summary>
    /// Determines how two cameras stand to each other from boards that both see at once: a first guess from the single poses, then one
    /// bundle adjustment over both cameras, with their own numbers held or sought as well.
    /// </summary>
    public static class StereoCalibrator
    {
        // The agreed pose is only as good as one pair: what fits it ten times worse than usual is not a matter of noise.
        private const double StrangerFactor = 10;
        private const double NegligiblePx = 0.1;
        private const int FewestForStrangers = 5;

        // Together good pairs err little more than each camera alone; pairs of different moments, or one camera mirrored, by 80 times and more.
        private const double DisagreementFactor = 10;

        private const double RoundingShare = 1e-9;

        /// <param name="pairs">At least one; ten to twenty are usual.</param>
        /// <param name="left">Camera 0 as calibrated alone.</param>
        /// <param name="right">Camera 1 as calibrated alone.</param>
        /// <param name="freeModel">Which numbers of the cameras are sought again; null: none.</param>
        /// <param name="keepsAll">Also pairs that do not fit the others.</param>
        /// <param name="calibration">Null when refused.</param>
        /// <param name="reason">Why it was refused, one line; empty on success.</param>
        public static bool TryCalibrate(IReadOnlyList<BoardPair> pairs, LensCamera left, LensCamera right, LensModel? freeModel, bool keepsAll, out StereoCalibration? calibration, out string reason)
        {
            calibration = null;
            var leftOut = new List<LeftOutView>();
            var notes = new List<string>();
            var placed = new List<PlacedPair>();
            foreach (BoardPair pair in pairs)
            {
                if (PlacedPair.TryCreate(pair, left, right, out PlacedPair? one, out reason))
                    placed.Add(one!);
                else
                    leftOut.Add(new LeftOutView(pair.Name, reason));
            }

            if (placed.Count == 0)
            {
                reason = pairs.Count == 0 ? "no pair of views" : "no pair can be used: " + leftOut[0].Reason;
                return false;
            }

            PlacedPair.Agree(placed, notes);
            if (!keepsAll)
                LeaveOutStrangers(placed, left, right, leftOut);
            Fit? fit;
            while (true)
            {
                fit = Fit.Of(placed, left, right, freeModel);
                if (fit == null)
                {
                    reason = "the pairs fit no two cameras: check that both pictures of a pair were taken at one moment";
                    return false;
                }

                int outlier = OutlierViews.Find(fit.PerPairRmsPx, out double median);
                if (keepsAll || outlier < 0 || 4 * leftOut.Count >= pairs.Count)
                    break;
                leftOut.Add(new LeftOutView(placed[outlier].Pair.Name, FormattableString.Invariant(
                    $"its error is {fit.PerPairRmsPx[outlier]:F2} px where {median:F2} px is usual: not of one moment, left and right swapped, blurred, or its corners are badly found")));
                placed.RemoveAt(outlier);
            }

            var rig = new StereoRig(fit.Left, fit.Right, fit.State.Rigs[1]);
            if (StandInOnePlace(rig, fit))
            {
                reason = "both cameras stand in one place, as far as one can tell: are these pictures of two cameras?";
                return false;
            }

            double alonePx = Math.Sqrt(placed.Average(pair => 0.5 * (pair.LeftRmsPx * pair.LeftRmsPx + pair.RightRmsPx * pair.RightRmsPx)));
            if (!keepsAll && fit.RmsPx > DisagreementFactor * Math.Max(alonePx, NegligiblePx))
            {
                reason = FormattableString.Invariant($"the pairs do not agree: {fit.RmsPx:F1} px off together, {alonePx:F2} px each camera alone: not of one moment, in another order, or one camera's pictures mirrored");
                return false;
            }

            reason = WhySwapped(rig, fit.State.Boards);
            if (reason.Length > 0)
                return false;
            calibration = new StereoCalibration(rig, fit.RmsPx, placed.Select(p => p.Pair).ToArray(), fit.PerPairRmsPx, fit.State.Boards, fit.RigDeviations, leftOut, notes);
            return true;
        }

        /// <summary>
        /// Pairs that have nothing to do with the others would draw a fit of all so far off that none stands out: they go first, judged
        /// by the pose between the cameras on which the pairs agree.
        /// </summary>
        private static void LeaveOutStrangers(List<PlacedPair> pairs, LensCamera left, LensCamera right, List<LeftOutView> leftOut)
        {
            if (pairs.Count < FewestForStrangers)
                return;
            Pose middle = PlacedPair.Middle(pairs);
            double[] rmsPx = pairs.Select(pair => pair.RmsPx(left, right, middle)).ToArray();
            double median = rmsPx.OrderBy(value => value).ElementAt(rmsPx.Length / 2);
            for (int i = pairs.Count - 1; i >= 0; i--)
            {
                if (rmsPx[i] <= StrangerFactor * Math.Max(median, NegligiblePx))
                    continue;
                leftOut.Add(new LeftOutView(pairs[i].Pair.Name, FormattableString.Invariant(
                    $"it puts the cameras elsewhere to each other than the other pairs do ({rmsPx[i]:F1} px off): not of one moment, or left and right swapped")));
                pairs.RemoveAt(i);
            }
        }

        /// <summary>Without a distance between the cameras nothing can be triangulated or rectified.</summary>
        private static bool StandInOnePlace(StereoRig rig, Fit fit)
        {
            double uncertainty = Math.Sqrt(fit.RigDeviations.Skip(3).Sum(deviation => deviation * deviation));
            return rig.LeftToRight.Position.Length <= Math.Max(uncertainty, RoundingShare * fit.State.Boards.Max(board => board.Position.Length));
        }

        /// <summary>
        /// With the cameras exchanged everything fits as well, but the camera called right stands on the left: as the pictures are
        /// labelled, disparities and with them depths are negative. Two mirrored cameras look the same. Empty when all is well.
        /// </summary>
        private static string WhySwapped(StereoRig rig, Pose[] boards)
        {
            Vector3D t = rig.LeftToRight.Position;
            Vector3D rightInLeft = rig.RightToLeft(default);
            if (rightInLeft.X < 0 && Math.Abs(t.X) > Math.Abs(t.Y) && Math.Abs(t.X) > Math.Abs(t.Z))
                return FormattableString.Invariant($"left and right are swapped: the camera given as right stands {-rightInLeft.X:G4} to the left of the other one, so depths by disparity are negative: exchange the two, or take the pictures unmirrored");
            int behind = boards.Count(board => !(board.Position.Z > 0));
            return behind == 0 ? string.Empty : FormattableString.Invariant($"{behind} boards have their first corner behind camera 0 (negative depth): check the order of the corners");
        }

        /// <summary>One bundle adjustment of two cameras.</summary>
        private sealed class Fit
        {
            private readonly NormalEquations _equations;

            private Fit(BundleState state, NormalEquations equations, LensCamera left, LensCamera right, double[] perPairRmsPx, int rigStart)
            {
                State = state;
                _equations = equations;
                Left = left;
                Right = right;
                PerPairRmsPx = perPairRmsPx;
                double sigma = Math.Sqrt(equations.Cost / Math.Max(1, 2 * equations.Points - equations.Unknowns));
                RigDeviations = equations.StandardDeviations(sigma).AsSpan(rigStart, 6).ToArray();
            }

            public BundleState State { get; }

            public LensCamera Left { get; }

            public LensCamera Right { get; }

            public double[] PerPairRmsPx { get; }

            public double[] RigDeviations { get; }

            public double RmsPx => _equations.RmsPx;

            public static Fit? Of(List<PlacedPair> pairs, LensCamera left, LensCamera right, LensModel? freeModel)
            {
                int[] free = freeModel is LensModel model ? CameraParameters.Free(model) : Array.Empty<int>();
                BundleCamera[] cameras =
                {
                    new BundleCamera(left.Pinhole.Width, left.Pinhole.Height, free, false),
                    new BundleCamera(right.Pinhole.Width, right.Pinhole.Height, free, true),
                };
                var observations = new List<BundleObservation>();
                for (int i = 0; i < pairs.Count; i++)
                {
                    observations.Add(new BundleObservation(0, i, pairs[i].Pair.Left));
                    observations.Add(new BundleObservation(1, i, pairs[i].Pair.Right));
                }

                BundleObservation[] all = observations.ToArray();
                var start = new BundleState(new[] { CameraParameters.Of(left), CameraParameters.Of(right) },
                    new[] { Pose.Identity, PlacedPair.Middle(pairs) }, pairs.Select(pair => pair.LeftPose).ToArray());
                BundleState? solved = BundleAdjuster.Solve(cameras, all, start, out NormalEquations? equations);
                if (solved == null
                    || !CameraParameters.TryMakeCamera(solved.Lenses[0], left.Pinhole.Width, left.Pinhole.Height, out LensCamera? newLeft)
                    || !CameraParameters.TryMakeCamera(solved.Lenses[1], right.Pinhole.Width, right.Pinhole.Height, out LensCamera? newRight))
                    return null;
                double[] perPair = BundleAdjuster.BoardRmsPx(all, new[] { newLeft!, newRight! }, solved);
                return new Fit(solved, equations!, newLeft!, newRight!, perPair, 2 * free.Length);
            }
        }
    }
}
