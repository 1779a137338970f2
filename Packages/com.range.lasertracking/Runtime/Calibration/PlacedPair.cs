using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Geometry;

namespace LaserTracking.Calibration
{
    /// <summary>
    /// A pair with the board's pose in each camera. A board with as many even as odd sides looks the same after half a turn: then the
    /// two cameras may count its corners from opposite ends, and the other pairs tell which end is meant.
    /// </summary>
    internal sealed class PlacedPair
    {
        private PlacedPair(BoardPair pair, PlanarPose left, PlanarPose right)
        {
            Pair = pair;
            LeftPose = left.Pose;
            RightPose = right.Pose;
            LeftRmsPx = left.RmsPx;
            RightRmsPx = right.RmsPx;
        }

        public BoardPair Pair { get; private set; }

        public Pose LeftPose { get; }

        public Pose RightPose { get; private set; }

        /// <summary>How well the left view fits its camera alone, px.</summary>
        public double LeftRmsPx { get; }

        /// <summary>The same of the right view.</summary>
        public double RightRmsPx { get; }

        /// <summary>Camera 0's space to camera 1's, by this pair alone.</summary>
        public Pose Between => Relative(RightPose);

        public static bool TryCreate(BoardPair pair, LensCamera left, LensCamera right, out PlacedPair? placed, out string reason)
        {
            placed = null;
            if (!PlanarPoseEstimator.TryEstimate(pair.Left, left, out PlanarPose? leftPose, out reason) || !PlanarPoseEstimator.TryEstimate(pair.Right, right, out PlanarPose? rightPose, out reason))
                return false;
            placed = new PlacedPair(pair, leftPose!, rightPose!);
            return true;
        }

        /// <summary>Turns those right views by half that agree with the other pairs only so.</summary>
        public static void Agree(List<PlacedPair> pairs, List<string> notes)
        {
            // Two camps a half turn apart: the larger one is right, by the pair that lies nearest to most of the others either way.
            PlacedPair middle = pairs.OrderBy(candidate => Median(pairs.Select(other => Distance(candidate.Between, other.Between)))).First();
            foreach (PlacedPair pair in pairs)
            {
                if (!TryTurn(pair.Pair.Right, out BoardView? turned, out Pose halfTurn))
                    continue;
                Pose turnedPose = pair.RightPose * halfTurn;
                if (!(Distance(pair.Relative(turnedPose), middle.Between) < Distance(pair.Between, middle.Between)))
                    continue;
                pair.Pair = new BoardPair(pair.Pair.Left, turned!);
                pair.RightPose = turnedPose;
                notes.Add(turned!.Name + ": its corners were counted from the opposite end of the board than in the left picture; turned");
            }
        }

        /// <summary>The pose between the cameras that lies nearest to all pairs' own.</summary>
        public static Pose Middle(List<PlacedPair> pairs) =>
            pairs.OrderBy(candidate => pairs.Sum(other => Distance(candidate.Between, other.Between))).First().Between;

        /// <summary>How well both views fit cameras that stand to each other like this, px; the board may move.</summary>
        public double RmsPx(LensCamera left, LensCamera right, Pose leftToRight)
        {
            BundleCamera[] cameras = { BundleCamera.Known(left.Pinhole.Width, left.Pinhole.Height), BundleCamera.Known(right.Pinhole.Width, right.Pinhole.Height) };
            BundleObservation[] observations = { new BundleObservation(0, 0, Pair.Left), new BundleObservation(1, 0, Pair.Right) };
            var start = new BundleState(new[] { CameraParameters.Of(left), CameraParameters.Of(right) }, new[] { Pose.Identity, leftToRight }, new[] { LeftPose });
            return BundleAdjuster.Solve(cameras, observations, start, out NormalEquations? equations) == null ? double.PositiveInfinity : equations!.RmsPx;
        }

        private Pose Relative(Pose rightPose)
        {
            Rotation3D rotation = rightPose.Rotation * LeftPose.Rotation.Inverse;
            return new Pose(rightPose.Position - rotation * LeftPose.Position, rotation);
        }

        /// <summary>Angle in radians: what half a turn changes by π, and noise hardly at all.</summary>
        private static double Distance(Pose a, Pose b)
        {
            Rotation3D turn = a.Rotation * b.Rotation.Inverse;
            return 2 * Math.Atan2(new Vector3D(turn.X, turn.Y, turn.Z).Length, Math.Abs(turn.W));
        }

        private static double Median(IEnumerable<double> values)
        {
            double[] sorted = values.OrderBy(value => value).ToArray();
            return sorted[sorted.Length / 2];
        }

        /// <summary>The same corners counted from the other end; false when the points are no whole grid.</summary>
        private static bool TryTurn(BoardView view, out BoardView? turned, out Pose halfTurn)
        {
            turned = null;
            halfTurn = Pose.Identity;
            int last = view.BoardMm.Length - 1;
            Vector2D sum = view.BoardMm[0] + view.BoardMm[last];
            for (int i = 0; i <= last; i++)
            {
                if ((view.BoardMm[i] + view.BoardMm[last - i] - sum).Length > 1e-9 * sum.Length)
                    return false;
            }

            var reversed = (Vector2D[])view.ImagePx.Clone();
            Array.Reverse(reversed);
            halfTurn = new Pose(new Vector3D(sum.X, sum.Y, 0), Rotation3D.AboutAxis(new Vector3D(0, 0, 1), Math.PI));
            return BoardView.TryCreate(view.Name, view.BoardMm, reversed, out turned, out _);
        }
    }
}
