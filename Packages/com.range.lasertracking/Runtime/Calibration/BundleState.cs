using System;
using LaserTracking.Geometry;

namespace LaserTracking.Calibration
{
    /// <summary>All numbers that a bundle adjustment moves: lenses, the cameras' poses beside camera 0, the boards' poses before it.</summary>
    internal sealed class BundleState
    {
        /// <param name="lenses">One of <see cref="CameraParameters"/> a camera.</param>
        /// <param name="rigs">X_camera = R X_0 + T, one a camera; identity for camera 0.</param>
        /// <param name="boards">X_0 = R X_board + T, one a board.</param>
        public BundleState(double[][] lenses, Pose[] rigs, Pose[] boards)
        {
            Lenses = lenses;
            Rigs = rigs;
            Boards = boards;
        }

        public double[][] Lenses { get; }

        public Pose[] Rigs { get; }

        public Pose[] Boards { get; }

        /// <summary>Another state, moved by a step: the cameras' unknowns one camera after the other, then six a board.</summary>
        public BundleState Moved(BundleCamera[] cameras, double[] step)
        {
            var lenses = new double[cameras.Length][];
            var rigs = (Pose[])Rigs.Clone();
            var boards = new Pose[Boards.Length];
            int at = 0;
            for (int c = 0; c < cameras.Length; c++)
            {
                lenses[c] = (double[])Lenses[c].Clone();
                foreach (int index in cameras[c].FreeLens)
                    lenses[c][index] += step[at++];
                if (!cameras[c].IsPoseFree)
                    continue;
                rigs[c] = Turned(rigs[c], step.AsSpan(at, 6));
                at += 6;
            }

            for (int b = 0; b < boards.Length; b++, at += 6)
                boards[b] = Turned(Boards[b], step.AsSpan(at, 6));
            return new BundleState(lenses, rigs, boards);
        }

        /// <summary>A small turn is applied on the left: no parametrisation of rotations, and nowhere a singular one.</summary>
        private static Pose Turned(Pose pose, ReadOnlySpan<double> step)
        {
            var turn = new Vector3D(step[0], step[1], step[2]);
            return new Pose(pose.Position + new Vector3D(step[3], step[4], step[5]), Rotation3D.AboutAxis(turn, turn.Length) * pose.Rotation);
        }
    }
}
