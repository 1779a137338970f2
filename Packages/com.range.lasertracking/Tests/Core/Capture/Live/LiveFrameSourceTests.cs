using System;
using System.Diagnostics;
using System.Linq;
using System.Threading;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Capture.Live
{
    /// <summary>The thread and the queue; what the camera's life is like is LiveCameraLoopTests' matter.</summary>
    public sealed class LiveFrameSourceTests
    {
        [Test]
        public void TryRead_PicturesComeInOrder_WithIndicesAndTimes()
        {
            using var source = new LiveFrameSource(new GatedCamera(5), NowUs);
            using var frame = new Frame();
            int pictures = 0;
            long last = long.MinValue;
            for (int i = 0; pictures < 5; i++)
            {
                Assert.That(source.TryRead(frame), Is.True);
                Assert.That(frame.Index, Is.EqualTo(i));
                Assert.That(frame.TimeUs, Is.GreaterThan(last));
                last = frame.TimeUs;
                if (!frame.Color.IsPresent)
                    continue;
                Assert.That(frame.Color.Bytes[0], Is.EqualTo(pictures));
                pictures++;
            }

            Assert.That(source.Problems, Is.Empty);
        }

        [Test]
        public void TryRead_CameraMissing_GivesFramesWithoutPictureAndSaysWhy()
        {
            var camera = new ScriptedCamera { IsConnected = false };
            using var source = new LiveFrameSource(camera, NowUs, new LiveCameraSettings { ReadTimeoutMs = 5 });
            using var frame = new Frame();
            long last = long.MinValue;
            for (int i = 0; i < 10; i++)
            {
                Assert.That(source.TryRead(frame), Is.True);
                Assert.That(frame.Color.IsPresent, Is.False);
                Assert.That(frame.TimeUs, Is.GreaterThan(last));
                last = frame.TimeUs;
            }

            Assert.That(source.Problems.Single().What, Does.StartWith("camera A: not there"));
        }

        [Test]
        public void TryRead_ReaderThatIsLate_GetsTheNewestAndIsTold()
        {
            var camera = new GatedCamera(30);
            using var source = new LiveFrameSource(camera, NowUs, new LiveCameraSettings { QueueFrames = 4 });
            camera.WaitUntilDone();
            using var frame = new Frame();
            for (int i = 26; i < 30; i++)
            {
                Assert.That(source.TryRead(frame), Is.True);
                Assert.That(frame.Color.Bytes[0], Is.EqualTo(i));
            }

            Assert.That(source.DroppedCount, Is.EqualTo(26));
            Assert.That(source.Problems.Single().What, Does.Contain("26 dropped so far"));
        }

        [Test]
        public void Dispose_LibraryThatHangs_ReturnsAndLeavesNothingBehindOnceItDoes()
        {
            var camera = new GatedCamera(0) { Gate = new ManualResetEventSlim() };
            var source = new LiveFrameSource(camera, NowUs, new LiveCameraSettings { StopMs = 100 });
            Assert.That(camera.Reading.Wait(5000), Is.True);
            var watch = Stopwatch.StartNew();
            source.Dispose();
            Assert.That(watch.ElapsedMilliseconds, Is.LessThan(3000));
            using var frame = new Frame();
            Assert.That(source.TryRead(frame), Is.False);
            Assert.That(camera.Closed.IsSet, Is.False);
            camera.Gate.Set();
            Assert.That(camera.Closed.Wait(5000), Is.True, "its own thread closes the camera");
        }

        [Test]
        public void Dispose_WhileAnotherWaits_EndsIt()
        {
            var source = new LiveFrameSource(new ScriptedCamera { IsConnected = false }, NowUs, new LiveCameraSettings { ReadTimeoutMs = 60_000 });
            bool last = true;
            var reader = new Thread(() =>
            {
                using var frame = new Frame();
                while (last)
                    last = source.TryRead(frame);
            });
            reader.Start();
            Thread.Sleep(20);
            source.Dispose();
            Assert.That(reader.Join(5000), Is.True);
            Assert.That(last, Is.False);
        }

        private static long NowUs() => Stopwatch.GetTimestamp() * 1_000_000 / Stopwatch.Frequency;

        /// <summary>So many pictures at once, numbered; then silence.</summary>
        private sealed class GatedCamera : ILiveCamera
        {
            private readonly int _count;
            private readonly ManualResetEventSlim _done = new ManualResetEventSlim();
            private int _next;

            public GatedCamera(int count)
            {
                _count = count;
            }

            public ManualResetEventSlim? Gate { get; set; }

            public ManualResetEventSlim Reading { get; } = new ManualResetEventSlim();

            public ManualResetEventSlim Closed { get; } = new ManualResetEventSlim();

            public FrameSourceInfo Info { get; } = new FrameSourceInfo("camera B", 2, 2, 30, null);

            public System.Collections.Generic.IReadOnlyList<CameraSetting> Settings { get; } = Array.Empty<CameraSetting>();

            public void WaitUntilDone() => _done.Wait();

            public bool TryOpen(out string problem)
            {
                problem = "";
                return true;
            }

            public LiveReading Read(Frame frame, int timeoutMs, out string problem)
            {
                problem = "";
                Reading.Set();
                Gate?.Wait();
                if (_next == _count)
                {
                    _done.Set();
                    Thread.Sleep(1);
                    return LiveReading.Nothing;
                }

                frame.Begin(0, _next * 33_333);
                frame.Color.Reset(PixelFormat.Gray8, 2, 2, frame.TimeUs);
                frame.Color.Bytes.Fill((byte)_next++);
                return LiveReading.Picture;
            }

            public bool TrySet(CameraSetting setting) => true;

            public bool TryGet(CameraSetting setting, out double value)
            {
                value = setting.Asked;
                return true;
            }

            public bool TryGetUsed(CameraSetting setting, out double value)
            {
                value = 0;
                return false;
            }

            public void Close() => Closed.Set();
        }
    }
}
