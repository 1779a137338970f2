using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Calibration
{
    /// <summary>A camera determined from views of a board, with all that says how far to trust it.</summary>
    public sealed class CameraCalibration
    {
        internal CameraCalibration(LensCamera camera, LensModel model, double rmsPx, IReadOnlyList<BoardView> views, double[] perViewRmsPx, Pose[] boardPoses,
            double[] standardDeviations, IReadOnlyList<LeftOutView> leftOut, IReadOnlyList<string> notes, bool isMirrored)
        {
            Camera = camera;
            Model = model;
            RmsPx = rmsPx;
            Views = views;
            PerViewRmsPx = perViewRmsPx;
            BoardPoses = boardPoses;
            StandardDeviations = standardDeviations;
            LeftOut = leftOut;
            Notes = notes;
            IsMirrored = isMirrored;
        }

        public LensCamera Camera { get; }

        public LensModel Model { get; }

        /// <summary>Root mean square distance between measured and projected points, px.</summary>
        public double RmsPx { get; }

        /// <summary>Views that were used.</summary>
        public IReadOnlyList<BoardView> Views { get; }

        /// <summary>Of each view used, px.</summary>
        public double[] PerViewRmsPx { get; }

        /// <summary>Board to camera for each view used, in the board's unit.</summary>
        public Pose[] BoardPoses { get; }

        /// <summary>Of each of <see cref="CameraParameters"/>: px for the first four; 0 where a parameter is not determined by the model.</summary>
        public double[] StandardDeviations { get; }

        /// <summary>Views that were not used.</summary>
        public IReadOnlyList<LeftOutView> LeftOut { get; }

        /// <summary>What the user should know, one line each.</summary>
        public IReadOnlyList<string> Notes { get; }

        /// <summary>All boards appear mirrored: a mirrored picture, or points that run the wrong way round. The camera's own numbers hold either way.</summary>
        public bool IsMirrored { get; }

        /// <summary>Measured minus projected, px, for each point of a view used.</summary>
        public IEnumerable<Vector2D> ResidualsPx(int view)
        {
            var state = new BundleState(new[] { CameraParameters.Of(Camera) }, new[] { Pose.Identity }, new[] { BoardPoses[view] });
            return BundleAdjuster.ResidualsPx(new BundleObservation(0, 0, Views[view]), Camera, state);
        }
    }
}
