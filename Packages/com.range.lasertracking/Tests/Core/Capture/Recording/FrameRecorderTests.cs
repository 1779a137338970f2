using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Capture.Recording
{
    public sealed class FrameRecorderTests
    {
        private string _folder = "";

        [SetUp]
        public void MakeFolder() => _folder = Directory.CreateDirectory(Path.Combine(Path.GetTempPath(), "range-recorder-" + Guid.NewGuid().ToString("N"))).FullName;

        [TearDown]
        public void RemoveFolder() => Directory.Delete(_folder, true);

        private string PathOf(string name) => Path.Combine(_folder, name);

        private static Frame Picture(PixelFormat format, int width, int height, long timeUs, int seed = 1)
        {
            var frame = new Frame();
            frame.Begin(0, timeUs);
            RandomFrames.Fill(new Random(seed), frame.Color, format, width, height, timeUs);
            return frame;
        }

        [Test]
        public void Recorder_Frames_ReadBackAsTheyWere()
        {
            List<Frame> frames = RandomFrames.Create(5, 40);
            string path = PathOf("sub/a.mkv");
            using (var recorder = new FrameRecorder(path, new FrameRecorderSettings { WaitsWhenFull = true, QueueLength = 2 }))
            {
                foreach (Frame frame in frames)
                    Assert.That(recorder.Add(frame), Is.True);
                recorder.Dispose();
                Assert.That((recorder.RecordedFrames, recorder.DroppedFrames, recorder.LeftOutPictures, recorder.Problem), Is.EqualTo((40L, 0L, 0L, "")));
            }

            using var source = new KinectRecordingSource(KinectRecording.Open(path));
            using var read = new Frame();
            for (int i = 0; i < frames.Count; i++)
            {
                Assert.That(source.TryRead(read), Is.True);
                Assert.That(read.Color.Bytes.SequenceEqual(frames[i].Color.Bytes), Is.True, "frame " + i);
                Assert.That(read.Depth.Bytes.SequenceEqual(frames[i].Depth.Bytes), Is.True, "frame " + i);
            }

            Assert.That(source.TryRead(read), Is.False);
        }

        [Test]
        public void Recorder_PaddedRows_AreStoredTight()
        {
            var frame = new Frame();
            frame.Color.Reset(PixelFormat.Nv12, 6, 4, 100, 16);
            new Random(1).NextBytes(frame.Color.Bytes);
            using (var recorder = new FrameRecorder(PathOf("a.mkv"), new FrameRecorderSettings()))
                recorder.Add(frame);
            using var source = new KinectRecordingSource(KinectRecording.Open(PathOf("a.mkv")));
            using var read = new Frame();
            Assert.That(source.TryRead(read), Is.True);
            for (int row = 0; row < 6; row++)
                Assert.That(read.Color.Bytes.Slice(row * 6, 6).SequenceEqual(frame.Color.Bytes.Slice(row * 16, 6)), Is.True, "row " + row);
        }

        [Test]
        public void Recorder_Region_ComesBackAtItsPlaceToTheBit([Values(PixelFormat.Bgra32, PixelFormat.Nv12, PixelFormat.Yuy2, PixelFormat.Gray8)] PixelFormat format)
        {
            Frame frame = Picture(format, 64, 40, 5000);
            Assert.That(PixelRegion.TryCreate(11, 7, 43, 30, 64, 40, out PixelRegion region), Is.True);
            using (var recorder = new FrameRecorder(PathOf("a.mkv"), new FrameRecorderSettings { Region = region }))
                recorder.Add(frame);
            using var source = new KinectRecordingSource(KinectRecording.Open(PathOf("a.mkv")));
            using var read = new Frame();
            Assert.That(source.TryRead(read), Is.True);
            Assert.That((source.Info.Width, source.Info.Height, read.Color.Width, read.Color.Height, read.Color.Format), Is.EqualTo((64, 40, 64, 40, format)));
            Assert.That(source.Problems, Is.Empty);
            using var expected = new Image();
            using var part = new Image();
            region.Crop(frame.Color, part);
            region.Restore(part, expected);
            Assert.That(read.Color.Bytes.SequenceEqual(expected.Bytes), Is.True);
            Assert.That(new FileInfo(PathOf("a.mkv")).Length, Is.LessThan(4000 + Image.TightSize(format, region.Width, region.Height)));
        }

        [Test]
        public void Recorder_Jpeg_DecodesToThePictureWithinItsQuality()
        {
            var frame = new Frame();
            frame.Color.Reset(PixelFormat.Yuy2, 64, 48, 100);
            for (int i = 0; i < frame.Color.SizeBytes; i++)
                frame.Color.Bytes[i] = (byte)(i % 2 == 0 ? 40 + i / 128 * 3 : 128);
            using (var recorder = new FrameRecorder(PathOf("a.mkv"), new FrameRecorderSettings { JpegQuality = 95 }))
                recorder.Add(frame);
            using KinectRecording recording = KinectRecording.Open(PathOf("a.mkv"));
            Assert.That(recording.ColorTrack!.Format, Is.EqualTo(KinectImageFormat.Mjpg));
            using var source = new KinectRecordingSource(recording);
            using var read = new Frame();
            Assert.That(source.TryRead(read), Is.True);
            Assert.That(source.Problems, Is.Empty);
            for (int i = 0; i < frame.Color.SizeBytes; i++)
                Assert.That((int)read.Color.Bytes[i], Is.EqualTo((int)frame.Color.Bytes[i]).Within(3), "byte " + i);
        }

        [Test]
        public void Recorder_DiskThatStalls_DropsAndCountsWithoutBlocking()
        {
            var stream = new TestStream();
            Frame frame = Picture(PixelFormat.Gray8, 8, 8, 1000);
            int accepted = 0;
            using var recorder = new FrameRecorder(stream, "stalled", new FrameRecorderSettings { QueueLength = 4 });
            stream.Stall.Reset();
            for (int i = 0; i < 50; i++)
            {
                frame.Color.TimeUs += 1000;
                accepted += recorder.Add(frame) ? 1 : 0;
            }

            Assert.That(accepted, Is.EqualTo(4));
            Assert.That(recorder.DroppedFrames, Is.EqualTo(46));
            stream.Stall.Set();
            recorder.Dispose();
            Assert.That((recorder.RecordedFrames, recorder.Problem), Is.EqualTo((4L, "")));
        }

        [Test]
        public void Recorder_DiskFull_SaysSoAndLeavesAWholeShorterFile()
        {
            var stream = new TestStream { RoomBytes = 60000 };
            Frame frame = Picture(PixelFormat.Gray8, 100, 100, 1000);
            var recorder = new FrameRecorder(stream, "full.mkv", new FrameRecorderSettings { WaitsWhenFull = true });
            int accepted = 0;
            for (int i = 0; i < 50; i++)
            {
                frame.Color.TimeUs += 33333;
                accepted += recorder.Add(frame) ? 1 : 0;
            }

            recorder.Dispose();
            Assert.That(recorder.Problem, Does.StartWith("full.mkv: the recording ends after 5 frames (no space left)").And.Not.Contain("\n"));
            Assert.That(recorder.DroppedFrames, Is.EqualTo(50 - accepted));
            using var recording = new KinectRecording(new MemoryStream(stream.Content), "full.mkv");
            Assert.That(recording.IsCut, Is.False);
            Assert.That(recording.Problems, Is.Empty);
            var capture = new KinectCapture();
            int captures = 0;
            while (recording.TryReadNext(capture))
                captures++;
            Assert.That(captures, Is.EqualTo(5));
        }

        [Test]
        public void Recorder_PictureOfAnotherSize_IsLeftOutAndCounted()
        {
            PixelRegion.TryCreate(0, 0, 8, 8, 16, 16, out PixelRegion region);
            var recorder = new FrameRecorder(PathOf("a.mkv"), new FrameRecorderSettings { Region = region });
            recorder.Add(Picture(PixelFormat.Gray8, 16, 16, 1000));
            recorder.Add(Picture(PixelFormat.Gray8, 18, 16, 2000));
            recorder.Add(Picture(PixelFormat.Bgra32, 16, 16, 3000));
            recorder.Dispose();
            Assert.That(recorder.LeftOutPictures, Is.EqualTo(2));
        }

        [Test]
        public void Recorder_NothingRecorded_LeavesNoFile()
        {
            new FrameRecorder(PathOf("a.mkv"), new FrameRecorderSettings()).Dispose();
            Assert.That(File.Exists(PathOf("a.mkv")), Is.False);
        }

        [Test]
        public void Recorder_FramesWithoutPicture_AreCounted()
        {
            var recorder = new FrameRecorder(PathOf("a.mkv"), new FrameRecorderSettings());
            Assert.That(recorder.Add(new Frame()), Is.False);
            recorder.Add(Picture(PixelFormat.Gray8, 8, 8, 1000));
            recorder.Dispose();
            Assert.That((recorder.LeftOutPictures, recorder.RecordedFrames, recorder.Problem), Is.EqualTo((1L, 1L, "")));
        }

        [Test]
        public void Recorder_PathThatCannotBe_IsRefusedInOneLine()
        {
            File.WriteAllText(PathOf("there.mkv"), "precious");
            foreach (string path in new[] { "", _folder, PathOf("there.mkv"), PathOf("there.mkv/below.mkv"), "\0" })
            {
                InputException problem = Assert.Throws<InputException>(() => new FrameRecorder(path, new FrameRecorderSettings()))!;
                Assert.That(problem.Message, Does.Not.Contain("\n").And.Contain("; "));
            }

            Assert.That(File.ReadAllText(PathOf("there.mkv")), Is.EqualTo("precious"));
        }

        [Test]
        public void Recorder_Warm_CostsTheCaptureThreadNoGarbage()
        {
            Frame frame = Picture(PixelFormat.Nv12, 320, 240, 1000);
            using var recorder = new FrameRecorder(PathOf("a.mkv"), new FrameRecorderSettings { WaitsWhenFull = true });
            long allocated = Allocation.Of(() =>
            {
                for (int i = 0; i < 10; i++)
                {
                    frame.Color.TimeUs += 33333;
                    recorder.Add(frame);
                }
            });
            Assert.That(allocated, Is.Zero);
        }

        /// <summary>A stream that can stall, and that is full some day.</summary>
        private sealed class TestStream : MemoryStream
        {
            public ManualResetEventSlim Stall { get; } = new ManualResetEventSlim(true);

            public long RoomBytes { get; set; } = long.MaxValue;

            public byte[] Content => ToArray();

            public override void Write(byte[] buffer, int offset, int count)
            {
                Stall.Wait();
                long room = RoomBytes - Position;
                base.Write(buffer, offset, (int)Math.Min(room, count));
                if (room < count)
                    throw new IOException("no space left");
            }

            public override void Write(ReadOnlySpan<byte> buffer)
            {
                byte[] bytes = buffer.ToArray();
                Write(bytes, 0, bytes.Length);
            }
        }
    }
}
