using System.Collections.Generic;
using System.Linq;
using LaserTracking.Calibration;

namespace LaserTracking.Host.Calibration
{
    /// <summary>The three calibrations of a stereo session: each camera alone, from all it saw, then both.</summary>
    internal sealed class StereoSession
    {
        private StereoSession(CameraCalibration left, CameraCalibration right, StereoCalibration both, IReadOnlyList<LeftOutView> missing)
        {
            Left = left;
            Right = right;
            Both = both;
            Missing = missing;
        }

        public CameraCalibration Left { get; }

        public CameraCalibration Right { get; }

        public StereoCalibration Both { get; }

        /// <summary>Views that are not there or were left out when each camera was calibrated alone; their pairs are left out too.</summary>
        public IReadOnlyList<LeftOutView> Missing { get; }

        /// <param name="left">As many places as right.</param>
        /// <param name="right">Partners of left.</param>
        /// <param name="model">Of both lenses.</param>
        /// <param name="isFree">Whether the cameras' own numbers are sought again together.</param>
        /// <param name="keepsAll">Also views that do not fit the others.</param>
        /// <param name="source">For messages.</param>
        /// <exception cref="InputException">It cannot be solved; the message says why.</exception>
        public static StereoSession Run(SeenBoards left, SeenBoards right, LensModel model, bool isFree, bool keepsAll, string source)
        {
            CameraCalibration first = Alone(left, model, keepsAll, source, "left"), second = Alone(right, model, keepsAll, source, "right");
            if (first.IsMirrored != second.IsMirrored)
                throw new InputException(source, $"the boards appear mirrored to the {(first.IsMirrored ? "left" : "right")} camera only", "give its corners in the order of the other one's, and its pictures unmirrored");
            BoardPair[] pairs = left.Views.Zip(right.Views).Where(pair => first.Views.Contains(pair.First!) && second.Views.Contains(pair.Second!)).Select(pair => new BoardPair(pair.First!, pair.Second!)).ToArray();
            if (!StereoCalibrator.TryCalibrate(pairs, first.Camera, second.Camera, isFree ? model : null, keepsAll, out StereoCalibration? both, out string reason))
                throw new InputException(source, reason, "see './range help calibrate stereo'");
            LeftOutView[] missing = left.Missing().Concat(first.LeftOut).Concat(right.Missing()).Concat(second.LeftOut).ToArray();
            return new StereoSession(first, second, both!, missing);
        }

        private static CameraCalibration Alone(SeenBoards seen, LensModel model, bool keepsAll, string source, string side) =>
            CameraCalibrator.TryCalibrate(seen.Views.OfType<BoardView>().ToArray(), seen.Width, seen.Height, model, keepsAll, out CameraCalibration? found, out string reason)
                ? found!
                : throw new InputException(source, side + " camera: " + reason, "see './range help calibrate stereo'");
    }
}
