using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.IO;
using System.Linq;
using System.Threading;
using KinectStandIn;
using LaserTracking.Capture;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Capture.Live;
using LaserTracking.Imaging;
using LaserTracking.Kinect;
using Microsoft.Azure.Kinect.Sensor;
using NUnit.Framework;
using UnityEngine;
using UnityStandIn;

namespace LaserTracking.Unity
{
    /// <summary>The Kinect sources over the wrapper's stand-in, with cameras that are pulled out, fall silent, refuse and hang.</summary>
    public sealed class KinectSourceTests : StandInTests
    {
        private readonly VirtualClock _clock = new VirtualClock();
        private FakeKinect _kinect = null!;

        [SetUp]
        public void Connect()
        {
            FakeKinect.Reset();
            _kinect = new FakeKinect("000A") { IntervalMs = 0 };
        }

        [Test]
        public void ColorSource_GivesNv12OfCameraZero_WithDepthOff()
        {
            using LiveCameraSource source = Color().CreateSource(_clock.NowUs);
            using var frame = new Frame();
            for (int i = 1; i <= 20; i++)
            {
                Assert.That(source.TryRead(frame), Is.True);
                Assert.That((frame.Color.Format, frame.Color.Width, frame.Color.Height), Is.EqualTo((PixelFormat.Nv12, 1280, 720)));
                Assert.That(frame.Color.Bytes.IndexOfAnyExcept((byte)i), Is.EqualTo(-1), "every byte");
                Assert.That(frame.Depth.IsPresent || frame.Infrared.IsPresent, Is.False);
                Assert.That(_kinect.CapturesOut, Is.Zero, "captures are disposed at once");
            }

            DeviceConfiguration used = _kinect.Configuration;
            Assert.That((used.ColorFormat, used.ColorResolution, used.DepthMode, used.CameraFPS), Is.EqualTo((ImageFormat.ColorNV12, ColorResolution.R720p, DepthMode.Off, FPS.FPS30)));
            Assert.That((source.Info.Name, source.Info.Width, source.Info.Height), Is.EqualTo(("Kinect 000A, colour", 1280, 720)));
            Assert.That(source.Problems, Is.Empty);
        }

        [Test]
        public void DepthSource_GivesDepthAndInfraredOfCameraOne_WithColorOff()
        {
            KinectDepthSource asset = Depth("000A");
            using LiveCameraSource source = asset.CreateSource(_clock.NowUs);
            using var frame = new Frame();
            source.TryRead(frame);
            Assert.That((frame.Depth.Format, frame.Depth.Width, frame.Depth.Height), Is.EqualTo((PixelFormat.Depth16, 640, 576)));
            Assert.That(frame.Infrared.Format, Is.EqualTo(PixelFormat.Infrared16));
            Assert.That(frame.Depth.Bytes[0], Is.EqualTo(1));
            Assert.That(frame.Color.IsPresent, Is.False);
            Assert.That((_kinect.Configuration.ColorResolution, _kinect.Configuration.DepthMode), Is.EqualTo((ColorResolution.Off, DepthMode.NFOV_Unbinned)));
        }

        [Test]
        public void DepthSource_ModeWithoutDepthAtThirtyFrames_IsRefused()
        {
            KinectDepthSource asset = Depth("000A");
            SerializedFields.Set(asset, "_mode", KinectDepthMode.WfovUnbinned);
            Assert.That(() => asset.CreateSource(null!), Throws.TypeOf<InputException>().With.Message.Contains("choose a narrow one"));
        }

        [Test]
        public void Sources_TwoCameras_AreToldApartByTheirSerialNumbers()
        {
            var second = new FakeKinect("000B") { IntervalMs = 0 };
            using LiveCameraSource color = Color("000B").CreateSource(_clock.NowUs), depth = Depth("000A").CreateSource(_clock.NowUs);
            using var frame = new Frame();
            color.TryRead(frame);
            depth.TryRead(frame);
            Assert.That(second.Configuration.DepthMode, Is.EqualTo(DepthMode.Off));
            Assert.That(_kinect.Configuration.DepthMode, Is.EqualTo(DepthMode.NFOV_Unbinned));
            Assert.That(color.Problems.Concat(depth.Problems), Is.Empty);
        }

        [Test]
        public void Source_OtherSerialNumber_SaysWhatIsConnectedAndHoldsNothingOpen()
        {
            using LiveCameraSource source = Color("000X").CreateSource(_clock.NowUs);
            using var frame = new Frame();
            Assert.That(source.TryRead(frame), Is.True);
            Assert.That(frame.Color.IsPresent, Is.False);
            Assert.That(source.Problems.Single().What, Is.EqualTo("Kinect 000X, colour: there is no Kinect with this serial number (connected: 000A); plug it in, or correct the serial number in its asset; it is looked for until it is there"));
            Assert.That(_kinect.IsOpen, Is.False);
        }

