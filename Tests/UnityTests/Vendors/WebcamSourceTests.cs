using System;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Capture.Live;
using LaserTracking.Imaging;
using LaserTracking.OpenCv;
using NUnit.Framework;
using OpenCvSharp;
using OpenCvStandIn;
using UnityEngine;
using UnityStandIn;

namespace LaserTracking.Unity
{
    /// <summary>The webcam source over OpenCvSharp's stand-in, with cameras of every manner.</summary>
    public sealed class WebcamSourceTests : StandInTests
    {
        private readonly VirtualClock _clock = new VirtualClock();
        private FakeWebcam _webcam = null!;

        [SetUp]
        public void Connect()
        {
            FakeWebcam.Reset();
            _webcam = new FakeWebcam { IntervalMs = 0 };
        }

        [Test]
        public void Source_GivesPictures_AsAskedFor()
        {
            using LiveCameraSource source = Webcam().CreateSource(_clock.NowUs);
            using var frame = new Frame();
            for (int i = 1; i <= 10; i++)
            {
                Assert.That(source.TryRead(frame), Is.True);
                Assert.That((frame.Color.Format, frame.Color.Width, frame.Color.Height), Is.EqualTo((PixelFormat.Bgra32, 64, 48)));
                Assert.That(frame.Color.Bytes.ToArray().Where((_, at) => at % 4 != 3), Is.All.EqualTo((byte)i));
                Assert.That(frame.Color.Bytes.ToArray().Where((_, at) => at % 4 == 3), Is.All.EqualTo((byte)255));
            }

            Assert.That(_webcam.SetLog.Take(4), Is.EqualTo(new[] { VideoCaptureProperties.FourCC, VideoCaptureProperties.FrameWidth, VideoCaptureProperties.FrameHeight, VideoCaptureProperties.Fps }));
            Assert.That(_webcam.Value(VideoCaptureProperties.FourCC), Is.EqualTo(0x47504A4D), "MJPG");
            Assert.That(source.Problems, Is.Empty);
        }

        [TestCase(PixelFormat.Gray8, 0)]
        [TestCase(PixelFormat.Yuy2, 8)]
        [TestCase(PixelFormat.Bgra32, 24)]
        public void Source_PicturesOfOtherKinds_AreTakenAsTheyAre(PixelFormat format, int type)
        {
            _webcam.Type = new MatType(type);
            using LiveCameraSource source = Webcam().CreateSource(_clock.NowUs);
            using var frame = new Frame();
            source.TryRead(frame);
            Assert.That(frame.Color.Format, Is.EqualTo(format));
            Assert.That(frame.Color.Bytes.ToArray(), Is.All.EqualTo((byte)1), "padding of rows is left out");
        }

        [Test]
        public void Source_OfUnknownKind_IsSaid()
        {
            _webcam.Type = new MatType(5);
            _clock.StepUs = 900_000;
            using LiveCameraSource source = Webcam().CreateSource(_clock.NowUs);
            Read(source, 6);
            Assert.That(source.Problems[0].What, Does.Contain("its pictures are of a kind that is not known here"));
        }

        [TestCase(WebcamBackend.VideoForLinux, 78)]
        [TestCase(WebcamBackend.DirectShow, -7)]
        [TestCase(WebcamBackend.MediaFoundation, -7)]
        public void Source_LocksExposureGainAndWhiteBalance_InTheDriversUnits(WebcamBackend backend, double exposure)
        {
            WebcamSource asset = Webcam();
            SerializedFields.Set(asset, "_backend", backend);
            SerializedFields.Set(asset, "_gain", 3);
            using LiveCameraSource source = asset.CreateSource(_clock.NowUs);
            Read(source, 300);
            Assert.That((int)_webcam.Backend, Is.EqualTo((int)backend));
            Assert.That(_webcam.Value(VideoCaptureProperties.Exposure), Is.EqualTo(exposure));
            Assert.That(_webcam.Value(VideoCaptureProperties.AutoExposure), Is.EqualTo(backend == WebcamBackend.VideoForLinux ? 1 : -1));
            Assert.That(_webcam.Value(VideoCaptureProperties.AutoWB), Is.Zero);
            Assert.That(_webcam.Value(VideoCaptureProperties.WBTemperature), Is.EqualTo(4500));
            Assert.That(_webcam.Value(VideoCaptureProperties.Gain), Is.EqualTo(3));
            Assert.That(source.Problems, Is.Empty);
        }

        [Test]
        public void Source_ExposureRefused_IsSaid()
        {
            _webcam.StubbornExposure = 333;
            using LiveCameraSource source = Webcam().CreateSource(_clock.NowUs);
            Read(source, 600);
            Assert.That(source.Problems.Single().What, Is.EqualTo("webcam 0: exposure: asked for 7813 µs, the camera has 33300 µs; lock it in the program of the camera's maker, or use another camera"));
        }

