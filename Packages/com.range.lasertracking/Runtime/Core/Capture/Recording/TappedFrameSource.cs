using System;
using System.Collections.Generic;

namespace LaserTracking.Capture.Recording
{
    /// <summary>
    /// A source whose frames somebody else may see as they pass, in the order and on the thread in which they are read. Costs nothing
    /// while nobody looks. Owns the source.
    /// </summary>
    public sealed class TappedFrameSource : IFrameSource
    {
        private readonly IFrameSource _source;

        public TappedFrameSource(IFrameSource source)
        {
            _source = source;
        }

        /// <summary>Called with every frame before its reader gets it; must neither keep nor change it. May be set at any time, by any thread.</summary>
        public volatile Action<Frame>? Tap;

        public FrameSourceInfo Info => _source.Info;

        public IReadOnlyList<FrameProblem> Problems => _source.Problems;

        public bool TryRead(Frame frame)
        {
            if (!_source.TryRead(frame))
                return false;
            Tap?.Invoke(frame);
            return true;
        }

        public void Dispose() => _source.Dispose();
    }
}
