using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Calibration;
using LaserTracking.Host.Studies.Calibration;

namespace LaserTracking.Host.Benchmarks
{
    /// <summary>Two cameras from the corners of 13 simulated pairs: each alone, then how they stand to each other.</summary>
    internal static class StereoBenchmark
    {
        private const int Pairs = 13;
        private const double SigmaPx = 0.2;

        /// <summary>The corners as a file, for the peer.</summary>
        public static string Corners()
        {
            var boards = new SimulatedBoards(1);
            return boards.Format(boards.Pairs(Pairs, SigmaPx));
        }

        public static Action<int> Prepare()
        {
            var boards = new SimulatedBoards(1);
            List<BoardPair> pairs = boards.Pairs(Pairs, SigmaPx);
            BoardView[] left = pairs.Select(pair => pair.Left).ToArray(), right = pairs.Select(pair => pair.Right).ToArray();
            int width = boards.Truth.Left.Pinhole.Width, height = boards.Truth.Left.Pinhole.Height;
            return _ =>
            {
                if (!CameraCalibrator.TryCalibrate(left, width, height, LensModel.Brown5, false, out CameraCalibration? first, out string reason)
                    || !CameraCalibrator.TryCalibrate(right, width, height, LensModel.Brown5, false, out CameraCalibration? second, out reason)
                    || !StereoCalibrator.TryCalibrate(pairs, first!.Camera, second!.Camera, null, false, out StereoCalibration? _, out reason))
                    throw new InvalidOperationException(reason);
            };
        }
    }
}
