using System.Linq;
using NUnit.Framework;

namespace LaserTracking.Capture.Live
{
    /// <summary>Frames and their times; what the camera's life is like is LiveCameraLoopTests' matter.</summary>
    public sealed class LiveCameraSourceTests
    {
        private static readonly LiveCameraSettings Quick = new LiveCameraSettings { ReadTimeoutMs = 5, FirstRetryMs = 1, LongestRetryMs = 1 };

        [Test]
        public void TryRead_CameraThatIsWell_GivesPicturesWithIndicesAndTimes()
        {
            var camera = new ScriptedCamera();
            using var source = new LiveCameraSource(camera, () => camera.NowUs);
            using var frame = new Frame();
            for (int i = 0; i < 20; i++)
            {
                Assert.That(source.TryRead(frame), Is.True);
                Assert.That(frame.Index, Is.EqualTo(i));
                Assert.That(frame.Color.IsPresent, Is.True);
                Assert.That(frame.TimeUs, Is.EqualTo(camera.NowUs).Within(1));
            }

            Assert.That(source.Problems, Is.Empty);
        }

        [Test]
        public void TryRead_CameraMissing_GivesFramesWithoutPictureAndSaysWhy()
        {
            var camera = new ScriptedCamera { IsConnected = false };
            using var source = new LiveCameraSource(camera, () => camera.NowUs, Quick);
            using var frame = new Frame();
            long last = long.MinValue;
            for (int i = 0; i < 10; i++)
            {
                Assert.That(source.TryRead(frame), Is.True);
                Assert.That(frame.Index, Is.EqualTo(i));
                Assert.That(frame.Color.IsPresent, Is.False);
                Assert.That(frame.TimeUs, Is.GreaterThan(last));
                last = frame.TimeUs;
            }

            Assert.That(source.Problems.Single().What, Does.StartWith("camera A: not there"));
        }

        [Test]
        public void TryRead_SilenceUnpluggingAndReturn_TimesRiseAndAreThoseOfTheLight()
        {
            var camera = new ScriptedCamera { LatencyUs = 40_000 };
            using var source = new LiveCameraSource(camera, () => camera.NowUs, new LiveCameraSettings { ReadTimeoutMs = 20, FirstRetryMs = 1, LongestRetryMs = 1, LatencyMs = 40 });
            using var frame = new Frame();
            long last = long.MinValue;
            int pictures = 0;
            for (int i = 0; i < 400; i++)
            {
                camera.IsSilent = i > 100 && i < 130;
                camera.IsConnected = i < 200 || i > 220;
                camera.NowUs += camera.IsConnected ? 2_000 : 20_000;
                if (i == 220)
                    camera.DeviceOffsetUs = -camera.NowUs;
                Assert.That(source.TryRead(frame), Is.True);
                Assert.That(frame.TimeUs, Is.GreaterThan(last));
                last = frame.TimeUs;
                if (!frame.Color.IsPresent)
                    continue;
                pictures++;
                Assert.That(frame.TimeUs, Is.EqualTo(camera.NowUs - 40_000).Within(1));
            }

            Assert.That(pictures, Is.GreaterThan(330));
        }

        [Test]
        public void Dispose_GivesTheCameraBack_AndNothingIsReadAnyMore()
        {
            var camera = new ScriptedCamera();
            var source = new LiveCameraSource(camera, () => camera.NowUs);
            using var frame = new Frame();
            source.TryRead(frame);
            Assert.That(camera.IsOpen, Is.True);
            source.Dispose();
            source.Dispose();
            Assert.That(camera.IsOpen, Is.False);
            Assert.That(source.TryRead(frame), Is.False);
        }

        [Test]
        public void TryRead_Warm_AllocatesNothing()
        {
            var camera = new ScriptedCamera();
            using var source = new LiveCameraSource(camera, () => camera.NowUs);
            using var frame = new Frame();
            Assert.That(Allocation.Of(() =>
            {
                for (int i = 0; i < 200; i++)
                    source.TryRead(frame);
            }), Is.Zero);
        }
    }
}
