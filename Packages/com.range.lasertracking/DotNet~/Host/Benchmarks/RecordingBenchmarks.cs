using System;
using System.IO;
using LaserTracking.Capture;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Capture.Recording;
using LaserTracking.Imaging;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Benchmarks
{
    /// <summary>What recording costs without the disk: copies, checksum and layout; bytes a frame are those of its cluster.</summary>
    internal static class RecordingBenchmarks
    {
        private const int LoopFrames = 8;

        /// <summary>A whole frame, every bit of it, on the writer's thread.</summary>
        public static Action<int> Whole()
        {
            FrameLoop frames = BenchmarkList.DetectFrames(1280, 720, PixelFormat.Nv12, LoopFrames);
            var writer = new KinectRecordingWriter(new CountingStream(), KinectRecordingHead.Of(frames[0], KinectStreams.Color, 30));
            return number => writer.Write(frames[number]);
        }

        /// <summary>Only the screen's part: cut out on the capture thread, written on the writer's.</summary>
        public static Action<int> Screen(bool withWriting)
        {
            SimulatedRange range = FrameLoop.Range(1920, 1080, PixelFormat.Bgra32, 2, 2000, 90);
            var frames = new FrameLoop(range.CreateColorSource(), LoopFrames);
            if (!ScreenRegion.TryFind(range.Calibration, ScreenRegion.DefaultMarginPx, out PixelRegion region))
                throw new InvalidOperationException("the simulated camera does not see the screen");
            var part = new Frame();
            region.Crop(frames[0].Color, part.Color);
            KinectRecordingHead head = KinectRecordingHead.Of(part, KinectStreams.Color, 30);
            head.ColorRegion = region;
            var writer = new KinectRecordingWriter(new CountingStream(), head);
            return number =>
            {
                region.Crop(frames[number].Color, part.Color);
                if (withWriting)
                    writer.Write(part);
            };
        }

        /// <summary>As a JPEG, on the writer's thread.</summary>
        public static Action<int> Jpeg()
        {
            FrameLoop frames = BenchmarkList.DetectFrames(1280, 720, PixelFormat.Nv12, LoopFrames);
            KinectRecordingHead head = KinectRecordingHead.Of(frames[0], KinectStreams.Color, 30);
            head.ColorFormat = KinectImageFormat.Mjpg;
            var encoder = new JpegEncoder(90);
            var writer = new KinectRecordingWriter(new CountingStream(), head);
            return number =>
            {
                Frame frame = frames[number];
                writer.Write(frame, encoder.Encode(frame.Color));
            };
        }

        /// <summary>Takes everything and keeps nothing.</summary>
        private sealed class CountingStream : Stream
        {
            private long _length;

            public override bool CanRead => false;

            public override bool CanSeek => true;

            public override bool CanWrite => true;

            public override long Length => _length;

            public override long Position { get; set; }

            public override void Write(byte[] buffer, int offset, int count) => Write(buffer.AsSpan(offset, count));

            public override void Write(ReadOnlySpan<byte> buffer)
            {
                Position += buffer.Length;
                _length = Math.Max(_length, Position);
            }

            public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

            public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

            public override void SetLength(long value) => _length = value;

            public override void Flush()
            {
            }
        }
    }
}
