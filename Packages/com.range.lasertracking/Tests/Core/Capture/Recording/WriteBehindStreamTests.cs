using System;
using System.IO;
using System.Threading;
using NUnit.Framework;

namespace LaserTracking.Capture.Recording
{
    public sealed class WriteBehindStreamTests
    {
        [Test]
        public void Stream_PiecesOfAnySize_ArriveInOrder()
        {
            var written = new MemoryStream();
            var expected = new MemoryStream();
            var random = new Random(1);
            using (var stream = new WriteBehindStream(written, "events"))
            {
                for (int i = 0; i < 300; i++)
                {
                    var piece = new byte[random.Next(3000)];
                    random.NextBytes(piece);
                    stream.Write(piece, 0, piece.Length);
                    expected.Write(piece, 0, piece.Length);
                }

                stream.Drain();
                Assert.That(written.ToArray(), Is.EqualTo(expected.ToArray()), "drained");
                stream.Write(new byte[] { 1, 2 }, 0, 2);
                Assert.That(stream.Problem, Is.Empty);
            }

            Assert.That(written.ToArray(), Has.Length.EqualTo(expected.Length + 2), "completed as it closes");
        }

        [Test]
        public void Stream_DiskThatHangs_HoldsNobodyUpAndKeepsWholePieces()
        {
            var disk = new SlowDisk();
            using var stream = new WriteBehindStream(disk, "events", 100);
            stream.Write(new byte[10], 0, 10);
            disk.Reached.Wait();
            for (int i = 0; i < 30; i++)
                stream.Write(new byte[9], 0, 9);
            Assert.That(stream.Problem, Does.StartWith("events: ").And.Contain("keep up"));
            disk.Go.Set();
            stream.Dispose();
            Assert.That(disk.Written, Is.EqualTo(10 + 11 * 9), "all that there was room for, and nothing after it");
        }

        [Test]
        public void Stream_DiskThatIsFull_SaysSoOnceAndDoesNotThrow()
        {
            using var stream = new WriteBehindStream(new FullDisk(), "events");
            stream.Write(new byte[10], 0, 10);
            stream.Drain();
            stream.Write(new byte[10], 0, 10);
            stream.Dispose();
            Assert.That(stream.Problem, Is.EqualTo("events: the file ends early (no space left); make room or choose another place, and record again"));
        }

        [Test]
        [Category("Long")]
        public void Flusher_FileThatIsBeingWritten_IsFlushedWhileItIs()
        {
            string path = Path.Combine(Path.GetTempPath(), "range-flusher-" + Guid.NewGuid().ToString("N"));
            try
            {
                using (var file = new FileStream(path, FileMode.CreateNew, FileAccess.Write, FileShare.ReadWrite, 1))
                using (var flusher = new DiskFlusher(path, path + ".missing"))
                {
                    for (int i = 0; i < 400 && flusher.Rounds == 0; i++)
                    {
                        file.WriteByte(1);
                        Thread.Sleep(5);
                    }

                    Assert.That(flusher.Rounds, Is.Not.Zero);
                }

                File.Delete(path);
                Assert.That(File.Exists(path), Is.False);
            }
            finally
            {
                File.Delete(path);
            }
        }

        private sealed class SlowDisk : MemoryStream
        {
            public ManualResetEventSlim Reached { get; } = new ManualResetEventSlim();

            public ManualResetEventSlim Go { get; } = new ManualResetEventSlim();

            public long Written { get; private set; }

            public override void Write(byte[] buffer, int offset, int count)
            {
                Reached.Set();
                Go.Wait();
                Written += count;
            }
        }

        private sealed class FullDisk : MemoryStream
        {
            public override void Write(byte[] buffer, int offset, int count) => throw new IOException("no space left");
        }
    }
}
