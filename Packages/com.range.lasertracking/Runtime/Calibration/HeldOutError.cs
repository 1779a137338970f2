using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Geometry;

namespace LaserTracking.Calibration
{
    /// <summary>
    /// What a calibration is worth on views it has not seen: the views are dealt into groups, each group is left out once, and only its
    /// boards' poses are fitted with the cameras that the others gave.
    /// </summary>
    public static class HeldOutError
    {
        private const int MostGroups = 5;
        private const int FewestViews = 6;

        /// <summary>Root mean square distance over all views while held out, px; null with fewer than six views, or when the rest does not do.</summary>
        public static double? OfCamera(IReadOnlyList<BoardView> views, int width, int height, LensModel model)
        {
            return Over(views, (kept, held) =>
            {
                if (!CameraCalibrator.TryCalibrate(kept, width, height, model, true, out CameraCalibration? calibration, out _))
                    return null;
                return Squares(held.Select(view => new[] { view }), new[] { calibration!.Camera }, Pose.Identity);
            });
        }

        /// <summary>The same for pairs: both cameras and how they stand to each other come from the other pairs.</summary>
        public static double? OfPairs(IReadOnlyList<BoardPair> pairs, LensCamera left, LensCamera right, LensModel model)
        {
            return Over(pairs, (kept, held) =>
            {
                if (!CameraCalibrator.TryCalibrate(kept.Select(pair => pair.Left).ToArray(), left.Pinhole.Width, left.Pinhole.Height, model, true, out CameraCalibration? first, out _)
                    || !CameraCalibrator.TryCalibrate(kept.Select(pair => pair.Right).ToArray(), right.Pinhole.Width, right.Pinhole.Height, model, true, out CameraCalibration? second, out _)
                    || !StereoCalibrator.TryCalibrate(kept, first!.Camera, second!.Camera, null, true, out StereoCalibration? stereo, out _))
                    return null;
                return Squares(held.Select(pair => new[] { pair.Left, pair.Right }), new[] { first.Camera, second.Camera }, stereo!.Rig.LeftToRight);
            });
        }

        private static double? Over<T>(IReadOnlyList<T> items, Func<T[], T[], (double Squares, int Points)?> measure)
        {
            if (items.Count < FewestViews)
                return null;
            int groups = Math.Min(MostGroups, items.Count);
            double squares = 0;
            int points = 0;
            for (int group = 0; group < groups; group++)
            {
                T[] kept = items.Where((_, i) => i % groups != group).ToArray(), held = items.Where((_, i) => i % groups == group).ToArray();
                if (!(measure(kept, held) is (double, int) found))
                    return null;
                squares += found.Squares;
                points += found.Points;
            }

            return Math.Sqrt(squares / points);
        }

        /// <summary>Each board's pose alone, seen by one camera or both.</summary>
        private static (double Squares, int Points)? Squares(IEnumerable<BoardView[]> boards, LensCamera[] cameras, Pose leftToRight)
        {
            BundleCamera[] known = cameras.Select(camera => BundleCamera.Known(camera.Pinhole.Width, camera.Pinhole.Height)).ToArray();
            double[][] lenses = cameras.Select(CameraParameters.Of).ToArray();
            Pose[] rigs = cameras.Length == 1 ? new[] { Pose.Identity } : new[] { Pose.Identity, leftToRight };
            double squares = 0;
            int points = 0;
            foreach (BoardView[] views in boards)
            {
                BundleObservation[] observations = views.Select((view, camera) => new BundleObservation(camera, 0, view)).ToArray();
                if (!PlanarPoseEstimator.TryEstimate(views[0], cameras[0], out PlanarPose? pose, out _)
                    || BundleAdjuster.Solve(known, observations, new BundleState(lenses, rigs, new[] { pose!.Pose }), out NormalEquations? equations) == null)
                    return null;
                squares += equations!.Cost;
                points += equations.Points;
            }

            return (squares, points);
        }
    }
}
