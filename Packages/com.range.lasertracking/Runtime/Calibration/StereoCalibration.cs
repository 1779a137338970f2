using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Calibration
{
    /// <summary>Two cameras beside each other determined from views of a board by both at once, with all that says how far to trust it.</summary>
    public sealed class StereoCalibration
    {
        internal StereoCalibration(StereoRig rig, double rmsPx, IReadOnlyList<BoardPair> pairs, double[] perPairRmsPx, Pose[] boardPoses,
            double[] rigDeviations, IReadOnlyList<LeftOutView> leftOut, IReadOnlyList<string> notes)
        {
            Rig = rig;
            RmsPx = rmsPx;
            Pairs = pairs;
            PerPairRmsPx = perPairRmsPx;
            BoardPoses = boardPoses;
            RigDeviations = rigDeviations;
            LeftOut = leftOut;
            Notes = notes;
        }

        public StereoRig Rig { get; }

        /// <summary>Root mean square distance between measured and projected points of both cameras, px.</summary>
        public double RmsPx { get; }

        /// <summary>Pairs that were used; a right view may have been turned by 180° to agree with its left one.</summary>
        public IReadOnlyList<BoardPair> Pairs { get; }

        /// <summary>Of each pair used, px.</summary>
        public double[] PerPairRmsPx { get; }

        /// <summary>Board to camera 0 for each pair used, in the board's unit.</summary>
        public Pose[] BoardPoses { get; }

        /// <summary>Standard deviations of the rotation (three, rad) and of the translation (three, the board's unit) between the cameras.</summary>
        public double[] RigDeviations { get; }

        /// <summary>Pairs that were not used.</summary>
        public IReadOnlyList<LeftOutView> LeftOut { get; }

        /// <summary>What the user should know, one line each.</summary>
        public IReadOnlyList<string> Notes { get; }

        /// <summary>Measured minus projected, px, for each point of one camera's view in a pair used.</summary>
        public IEnumerable<Vector2D> ResidualsPx(int pair, bool ofRight)
        {
            BoardView view = ofRight ? Pairs[pair].Right : Pairs[pair].Left;
            var state = new BundleState(System.Array.Empty<double[]>(), new[] { Pose.Identity, Rig.LeftToRight }, new[] { BoardPoses[pair] });
            return BundleAdjuster.ResidualsPx(new BundleObservation(ofRight ? 1 : 0, 0, view), ofRight ? Rig.Right : Rig.Left, state);
        }
    }
}
