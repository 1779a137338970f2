using System;
using System.Collections.Generic;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Capture
{
    public sealed class PrefetchingFrameSourceTests
    {
        [Test]
        public void PrefetchingFrameSource_AnyDepth_GivesTheSameFramesInOrder([Values(1, 2, 5)] int depth)
        {
            using (var source = new PrefetchingFrameSource(new CountingSource(20, -1), depth))
            using (var frame = new Frame())
            {
                for (int i = 0; i < 20; i++)
                {
                    Assert.That(source.TryRead(frame), Is.True);
                    Assert.That(frame.Index, Is.EqualTo(i));
                    Assert.That(frame.Color.Bytes[0], Is.EqualTo((byte)i));
                }

                Assert.That(source.TryRead(frame), Is.False);
            }
        }

        [Test]
        public void PrefetchingFrameSource_SourceThrows_ThrowsAfterTheFramesBefore()
        {
            using (var source = new PrefetchingFrameSource(new CountingSource(20, 3), 2))
            using (var frame = new Frame())
            {
                for (int i = 0; i < 3; i++)
                    Assert.That(source.TryRead(frame), Is.True);
                Assert.That(() => source.TryRead(frame), Throws.InstanceOf<InputException>());
            }
        }

        [Test]
        public void PrefetchingFrameSource_DisposedEarly_ReleasesTheSource()
        {
            var inner = new CountingSource(1000, -1);
            var source = new PrefetchingFrameSource(inner, 2);
            source.Dispose();
            Assert.That(inner.IsDisposed, Is.True);
        }

        private sealed class CountingSource : IFrameSource
        {
            private readonly int _frames;
            private readonly int _failAt;
            private int _next;

            public CountingSource(int frames, int failAt)
            {
                _frames = frames;
                _failAt = failAt;
            }

            public bool IsDisposed { get; private set; }

            public FrameSourceInfo Info { get; } = new FrameSourceInfo("counting", 4, 2, 30, null);

            public IReadOnlyList<FrameProblem> Problems { get; } = Array.Empty<FrameProblem>();

            public bool TryRead(Frame frame)
            {
                if (_next == _failAt)
                    throw new InputException("counting", "the end of what is known", "count again");
                if (_next == _frames)
                    return false;
                frame.Begin(_next, _next * 33333L);
                frame.Color.Reset(PixelFormat.Gray8, 4, 2, frame.TimeUs);
                frame.Color.Bytes.Fill((byte)_next);
                _next++;
                return true;
            }

            public void Dispose() => IsDisposed = true;
        }
    }
}
