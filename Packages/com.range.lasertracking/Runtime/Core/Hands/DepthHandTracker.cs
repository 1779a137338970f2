using System;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Hands
{
    /// <summary>
    /// Finds the hands of several people in depth alone, moving or not: connected surfaces within the gate, in each the parts that
    /// stand out before the torso, of each its axis, hand and muzzle. Bridges a hand whose depth is lost from its outline, its
    /// forearm and its motion, and marks it. Needs a depth picture of camera 1, which looks at the trainees from the screen.
    /// </summary>
    public sealed class DepthHandTracker : IHandTracker
    {
        private readonly DepthGrid _grid;
        private readonly BodySegmenter _segmenter;
        private readonly ArmFitter _fitter;
        private readonly HandTrackSet _tracks;
        private readonly ArmFit[] _fits;

        /// <param name="camera">Of the depth picture; for a smaller or larger picture of the same view it is scaled.</param>
        /// <param name="settings">Null: the defaults. Read once, here.</param>
        /// <exception cref="ArgumentException">A setting is outside its range.</exception>
        public DepthHandTracker(PinholeCamera camera, DepthHandSettings? settings = null)
        {
            DepthHandSettings used = settings ?? new DepthHandSettings();
            used.Validate();
            _grid = new DepthGrid(camera, used);
            _segmenter = new BodySegmenter(used);
            _fitter = new ArmFitter(used);
            _tracks = new HandTrackSet(used);
            _fits = new ArmFit[_segmenter.Arms.Length];
        }

        public void Process(Frame frame, HandObservations observations)
        {
            Image depth = frame.Depth;
            bool usable = depth.IsPresent && depth.Format == PixelFormat.Depth16;
            observations.Begin(frame.Index, usable ? depth.TimeUs : frame.TimeUs);
            if (!usable)
                return;
            _grid.Fill(depth);
            _segmenter.Segment(_grid);
            int count = 0;
            for (int i = 0; i < _segmenter.ArmCount; i++)
            {
                ref readonly ArmPart arm = ref _segmenter.Arms[i];
                if (_fitter.TryFit(_grid, _segmenter.CellsOf(arm), arm, out ArmFit fit))
                    _fits[count++] = fit;
            }

            _tracks.Update(_grid, depth.TimeUs, new ReadOnlySpan<ArmFit>(_fits, 0, count), observations);
        }

        public void Reset() => _tracks.Reset();
    }
}
