using System;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Hands
{
    /// <summary>
    /// The published method: pixels inside the depth gate AND changed against the frame before; the hand's distance is the median of
    /// a 5×5 patch, and an assumed one where that is empty. One hand, no arm axis, blind to a hand that keeps still. The authors took
    /// the hand's pixel from a landmark model; here it is the middle of the moving pixels, or whatever is given to
    /// <see cref="Locate"/>.
    /// </summary>
    public sealed unsafe class PublishedHandTracker : IHandTracker
    {
        private readonly PinholeCamera _camera;
        private readonly PublishedHandSettings _settings;
        private ushort[] _previous = Array.Empty<ushort>();
        private bool _hasPrevious;
        private int _width;

        /// <exception cref="ArgumentException">A setting is outside its range.</exception>
        public PublishedHandTracker(PinholeCamera camera, PublishedHandSettings? settings = null)
        {
            _camera = camera;
            _settings = settings ?? new PublishedHandSettings();
            _settings.Validate();
        }

        /// <summary>At most one hand. The first frame has no frame before it and gives none.</summary>
        public void Process(Frame frame, HandObservations observations)
        {
            observations.Begin(frame.Index, frame.Depth.IsPresent ? frame.Depth.TimeUs : frame.TimeUs);
            Image depth = frame.Depth;
            if (!depth.IsPresent || depth.Format != PixelFormat.Depth16)
                return;
            int pixels = depth.Width * depth.Height;
            if (_previous.Length != pixels || _width != depth.Width)
            {
                _previous = new ushort[pixels];
                _width = depth.Width;
                _hasPrevious = false;
            }

            long count = 0, sumX = 0, sumY = 0;
            for (int y = 0; y < depth.Height; y++)
            {
                var row = new ReadOnlySpan<ushort>(depth.Pixels + (long)y * depth.Stride, depth.Width);
                Span<ushort> before = _previous.AsSpan(y * depth.Width, depth.Width);
                if (_hasPrevious)
                {
                    for (int x = 0; x < row.Length; x++)
                    {
                        int z = row[x];
                        if (z < _settings.NearMm || z > _settings.FarMm || Math.Abs(z - before[x]) < _settings.MotionMm)
                            continue;
                        count++;
                        sumX += x;
                        sumY += y;
                    }
                }

                row.CopyTo(before);
            }

            bool moved = _hasPrevious && count > 0 && count >= _settings.MinMovingShare * pixels;
            _hasPrevious = true;
            if (moved)
                observations.Add(Locate(depth, sumX / (double)count, sumY / (double)count));
        }

        /// <summary>The hand at a pixel of the depth picture: 5×5 median, or the assumed distance, marked as such.</summary>
        public HandObservation Locate(Image depth, double xPx, double yPx)
        {
            bool measured = DepthPatch.TryMedian(depth, (int)Math.Round(xPx), (int)Math.Round(yPx), _settings.PatchRadiusPx,
                _settings.NearMm, _settings.FarMm, out double z);
            Vector3D palm = _camera.Unproject(xPx, yPx, measured ? z : _settings.AssumedDepthMm);
            double sigma = measured ? _settings.MeasuredSigmaMm : _settings.AssumedSigmaMm;
            return new HandObservation
            {
                TrackId = 1,
                PalmMm = palm,
                MuzzleMm = palm,
                SigmaMm = sigma,
                MuzzleSigmaMm = sigma,
                DepthSource = measured ? DepthSource.Measured : DepthSource.Assumed,
            };
        }

        public void Reset() => _hasPrevious = false;
    }
}