        [Test]
        public void Source_Unplugged_SaysSoAndGoesOnWhenItIsBack()
        {
            using LiveCameraSource source = Color().CreateSource(_clock.NowUs);
            using var frame = new Frame();
            long last = long.MinValue;
            int before = 0, after = 0;
            for (int i = 0; i < 200; i++)
            {
                // The virtual clock runs ahead of the real wait between two looks.
                _kinect.IsConnected = i < 50 || i > 55;
                _clock.StepUs = _kinect.IsConnected && _kinect.IsStarted ? 16_667 : 700_000;
                Assert.That(source.TryRead(frame), Is.True);
                Assert.That(frame.TimeUs, Is.GreaterThan(last));
                last = frame.TimeUs;
                before += i < 50 && frame.Color.IsPresent ? 1 : 0;
                after += i > 55 && frame.Color.IsPresent ? 1 : 0;
            }

            Assert.That((before, _kinect.Starts), Is.EqualTo((50, 2)));
            Assert.That(after, Is.GreaterThan(120));
            string[] said = source.Problems.Select(problem => problem.What).ToArray();
            Assert.That(said[0], Does.Contain("lost (k4a_device_get_capture() failed)"));
            Assert.That(said.Last(), Does.Contain("is back after"));
            Assert.That(said, Has.Length.EqualTo(3), "once each: lost, nowhere, back");
        }

        [Test]
        public void ColorSource_LocksExposureAndWhiteBalanceAfterTheStart()
        {
            KinectColorSource asset = Color();
            SerializedFields.Set(asset, "_gain", 12);
            using LiveCameraSource source = asset.CreateSource(_clock.NowUs);
            Read(source, 20);
            Assert.That(_kinect.Values, Is.Empty, "not before the camera runs in its automatic modes");
            Read(source, 200);
            Assert.That(_kinect.Values[ColorControlCommand.PowerlineFrequency], Is.EqualTo(2));
            Assert.That(_kinect.Values[ColorControlCommand.ExposureTimeAbsolute], Is.EqualTo(8330));
            Assert.That(_kinect.Values[ColorControlCommand.Whitebalance], Is.EqualTo(4500));
            Assert.That(_kinect.Values[ColorControlCommand.Gain], Is.EqualTo(12));
            Assert.That(source.Problems, Is.Empty);
        }

        [Test]
        public void ColorSource_ExposureRefused_IsSaid()
        {
            _kinect.StubbornExposureUs = 16670;
            using LiveCameraSource source = Color().CreateSource(_clock.NowUs);
            Read(source, 600);
            Assert.That(source.Problems.Single().What, Is.EqualTo("Kinect 000A, colour: exposure: asked for 8330 µs, the camera has 16670 µs; choose an exposure that the camera has, and check with range advise what it can see"));
        }

        [Test]
        public void Source_CalibrationOfTheDevice_IsReadByCore()
        {
            KinectColorSource asset = Color();
            Assert.That(asset.TryReadCalibration(KinectDepthMode.NfovUnbinned, out _, out string reason), Is.False);
            Assert.That(reason, Does.Contain("has not run yet"));
            string path = Path.Combine(TestFiles.Data, "k4a", "calibration_retail_like_4x3_brown_conrady.json");
            if (!File.Exists(path))
                Assert.Ignore("no calibration of a device here: " + path);
            _kinect.RawCalibration = File.ReadAllBytes(path);
            using LiveCameraSource source = asset.CreateSource(_clock.NowUs);
            Read(source, 1);
            Assert.That(asset.TryReadCalibration(KinectDepthMode.NfovUnbinned, out KinectCalibration? calibration, out reason), Is.True, reason);
            Assert.That(calibration!.Color.Pinhole.Width, Is.EqualTo(1280));
        }

        [Test]
        public void Source_NativeLibraryMissing_IsOneClearMessage()
        {
            foreach (Exception problem in new Exception[] { new DllNotFoundException("k4a"), new TypeInitializationException("NativeMethods", new DllNotFoundException("k4a")) })
            {
                FakeKinect.LibraryProblem = problem;
                InputException? said = Assert.Throws<InputException>(() => Color().CreateSource(null!));
                Assert.That(said!.Message, Does.StartWith("Azure Kinect library: its library cannot be loaded (k4a); put the Azure Kinect Sensor SDK's native libraries"));
            }
        }

