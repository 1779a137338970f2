using System;
using System.Collections.Generic;

namespace LaserTracking.Capture
{
    /// <summary>
    /// A stream of frames of one camera: a recording, a video, a folder of pictures, a simulated or a live camera. Memory is
    /// bounded: nothing is read further ahead than a few frames. Calls come from one thread at a time.
    /// </summary>
    public interface IFrameSource : IDisposable
    {
        FrameSourceInfo Info { get; }

        /// <summary>What was found damaged so far, in order of discovery. Grows while frames are read, up to a documented bound.</summary>
        IReadOnlyList<FrameProblem> Problems { get; }

        /// <summary>
        /// Fills the next frame, in order of time. False at the end of the stream. A picture that cannot be decoded is absent from
        /// its frame (and a problem); it never ends the stream.
        /// </summary>
        bool TryRead(Frame frame);
    }
}
