using System;
using LaserTracking.Capture;
using LaserTracking.Detection;

namespace LaserTracking.Pipeline
{
    /// <summary>
    /// Plays recorded or simulated pictures of the projector into the history, in step with the camera: before each of its frames, all
    /// that had been drawn by then. One thread at a time.
    /// </summary>
    public sealed class RenderedFeed : IDisposable
    {
        private readonly IFrameSource _pictures;
        private readonly RenderedFrameHistory _history;
        private readonly long _clockOffsetUs;
        private readonly long _leadUs;
        private readonly Frame _next = new Frame();
        private bool _hasStarted;
        private bool _hasNext;

        /// <param name="pictures">Colour frames whose times are those of drawing; stays the caller's.</param>
        /// <param name="history">Where they go.</param>
        /// <param name="clockOffsetUs">Added to the pictures' times to bring them on the camera's clock.</param>
        /// <param name="leadUs">How much later than the camera's frame a picture may have been drawn: where the offset is not exact.</param>
        public RenderedFeed(IFrameSource pictures, RenderedFrameHistory history, long clockOffsetUs, long leadUs)
        {
            _pictures = pictures;
            _history = history;
            _clockOffsetUs = clockOffsetUs;
            _leadUs = leadUs;
        }

        /// <summary>Adds the pictures drawn until a moment on the camera's clock.</summary>
        public void AdvanceTo(long cameraTimeUs)
        {
            if (!_hasStarted)
                _hasNext = _pictures.TryRead(_next);
            _hasStarted = true;
            while (_hasNext && _next.TimeUs + _clockOffsetUs <= cameraTimeUs + _leadUs)
            {
                if (_next.Color.IsPresent)
                    _history.Add(_next.Color, _next.TimeUs + _clockOffsetUs);
                _hasNext = _pictures.TryRead(_next);
            }
        }

        public void Dispose() => _next.Dispose();
    }
}