        [Test]
        public void LaserRange_NativeLibraryMissing_SaysSoAndNothingIsDead()
        {
            FakeKinect.LibraryProblem = new DllNotFoundException("k4a");
            var rig = new RangeRig(new StubSource(45, 0));
            SerializedFields.Set(rig.Range, "_source", Color());
            rig.Play(0.5);
            Assert.That(ConsoleLog.Entries.Count(entry => entry.Message.Contains("its library cannot be loaded (k4a)")), Is.EqualTo(1));
            Assert.That(ConsoleLog.Entries.Select(entry => entry.Type), Has.None.EqualTo(LogType.Exception));
        }

        [Test]
        public void Dispose_WhileTheCameraIsSilent_ReturnsSoon()
        {
            _kinect.IsSilent = true;
            var source = new PrefetchingFrameSource(Color().CreateSource(HostClock.NowUs));
            Thread.Sleep(150);
            var watch = Stopwatch.StartNew();
            source.Dispose();
            Assert.That(watch.ElapsedMilliseconds, Is.LessThan(2000), "a wait for a picture is short");
            Assert.That(_kinect.IsOpen || _kinect.IsStarted, Is.False);
        }

        [Test]
        public void LaserRange_CameraPulledOutAndPutBack_TellsItsListenersAndGoesOn()
        {
            _kinect.IntervalMs = 15;
            RangeRig rig = Play(out List<string> health);
            Until(rig, () => _kinect.IsStarted && rig.Range.IsRunning);
            _kinect.IsConnected = false;
            Until(rig, () => health.Exists(text => text.Contains("lost (k4a_device_get_capture() failed)")));
            _kinect.IsConnected = true;
            Until(rig, () => health.Exists(text => text.Contains("is back after")));
            Assert.That(rig.Range.IsRunning, Is.True);
            rig.Range.enabled = false;
            Assert.That(_kinect.IsOpen, Is.False);
            Assert.That(ConsoleLog.Entries.Select(entry => entry.Type), Has.None.EqualTo(LogType.Exception));
        }

        [Test]
        public void LaserRange_SwitchedOffWhileTheLibraryHangs_ReturnsAndTheCameraIsGivenBackLater()
        {
            RangeRig rig = Play(out _);
            Until(rig, () => _kinect.IsStarted);
            using var hang = new ManualResetEventSlim();
            _kinect.Hang = hang;
            Thread.Sleep(30);
            var watch = Stopwatch.StartNew();
            rig.Range.enabled = false;
            Assert.That(watch.ElapsedMilliseconds, Is.LessThan(5000));
            Assert.That(_kinect.IsOpen, Is.True, "its thread still waits in the library");
            hang.Set();
            _kinect.Hang = null!;
            Until(rig, () => !_kinect.IsOpen);
        }

        [Test]
        public void Read_OfAWarmSource_AllocatesNothingOfItsOwn()
        {
            using LiveCameraSource source = Color().CreateSource(_clock.NowUs);
            using var frame = new Frame();
            // The stand-in hands out one capture again and again; the real wrapper makes a new one, and its images, for every frame.
            Assert.That(Allocation.Of(() =>
            {
                for (int i = 0; i < 50; i++)
                    source.TryRead(frame);
            }), Is.Zero);
        }

        private static RangeRig Play(out List<string> health)
        {
            var rig = new RangeRig(new StubSource(1, 0));
            SerializedFields.Set(rig.Range, "_source", Color());
            var said = new List<string>();
            rig.Range.HealthChanged += heard => said.Add(heard.Text);
            rig.Range.gameObject.SetActive(true);
            health = said;
            return rig;
        }

        private static void Until(RangeRig rig, Func<bool> isSo)
        {
            var watch = Stopwatch.StartNew();
            while (!isSo() && watch.ElapsedMilliseconds < 30_000)
            {
                PlayerLoop.Step(1 / 60.0);
                Thread.Sleep(2);
            }

            Assert.That(isSo(), Is.True, "within half a minute of " + rig.Range.name);
        }

        private static void Read(IFrameSource source, int count)
        {
            using var frame = new Frame();
            for (int i = 0; i < count; i++)
                source.TryRead(frame);
        }

        private static KinectColorSource Color(string serialNumber = "000A") => Create<KinectColorSource>(serialNumber);

        private static KinectDepthSource Depth(string serialNumber) => Create<KinectDepthSource>(serialNumber);

        private static T Create<T>(string serialNumber)
            where T : KinectSourceAsset
        {
            T asset = ScriptableObject.CreateInstance<T>();
            SerializedFields.Set(asset, "_serialNumber", serialNumber);
            return asset;
        }
    }
}
