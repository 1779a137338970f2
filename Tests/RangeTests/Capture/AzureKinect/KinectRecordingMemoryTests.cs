using System;
using System.IO;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>What reading a recording costs.</summary>
    [Category("Reference")]
    public sealed class KinectRecordingMemoryTests
    {
        /// <summary>A recording is read in 2 MB of live memory beyond two captures.</summary>
        private const long Budget = 2000000;

        [TestCase("rec_bgra.mkv")]
        [TestCase("rec_hand_nfov.mkv")]
        [TestCase("rec_laser_720p_mjpg.mkv")]
        [TestCase("rec_small_remuxed.mkv")]
        public void KinectRecordingSource_WhileReading_StaysWithinItsBudget(string name)
        {
            string path = TestFiles.Reference("k4a", name);
            Read(path, out _);
            long before = GC.GetTotalMemory(forceFullCollection: true);
            Read(path, out long during);
            Assert.That(during - before, Is.LessThan(Budget));
            TestContext.Out.WriteLine(name + ": " + (during - before) + " bytes live");
        }

        [TestCase("rec_hand_nfov.mkv")]
        [TestCase("rec_laser_720p_mjpg.mkv")]
        public void KinectRecordingSource_WarmLoopOverAFile_AllocatesNothing(string name)
        {
            using var source = new KinectRecordingSource(KinectRecording.Open(TestFiles.Reference("k4a", name)));
            source.Recording.VerifiesChecksums = true;
            using var frame = new Frame();
            long allocated = Allocation.Of(() =>
            {
                while (source.TryRead(frame))
                {
                }

                source.Recording.SeekToStart();
            });
            Assert.That(allocated, Is.Zero);
        }

        [Test]
        public void KinectRecording_UnwantedPayloads_AreNotRead()
        {
            using var counting = new CountingStream(File.OpenRead(TestFiles.Reference("k4a", "rec_hand_nfov.mkv")));
            using var source = new KinectRecordingSource(new KinectRecording(counting, "counted"), KinectStreams.Infrared);
            using var frame = new Frame();
            long infrared = 0;
            while (source.TryRead(frame))
                infrared += frame.Infrared.SizeBytes;
            Assert.That(infrared, Is.GreaterThan(1000000));
            Assert.That(counting.BytesRead, Is.LessThan(infrared + 500000), "of a file of 7.6 MB");
        }

        /// <summary>Reads all frames; tells the live memory when the last has been read and everything is still held.</summary>
        private static void Read(string path, out long liveBytes)
        {
            using var source = new KinectRecordingSource(KinectRecording.Open(path));
            source.Recording.VerifiesChecksums = true;
            using var frame = new Frame();
            while (source.TryRead(frame))
            {
            }

            liveBytes = GC.GetTotalMemory(forceFullCollection: true);
            GC.KeepAlive(source);
        }

        private sealed class CountingStream : Stream
        {
            private readonly Stream _inner;

            public CountingStream(Stream inner) => _inner = inner;

            public long BytesRead { get; private set; }

            public override bool CanRead => true;

            public override bool CanSeek => true;

            public override bool CanWrite => false;

            public override long Length => _inner.Length;

            public override long Position { get => _inner.Position; set => _inner.Position = value; }

            public override int Read(Span<byte> buffer)
            {
                int read = _inner.Read(buffer);
                BytesRead += read;
                return read;
            }

            public override int Read(byte[] buffer, int offset, int count) => Read(buffer.AsSpan(offset, count));

            public override long Seek(long offset, SeekOrigin origin) => _inner.Seek(offset, origin);

            public override void Flush()
            {
            }

            public override void SetLength(long value) => throw new NotSupportedException();

            public override void Write(byte[] buffer, int offset, int count) => throw new NotSupportedException();

            protected override void Dispose(bool disposing) => _inner.Dispose();
        }
    }
}
