using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text;
using LaserTracking.Capture.Matroska;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Capture.AzureKinect
{
    public sealed class KinectRecordingWriterTests
    {
        private static byte[] Record(IReadOnlyList<Frame> frames, Action<KinectRecordingHead>? prepare = null, bool finish = true)
        {
            var stream = new MemoryStream();
            KinectRecordingHead head = KinectRecordingHead.Of(frames[0], KinectStreams.All, 30);
            prepare?.Invoke(head);
            var writer = new KinectRecordingWriter(stream, head);
            foreach (Frame frame in frames)
                Assert.That(writer.Write(frame), Is.True);
            if (finish)
                writer.Finish();
            return stream.ToArray();
        }

        private static KinectRecording Open(byte[] file) => new KinectRecording(new MemoryStream(file), "test");

        private static void AssertSame(Image actual, Image expected, string what)
        {
            Assert.That(actual.IsPresent, Is.EqualTo(expected.IsPresent), what);
            if (!expected.IsPresent)
                return;
            Assert.That((actual.Format, actual.Width, actual.Height, actual.TimeUs), Is.EqualTo((expected.Format, expected.Width, expected.Height, expected.TimeUs)), what);
            Assert.That(actual.Bytes.SequenceEqual(expected.Bytes), Is.True, what + ": other bytes");
        }

        /// <summary>Number of frames that came back, all of them as they went in.</summary>
        private static int AssertSameFrames(byte[] file, IReadOnlyList<Frame> frames, out IReadOnlyList<FrameProblem> problems)
        {
            using var source = new KinectRecordingSource(Open(file));
            using var read = new Frame();
            int count = 0;
            for (; source.TryRead(read); count++)
            {
                Assert.That(read.Index, Is.EqualTo(count));
                AssertSame(read.Color, frames[count].Color, "colour of " + count);
                AssertSame(read.Depth, frames[count].Depth, "depth of " + count);
                AssertSame(read.Infrared, frames[count].Infrared, "infrared of " + count);
            }

            problems = source.Problems;
            return count;
        }

        [Test]
        public void Writer_RandomFrames_ComeBackToTheBit()
        {
            for (int seed = 0; seed < 200; seed++)
            {
                List<Frame> frames = RandomFrames.Create(seed, 1 + seed % 9);
                byte[] file = Record(frames);
                Assert.That(AssertSameFrames(file, frames, out IReadOnlyList<FrameProblem> problems), Is.EqualTo(frames.Count), "seed " + seed);
                Assert.That(problems.Where(p => !p.What.Contains("K4A_DEPTH_MODE")), Is.Empty, "seed " + seed);
                using KinectRecording recording = Open(file);
                Assert.That(recording.IsCut, Is.False);
            }
        }

        [Test]
        public void Writer_KinectSizes_ReadWithoutAnyProblem([Values(true, false)] bool withDepth)
        {
            var frame = new Frame();
            var random = new Random(1);
            frame.Begin(0, 5000);
            RandomFrames.Fill(random, frame.Color, PixelFormat.Nv12, 1280, 720, 5000);
            if (withDepth)
                RandomFrames.Fill(random, frame.Depth, PixelFormat.Depth16, 640, 576, 5100);
            RandomFrames.Fill(random, frame.Infrared, PixelFormat.Infrared16, withDepth ? 640 : 1024, withDepth ? 576 : 1024, 5100);
            byte[] calibration = Encoding.UTF8.GetBytes("{\"CalibrationInformation\":{}}");
            byte[] file = Record(new[] { frame }, head => (head.DeviceCalibration, head.SerialNumber) = (calibration, "000123"));
            using KinectRecording recording = Open(file);
            recording.VerifiesChecksums = true;
            var capture = new KinectCapture();
            Assert.That(recording.TryReadNext(capture), Is.True);
            Assert.That(recording.Problems, Is.Empty);
            Assert.That(recording.Configuration.DepthMode, Is.EqualTo(withDepth ? KinectDepthMode.NfovUnbinned : KinectDepthMode.PassiveIr));
            Assert.That(recording.Configuration.StartOffsetUs, Is.EqualTo(5000));
            Assert.That(recording.DeviceSerialNumber, Is.EqualTo("000123"));
            Assert.That(recording.TryReadCalibration(out byte[] stored), Is.True);
            Assert.That(stored, Is.EqualTo(calibration));
            Assert.That(recording.Tracks.Select(t => t.Name), Is.EqualTo(withDepth ? new[] { "COLOR", "DEPTH", "IR" } : new[] { "COLOR", "IR" }));
        }

        [Test]
        public void Writer_KilledAtAnyByte_LeavesEveryFrameBeforeReadable()
        {
            List<Frame> frames = RandomFrames.Create(11, 6);
            AssertReadableWhereverCut(frames, finish: false);
        }

        [Test]
        public void Writer_FinishedFileCutAtAnyByte_LeavesEveryFrameBeforeReadable()
        {
            List<Frame> frames = RandomFrames.Create(12, 5);
            AssertReadableWhereverCut(frames, finish: true);
        }

        private static void AssertReadableWhereverCut(List<Frame> frames, bool finish)
        {
            // Where each frame is wholly written: the writer says so.
            var stream = new MemoryStream();
            var writer = new KinectRecordingWriter(stream, KinectRecordingHead.Of(frames[0], KinectStreams.All, 30));
            var wholeAt = new List<long>();
            foreach (Frame frame in frames)
            {
                writer.Write(frame);
                wholeAt.Add(writer.WrittenBytes);
            }

            if (finish)
                writer.Finish();
            byte[] file = stream.ToArray();
            for (int length = 0; length < file.Length; length++)
            {
                byte[] cut = file.AsSpan(0, length).ToArray();
                int whole = wholeAt.Count(end => end <= length);
                try
                {
                    int blocks = CountFrames(cut, frames, out bool isCut);
                    Assert.That(blocks, Is.GreaterThanOrEqualTo(whole), "cut at " + length);
                    Assert.That(isCut, Is.True, "cut at " + length + ": not said");
                }
                catch (InputException problem)
                {
                    Assert.That(whole, Is.Zero, "cut at " + length + ": " + problem.Message);
                    Assert.That(problem.Message, Does.Not.Contain("\n"));
                }
            }
        }

        /// <summary>Frames that read, whole ones first: the last may lack a picture that the cut took.</summary>
        private static int CountFrames(byte[] cut, List<Frame> frames, out bool isCut)
        {
            using KinectRecording recording = Open(cut);
            using var source = new KinectRecordingSource(recording);
            using var read = new Frame();
            int count = 0;
            for (; source.TryRead(read); count++)
            {
                if (read.Color.IsPresent)
                    AssertSame(read.Color, frames[count].Color, "colour of " + count);
                if (read.Depth.IsPresent)
                    AssertSame(read.Depth, frames[count].Depth, "depth of " + count);
            }

            isCut = recording.IsCut;
            return count;
        }

        [Test]
        public void Writer_Unfinished_SaysSoAndLosesNothing()
        {
            List<Frame> frames = RandomFrames.Create(21, 7);
            byte[] file = Record(frames, finish: false);
            Assert.That(AssertSameFrames(file, frames, out IReadOnlyList<FrameProblem> problems), Is.EqualTo(7));
            Assert.That(problems.Count(p => p.What.Contains("stopped before it could finish")), Is.EqualTo(1));
        }

        [Test]
        public void Writer_PastFourGigabytes_KeepsSizesAndPositions()
        {
            const long Hole = 5L << 30;
            List<Frame> frames = RandomFrames.Create(31, 6);
            var stream = new HoleStream();
            var writer = new KinectRecordingWriter(stream, KinectRecordingHead.Of(frames[0], KinectStreams.All, 30));
            for (int i = 0; i < frames.Count; i++)
            {
                // A second apart, so that frames behind the hole get cues of their own.
                frames[i].Color.TimeUs += i * 1000000;
                frames[i].Depth.TimeUs += i * 1000000;
                frames[i].Infrared.TimeUs += i * 1000000;
                if (i == 3)
                    stream.WriteVoid(Hole);
                writer.Write(frames[i]);
            }

            writer.Finish();
            Assert.That(stream.Length, Is.GreaterThan(Hole));
            using var recording = new KinectRecording(stream, "large");
            using var source = new KinectRecordingSource(recording);
            using var read = new Frame();
            int count = 0;
            for (; source.TryRead(read); count++)
                AssertSame(read.Color, frames[count].Color, "colour of " + count);
            Assert.That(count, Is.EqualTo(6));
            Assert.That((recording.IsCut, recording.LengthUs > 5000000), Is.EqualTo((false, true)));
            recording.Seek(0, KinectSeekOrigin.End);
            Assert.That(recording.TryReadPrevious(new KinectCapture()), Is.True);
        }

        [Test]
        public void Writer_TwoRuns_WriteTheSameBytes() =>
            Assert.That(Record(RandomFrames.Create(41, 8)), Is.EqualTo(Record(RandomFrames.Create(41, 8))));

        [Test]
        public void Writer_PictureThatHasNoPlace_IsCountedNotWritten()
        {
            List<Frame> frames = RandomFrames.Create(3, 2, 1000000);
            var writer = new KinectRecordingWriter(new MemoryStream(), new KinectRecordingHead { ColorFormat = KinectImageFormat.Bgra32, ColorWidth = 4, ColorHeight = 2 });
            var frame = new Frame();
            frame.Begin(0, 1000);
            RandomFrames.Fill(new Random(1), frame.Color, PixelFormat.Bgra32, 4, 2, 1000);
            Assert.That(writer.Write(frame), Is.True);
            frame.Color.Reset(PixelFormat.Bgra32, 6, 2, 2000);
            Assert.That((writer.Write(frame), writer.LeftOut), Is.EqualTo((false, 1)));
            frame.Color.Reset(PixelFormat.Nv12, 4, 2, 2000);
            Assert.That((writer.Write(frame), writer.LeftOut), Is.EqualTo((false, 2)));
            frame.Color.Reset(PixelFormat.Bgra32, 4, 2, 999);
            Assert.That((writer.Write(frame), writer.LeftOut), Is.EqualTo((false, 3)), "before the recording's first");
            frame.Color.Reset(PixelFormat.Bgra32, 4, 2, long.MaxValue);
            Assert.That((writer.Write(frame), writer.LeftOut), Is.EqualTo((false, 4)));
        }

        [Test]
        public void Writer_Warm_AllocatesNothing()
        {
            var frame = new Frame();
            var random = new Random(1);
            RandomFrames.Fill(random, frame.Color, PixelFormat.Nv12, 320, 240, 1000);
            RandomFrames.Fill(random, frame.Depth, PixelFormat.Depth16, 160, 120, 1000);
            var stream = new MemoryStream(64 << 20);
            var writer = new KinectRecordingWriter(stream, KinectRecordingHead.Of(frame, KinectStreams.All, 30));
            long allocated = Allocation.Of(() =>
            {
                stream.Position = Math.Max(0, stream.Position);
                for (int i = 0; i < 20; i++)
                {
                    frame.Color.TimeUs += 33333;
                    frame.Depth.TimeUs += 33333;
                    writer.Write(frame);
                }
            });
            Assert.That(allocated, Is.Zero);
        }

        [Test]
        public void Copier_RecordingWithEveryTrack_KeepsAllBlocksTagsAndAttachments()
        {
            List<Frame> frames = RandomFrames.Create(51, 9);
            byte[] unfinished = Record(frames, head => head.DeviceCalibration = new byte[] { 1, 2, 3 }, finish: false);
            using KinectRecording source = Open(unfinished);
            var target = new MemoryStream();
            long blocks = KinectRecordingCopier.Copy(source, target);
            Assert.That(blocks, Is.EqualTo(frames.Sum(f => (f.Color.IsPresent ? 1 : 0) + (f.Depth.IsPresent ? 1 : 0) + (f.Infrared.IsPresent ? 1 : 0))));
            Assert.That(AssertSameFrames(target.ToArray(), frames, out _), Is.EqualTo(frames.Count));
            using KinectRecording copy = Open(target.ToArray());
            Assert.That(copy.IsCut, Is.False, "made whole");
            Assert.That(copy.Tags.Select(t => (t.Name, t.Value, t.TrackUid)), Is.EqualTo(source.Tags.Select(t => (t.Name, t.Value, t.TrackUid))));
            Assert.That(copy.TryReadCalibration(out byte[] json) ? json : null, Is.EqualTo(new byte[] { 1, 2, 3 }));
        }

        [Test]
        public void Varint_EverySize_ReadsBack([Values(0L, 1, 126, 127, 128, 16382, 16383, (1L << 21) - 1, 1L << 32, (1L << 49) - 1, (1L << 56) - 2)] long size)
        {
            var bytes = new byte[EbmlVarint.SizeLengthOf(size)];
            EbmlVarint.WriteSize(bytes, size);
            Assert.That(EbmlVarint.TryReadSize(bytes, out long read, out int length), Is.True);
            Assert.That((read, length), Is.EqualTo((size, bytes.Length)));
        }
    }
}