        [Test]
        public void Source_SettingsThatItHasNot_AreSaid()
        {
            _webcam.Missing.Add(VideoCaptureProperties.WBTemperature);
            _webcam.Missing.Add(VideoCaptureProperties.Exposure);
            using LiveCameraSource source = Webcam().CreateSource(_clock.NowUs);
            Read(source, 600);
            Assert.That(source.Problems.Select(problem => problem.What.Split(';')[0]), Is.EquivalentTo(new[]
            {
                "webcam 0: exposure: asked for 7813 µs, the camera does not tell what it has",
                "webcam 0: white balance: asked for 4500 K, the camera does not tell what it has",
            }));
        }

        [Test]
        public void Source_OtherSizeThanAskedFor_IsSaidAndNotUsed()
        {
            _webcam.OnlySize = (320, 240);
            using LiveCameraSource source = Webcam().CreateSource(_clock.NowUs);
            using var frame = new Frame();
            source.TryRead(frame);
            Assert.That(frame.Color.IsPresent, Is.False, "the calibration is for the size asked for");
            Assert.That(source.Problems.Single().What, Does.Contain("it gives pictures of 320×240, not 64×48"));
            Assert.That(_webcam.IsOpen, Is.False);
        }

        [Test]
        public void Source_Unplugged_ComesBack()
        {
            using LiveCameraSource source = Webcam().CreateSource(_clock.NowUs);
            using var frame = new Frame();
            int after = 0;
            for (int i = 0; i < 100; i++)
            {
                _webcam.IsConnected = i < 20 || i > 25;
                _clock.StepUs = _webcam.IsConnected && _webcam.IsOpen ? 16_667 : 700_000;
                source.TryRead(frame);
                after += i > 25 && frame.Color.IsPresent ? 1 : 0;
            }

            Assert.That(after, Is.GreaterThan(50));
            Assert.That(source.Problems.Last().What, Does.Contain("is back after"));
        }

        [TestCase(true)]
        [TestCase(false)]
        public void Source_Times_AreTheDriversOrOnesOwn(bool hasTimes)
        {
            _webcam.HasTimes = hasTimes;
            _clock.StepUs = 11_111;
            using LiveCameraSource source = Webcam().CreateSource(_clock.NowUs);
            using var frame = new Frame();
            Read(source, 10);
            source.TryRead(frame);
            long last = frame.TimeUs;
            for (int i = 0; i < 20; i++)
            {
                source.TryRead(frame);
                Assert.That(frame.TimeUs - last, hasTimes ? Is.InRange(32_900L, 33_700L) : Is.Positive);
                last = frame.TimeUs;
            }
        }

        [Test]
        public void Source_NativeLibraryMissing_IsOneClearMessage()
        {
            FakeWebcam.LibraryProblem = new TypeInitializationException("NativeMethods", new DllNotFoundException("OpenCvSharpExtern"));
            InputException? said = Assert.Throws<InputException>(() => Webcam().CreateSource(null!));
            Assert.That(said!.Message, Does.StartWith("OpenCvSharp library: its library cannot be loaded (OpenCvSharpExtern); put OpenCvSharp.dll"));
        }

        [TestCase("_width", 0)]
        [TestCase("_fourCc", "MJ")]
        public void Source_SettingsThatAreNone_AreRefused(string field, object value)
        {
            WebcamSource asset = Webcam();
            SerializedFields.Set(asset, field, value);
            Assert.That(() => asset.CreateSource(null!), Throws.TypeOf<InputException>());
        }

        [Test]
        public void Source_Disposed_LeavesNothingBehind()
        {
            int before = FakeWebcam.MatsAlive;
            for (int i = 0; i < 3; i++)
            {
                LiveCameraSource source = Webcam().CreateSource(_clock.NowUs);
                Read(source, 3);
                source.Dispose();
            }

            Assert.That(FakeWebcam.MatsAlive, Is.EqualTo(before));
            Assert.That(_webcam.IsOpen, Is.False);
        }

        [Test]
        public void Read_OfAWarmSource_AllocatesNothing()
        {
            using LiveCameraSource source = Webcam().CreateSource(_clock.NowUs);
            using var frame = new Frame();
            Assert.That(Allocation.Of(() =>
            {
                for (int i = 0; i < 50; i++)
                    source.TryRead(frame);
            }), Is.Zero);
        }

        private static void Read(IFrameSource source, int count)
        {
            using var frame = new Frame();
            for (int i = 0; i < count; i++)
                source.TryRead(frame);
        }

        private static WebcamSource Webcam()
        {
            WebcamSource asset = ScriptableObject.CreateInstance<WebcamSource>();
            SerializedFields.Set(asset, "_width", 64);
            SerializedFields.Set(asset, "_height", 48);
            SerializedFields.Set(asset, "_backend", WebcamBackend.VideoForLinux);
            return asset;
        }
    }
}
