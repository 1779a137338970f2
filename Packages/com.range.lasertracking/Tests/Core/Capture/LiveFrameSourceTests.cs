using System;
using System.Collections.Generic;
using System.Threading;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Capture
{
    public sealed class LiveFrameSourceTests
    {
        [Test]
        public void FrameMailbox_ReaderThatIsLate_GetsTheNewestInOrderAndTheRestIsCounted()
        {
            using var mailbox = new FrameMailbox(3);
            using var frame = new Frame();
            for (int i = 0; i < 10; i++)
                Put(mailbox, frame, i);
            mailbox.Close();
            Assert.That(mailbox.Dropped, Is.EqualTo(7));
            for (int i = 7; i < 10; i++)
            {
                Assert.That(mailbox.TryTake(frame), Is.True);
                Assert.That((frame.Index, (int)frame.Color.Bytes[0]), Is.EqualTo((i, i)));
            }

            Assert.That(mailbox.TryTake(frame), Is.False);
            Assert.That(mailbox.TryTakeNow(frame), Is.False);
        }

        [Test]
        public void FrameMailbox_OnceWarm_AllocatesNothing()
        {
            using var mailbox = new FrameMailbox(2);
            using var frame = new Frame();
            Assert.That(Allocation.Of(() =>
            {
                for (int i = 0; i < 20; i++)
                {
                    Put(mailbox, frame, i);
                    if (i % 3 != 0)
                        mailbox.TryTakeNow(frame);
                }
            }), Is.Zero);
        }

        [Test]
        public void LiveFrameSource_DeviceThatEnds_GivesWhatItHadAndThenTheEnd()
        {
            var device = new Device(2);
            using (var live = new LiveFrameSource(device))
            using (var frame = new Frame())
            {
                Assert.That(live.TryRead(frame) && live.TryRead(frame), Is.True);
                Assert.That(frame.Index, Is.EqualTo(1));
                Assert.That(live.TryRead(frame), Is.False);
                Assert.That(live.HasEnded, Is.True);
                Assert.That(live.Problems, Has.Count.EqualTo(1));
            }

            Assert.That(device.IsDisposed, Is.True);
        }

        [Test]
        public void LiveFrameSource_DeviceThatFails_FailsAtTheReader()
        {
            using var live = new LiveFrameSource(new Device(-1));
            using var frame = new Frame();
            Assert.That(() => live.TryRead(frame), Throws.TypeOf<InputException>());
        }

        [Test]
        public void LiveFrameSource_StoppedWhileTheReaderWaits_LetsItGo()
        {
            using var answers = new ManualResetEventSlim();
            var device = new Device(5) { Gate = answers };
            using var live = new LiveFrameSource(device);
            bool isRead = true;
            var reader = new Thread(() =>
            {
                using var frame = new Frame();
                isRead = live.TryRead(frame);
            });
            reader.Start();
            using (var frame = new Frame())
                Assert.That(live.TryReadNow(frame), Is.False, "nothing by now, and no waiting");
            live.Stop();
            Assert.That(reader.Join(5000), Is.True);
            Assert.That(isRead, Is.False);
            answers.Set();
        }

        [Test]
        public void PushedFrameSource_Frames_ArriveUntilItIsClosed()
        {
            using var source = new PushedFrameSource(new FrameSourceInfo("pushed", 4, 1, 0, null));
            using var frame = new Frame();
            frame.Begin(3, 30);
            source.Push(frame);
            source.Close();
            frame.Begin(4, 40);
            source.Push(frame);
            Assert.That(source.TryRead(frame), Is.True);
            Assert.That(frame.Index, Is.EqualTo(3));
            Assert.That(source.TryRead(frame), Is.False);
        }

        private static void Put(FrameMailbox mailbox, Frame frame, int index)
        {
            frame.Begin(index, index);
            frame.Color.Reset(PixelFormat.Gray8, 4, 1, index);
            frame.Color.Bytes[0] = (byte)index;
            mailbox.Put(frame);
        }

        private sealed class Device : IFrameSource
        {
            private readonly int _frames;
            private readonly List<FrameProblem> _problems = new List<FrameProblem>();
            private int _next;

            public Device(int frames) => _frames = frames;

            public ManualResetEventSlim? Gate { get; set; }

            public bool IsDisposed { get; private set; }

            public FrameSourceInfo Info { get; } = new FrameSourceInfo("device", 4, 1, 30, null);

            public IReadOnlyList<FrameProblem> Problems => _problems;

            public bool TryRead(Frame frame)
            {
                Gate?.Wait();
                if (_frames < 0)
                    throw new InputException("device", "broken", "mend it");
                if (_next == _frames)
                    _problems.Add(new FrameProblem(-1, "unplugged"));
                if (_next >= _frames)
                    return false;
                frame.Begin(_next, _next * 1000L);
                _next++;
                return true;
            }

            public void Dispose() => IsDisposed = true;
        }
    }
}
