using System;
using System.Collections.Generic;

namespace LaserTracking.Capture
{
    /// <summary>
    /// Frames that somebody else makes and pushes in, for devices that only one thread may touch. The reader waits for them; when it
    /// falls behind the oldest are left out.
    /// </summary>
    public sealed class PushedFrameSource : IFrameSource
    {
        private readonly FrameMailbox _mailbox = new FrameMailbox();

        public PushedFrameSource(FrameSourceInfo info)
        {
            Info = info;
        }

        public FrameSourceInfo Info { get; }

        /// <summary>Always none.</summary>
        public IReadOnlyList<FrameProblem> Problems { get; } = Array.Empty<FrameProblem>();

        /// <summary>The next frame pushed will cost none that waits: who can wait himself loses nothing.</summary>
        public bool HasRoom => _mailbox.HasRoom;

        /// <summary>Frames left out so far because they were not read in time.</summary>
        public long Dropped => _mailbox.Dropped;

        /// <summary>Takes the frame's content and gives back an older one to fill next; from one thread at a time.</summary>
        public void Push(Frame filled) => _mailbox.Put(filled);

        /// <summary>Nothing more will come: the reader gets what waits, then the end. Any thread.</summary>
        /// <param name="failure">Thrown to the reader then; null: a usual end.</param>
        public void Close(Exception? failure = null) => _mailbox.Close(failure);

        public bool TryRead(Frame frame) => _mailbox.TryTake(frame);

        /// <summary>Pushing is over too: what comes later is ignored.</summary>
        public void Dispose() => _mailbox.Close();
    }
}
