using System;
using System.Collections.Generic;
using System.Threading;

namespace LaserTracking.Capture
{
    /// <summary>
    /// Reads a live device on a thread of its own, so that no frame waits in its driver: the reader gets them in order, and when it
    /// falls behind the oldest are left out. Owns the device; its exception is thrown by <see cref="TryRead"/>.
    /// </summary>
    public sealed class LiveFrameSource : IFrameSource
    {
        /// <summary>How long a device may take to answer when it is closed; then its thread is left to close it later.</summary>
        public const int CloseTimeoutMs = 1000;

        private readonly IFrameSource _device;
        private readonly FrameMailbox _mailbox = new FrameMailbox();
        private readonly List<FrameProblem> _problems = new List<FrameProblem>();
        private readonly List<FrameProblem> _newProblems = new List<FrameProblem>();
        private readonly Thread _thread;
        private volatile bool _isStopping;

        /// <param name="device">Read and disposed by this object's thread from now on.</param>
        public LiveFrameSource(IFrameSource device)
        {
            _device = device;
            Info = device.Info;
            _thread = new Thread(Capture) { IsBackground = true, Name = "camera " + device.Info.Name };
            _thread.Start();
        }

        public FrameSourceInfo Info { get; }

        /// <summary>Grows when frames are read.</summary>
        public IReadOnlyList<FrameProblem> Problems => _problems;

        /// <summary>Frames left out so far because they were not read in time.</summary>
        public long Dropped => _mailbox.Dropped;

        /// <summary>The device gives no more frames.</summary>
        public bool HasEnded => _mailbox.IsClosed;

        /// <summary>The next frame, waiting for it; false when the device has ended.</summary>
        public bool TryRead(Frame frame)
        {
            bool isRead = _mailbox.TryTake(frame);
            TakeProblems();
            return isRead;
        }

        /// <summary>The next frame if there is one by now; false means nothing more than that.</summary>
        public bool TryReadNow(Frame frame)
        {
            bool isRead = _mailbox.TryTakeNow(frame);
            TakeProblems();
            return isRead;
        }

        /// <summary>Lets a reader that waits go, with the end of the stream. Any thread.</summary>
        public void Stop()
        {
            _isStopping = true;
            _mailbox.Close();
        }

        public void Dispose()
        {
            Stop();
            // A driver that hangs must not hang the caller: its thread closes the device if it ever comes back.
            if (_thread.Join(CloseTimeoutMs))
                _mailbox.Dispose();
        }

        private void Capture()
        {
            using var frame = new Frame();
            int known = 0;
            try
            {
                while (!_isStopping && _device.TryRead(frame))
                {
                    known = PassOnProblems(known);
                    _mailbox.Put(frame);
                }

                PassOnProblems(known);
                _mailbox.Close();
            }
            catch (Exception problem)
            {
                _mailbox.Close(problem);
            }
            finally
            {
                _device.Dispose();
            }
        }

        private int PassOnProblems(int known)
        {
            if (known == _device.Problems.Count)
                return known;
            lock (_newProblems)
            {
                for (; known < _device.Problems.Count; known++)
                    _newProblems.Add(_device.Problems[known]);
            }

            return known;
        }

        private void TakeProblems()
        {
            lock (_newProblems)
            {
                _problems.AddRange(_newProblems);
                _newProblems.Clear();
            }
        }
    }
}
