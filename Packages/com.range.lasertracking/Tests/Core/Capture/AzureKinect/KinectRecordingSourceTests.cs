using System;
using System.IO;
using LaserTracking.Imaging;
using LaserTracking.Capture.Matroska;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    public sealed class KinectRecordingSourceTests
    {
        [Test]
        public void KinectRecordingSource_WarmLoop_AllocatesNothing()
        {
            using var source = new KinectRecordingSource(Long(300), KinectStreams.All);
            source.Recording.VerifiesChecksums = true;
            using var frame = new Frame();
            for (int i = 0; i < 50; i++)
                source.TryRead(frame);
            int frames = 0;
            long allocated = Allocation.Of(() =>
            {
                for (int i = 0; i < 30; i++)
                    frames += source.TryRead(frame) ? 1 : 0;
            });
            Assert.That(allocated, Is.Zero);
            Assert.That(frames, Is.EqualTo(7 * 30));
        }

        [Test]
        public void KinectRecordingSource_WantingOnlyDepth_LeavesTheRestOutAndKeepsIndices()
        {
            using var source = new KinectRecordingSource(Long(10), KinectStreams.Depth);
            using var frame = new Frame();
            for (int i = 0; i < 10; i++)
            {
                Assert.That(source.TryRead(frame), Is.True);
                Assert.That(frame.Index, Is.EqualTo(i));
                Assert.That(frame.Color.IsPresent, Is.False);
                Assert.That(frame.Infrared.IsPresent, Is.False);
                Assert.That(frame.Depth.IsPresent, Is.EqualTo(i % 2 == 0));
                Assert.That(frame.TimeUs, Is.EqualTo(i * 33333L + (i % 2 == 0 ? 7 : 0)), "depth's own time where there is depth");
            }

            Assert.That(source.TryRead(frame), Is.False);
        }

        [Test]
        public void KinectRecordingSource_ColorAndDepth_CarryTheirOwnTimesAndFormats()
        {
            using var source = new KinectRecordingSource(Long(3));
            using var frame = new Frame();
            source.TryRead(frame);
            Assert.That(frame.Color.Format, Is.EqualTo(PixelFormat.Nv12));
            Assert.That(frame.Depth.Format, Is.EqualTo(PixelFormat.Depth16));
            Assert.That(frame.Color.TimeUs, Is.EqualTo(0));
            Assert.That(frame.Depth.TimeUs, Is.EqualTo(7));
            Assert.That(frame.TimeUs, Is.EqualTo(0));
            Assert.That(source.Info.Width, Is.EqualTo(RecordingMuxer.Width));
            Assert.That(source.Info.NominalFramesPerSecond, Is.EqualTo(30));
        }

        [Test]
        public void KinectRecordingSource_SkipTo_ContinuesWithThatFrame()
        {
            using var source = new KinectRecordingSource(Long(20));
            using var frame = new Frame();
            foreach (int index in new[] { 7, 8, 15, 3, 0, 19 })
            {
                Assert.That(source.TrySkipTo(index), Is.True);
                Assert.That(source.TryRead(frame), Is.True);
                Assert.That(frame.Index, Is.EqualTo(index));
            }

            Assert.That(source.TrySkipTo(25), Is.False);
        }

        [Test]
        public void KinectRecordingSource_JpegThatCannotBeUsed_LeavesTheFrameInWithAProblem()
        {
            byte[] whole = Jpeg(RecordingMuxer.Width, RecordingMuxer.Height);
            byte[] half = whole.AsSpan(0, whole.Length / 2).ToArray();
            byte[] otherSize = Jpeg(RecordingMuxer.Width * 2, RecordingMuxer.Height);
            var muxer = new RecordingMuxer();
            muxer.AddVideo(RecordingMuxer.Color, "COLOR", "MJPG");
            ulong time = 0;
            foreach (byte[] jpeg in new[] { whole, half, whole, otherSize, new byte[70000], whole })
            {
                muxer.AddCluster(time, RecordingMuxer.SimpleBlock(RecordingMuxer.Color, 0, 0x80, jpeg));
                time += 33333;
            }

            using var source = new KinectRecordingSource(new KinectRecording(new MemoryStream(muxer.ToArray()), "test"));
            using var frame = new Frame();
            for (int i = 0; i < 6; i++)
            {
                Assert.That(source.TryRead(frame), Is.True);
                Assert.That(frame.Index, Is.EqualTo(i));
                Assert.That(frame.Color.IsPresent, Is.EqualTo(i == 0 || i == 2 || i == 5));
            }

            Assert.That(source.Problems.Count, Is.EqualTo(3));
            Assert.That(source.Problems[0].FrameIndex, Is.EqualTo(1));
            Assert.That(source.Problems[1].What, Does.Contain("32×8"));
            Assert.That(source.Problems[2].What, Does.Contain("larger than the raw picture"));

            static byte[] Jpeg(int width, int height)
            {
                using var picture = new Image();
                picture.Reset(PixelFormat.Nv12, width, height, 0);
                picture.Bytes.Fill(128);
                return new JpegEncoder().Encode(picture).ToArray();
            }
        }

        [TestCase(true)]
        [TestCase(false)]
        [Category("Long")]
        public void KinectRecording_ThousandsOfClusters_SeeksExactlyWithABoundedIndex(bool withCues)
        {
            const int Captures = 10000;
            KinectRecording recording = Long(Captures, withCues, colorOnly: true);
            var capture = new KinectCapture();
            var random = new Random(5);
            for (int i = 0; i < 300; i++)
            {
                long index = random.Next(Captures);
                recording.Seek(index * 33333, KinectSeekOrigin.Begin);
                Assert.That(recording.TryReadNext(capture), Is.True);
                Assert.That(capture.Color.DeviceTimeUs, Is.EqualTo(index * 33333));
                Assert.That(recording.TryReadPrevious(capture), Is.EqualTo(index > 0));
                if (index > 0)
                    Assert.That(capture.Color.DeviceTimeUs, Is.EqualTo((index - 1) * 33333));
            }

            recording.Seek(0, KinectSeekOrigin.End);
            int count = 0;
            while (recording.TryReadPrevious(capture))
                count++;
            Assert.That(count, Is.EqualTo(Captures));
        }

        private static KinectRecording Long(int captures, bool withCues = true, bool colorOnly = false)
        {
            RecordingMuxer muxer = RecordingMuxer.WithAllTracks();
            muxer.WritesCues = withCues;
            byte[] color = RecordingMuxer.Picture(RecordingMuxer.Color, 0);
            byte[] depth = RecordingMuxer.Picture(RecordingMuxer.Depth, 7);
            byte[] motion = RecordingMuxer.SimpleBlock(RecordingMuxer.Imu, 9, 0, RecordingMuxer.ImuSample(0));
            for (int i = 0; i < captures; i++)
                muxer.AddCluster((ulong)i * 33333, color, i % 2 == 0 && !colorOnly ? depth : new byte[0], motion);
            return new KinectRecording(new MemoryStream(muxer.ToArray()), "test");
        }
    }
}
