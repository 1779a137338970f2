using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Scoring
{
    /// <summary>All recorded poses of one object. Between two of them it is interpolated as <see cref="PoseHistory"/> does. Immutable.</summary>
    public sealed class PoseTrack
    {
        private readonly double[] _timesS;
        private readonly Pose[] _poses;

        /// <param name="timesS">Rising, on the scene's clock; at least one.</param>
        /// <param name="poses">As many.</param>
        public PoseTrack(IReadOnlyList<double> timesS, IReadOnlyList<Pose> poses)
        {
            if (timesS.Count == 0 || timesS.Count != poses.Count)
                throw new ArgumentException("a track needs poses, each with its time");
            _timesS = new double[timesS.Count];
            _poses = new Pose[timesS.Count];
            for (int i = 0; i < _timesS.Length; i++)
            {
                if (!(i == 0 || timesS[i] > timesS[i - 1]))
                    throw new ArgumentException("the times of a track rise");
                _timesS[i] = timesS[i];
                _poses[i] = poses[i];
            }
        }

        /// <summary>The pose at a time; before the first and after the last it is the first and the last. No allocation.</summary>
        public Pose PoseAt(double timeS)
        {
            int found = Array.BinarySearch(_timesS, timeS);
            int after = found >= 0 ? found + 1 : ~found;
            if (after == 0 || after == _timesS.Length)
                return _poses[after == 0 ? 0 : after - 1];
            double part = (timeS - _timesS[after - 1]) / (_timesS[after] - _timesS[after - 1]);
            return PoseHistory.Between(_poses[after - 1], _poses[after], part);
        }
    }
}
