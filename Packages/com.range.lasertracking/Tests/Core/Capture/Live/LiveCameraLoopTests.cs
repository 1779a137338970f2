using System;
using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;

namespace LaserTracking.Capture.Live
{
    public sealed class LiveCameraLoopTests
    {
        private readonly List<string> _reports = new List<string>();
        private ScriptedCamera _camera = new ScriptedCamera();
        private LiveCameraLoop _loop = null!;

        [SetUp]
        public void Prepare()
        {
            _reports.Clear();
            _camera = new ScriptedCamera();
            _loop = new LiveCameraLoop(_camera, new LiveCameraSettings(), () => _camera.NowUs, _reports.Add);
        }

        [Test]
        public void Loop_CameraThatIsWell_GivesPicturesAndSaysNothing()
        {
            Assert.That(Run(100), Is.EqualTo(100));
            Assert.That(_camera.Opens, Is.EqualTo(1));
            Assert.That(_reports, Is.Empty);
        }

        [Test]
        public void Loop_Unplugged_IsSaidOnceLookedForEverMoreSeldomAndComesBack()
        {
            Run(30);
            _camera.IsConnected = false;
            long lostUs = _camera.NowUs;
            var looks = new List<double>();
            while (_camera.NowUs - lostUs < 60_000_000)
            {
                int before = _camera.Opens;
                Step();
                if (_camera.Opens > before)
                    looks.Add((_camera.NowUs - lostUs) * 1e-6);
            }

            Assert.That(_reports, Is.EqualTo(new[] { "camera A: lost; check its cable; it is looked for until it is there", "camera A: not there; plug it in; it is looked for until it is there" }));
            // 0.5, 1, 2, 4, 8, 8 … s apart, to a step.
            Assert.That(looks.Take(5), Is.EqualTo(new[] { 0.53, 1.54, 3.55, 7.56, 15.57 }).Within(0.25));
            Assert.That(looks.Count, Is.InRange(9, 11));
            _camera.IsConnected = true;
            Assert.That(RunFor(9), Is.GreaterThan(5));
            Assert.That(_reports.Last(), Does.StartWith("camera A: is back after 6"));
            Assert.That(_reports, Has.Count.EqualTo(3));
        }

        [Test]
        public void Loop_MissingAtTheStart_IsSaidAndOpenedLater()
        {
            _camera.IsConnected = false;
            RunFor(3);
            Assert.That(_reports, Is.EqualTo(new[] { "camera A: not there; plug it in; it is looked for until it is there" }));
            _camera.IsConnected = true;
            Assert.That(RunFor(5), Is.GreaterThan(5));
        }

        [Test]
        public void Loop_SilentCamera_IsReopened()
        {
            Run(10);
            _camera.IsSilent = true;
            RunFor(1.3);
            Assert.That(_reports.Single(), Does.StartWith("camera A: no picture for 1.1 s"));
            Assert.That(_loop.IsOpen, Is.False);
            RunFor(1);
            Assert.That(_camera.Opens, Is.EqualTo(2), "looked for again");
            _camera.IsSilent = false;
            Assert.That(RunFor(3), Is.GreaterThan(5));
        }

        [Test]
        public void Loop_FirstPicture_MayTakeFourSeconds()
        {
            _camera.IsSilent = true;
            RunFor(3.9);
            Assert.That(_reports, Is.Empty);
            RunFor(0.4);
            Assert.That(_reports.Single(), Does.Contain("no picture for 4.1 s"));
        }

        [Test]
        public void Loop_LibraryThatThrows_CountsAsLost()
        {
            Run(5);
            _camera.Failure = new InvalidOperationException("bad luck.\r\nworse luck");
            Run(1);
            Assert.That(_reports.Single(), Is.EqualTo("camera A: bad luck. worse luck; it is looked for until it is there"));
            Assert.That(_camera.IsOpen, Is.False);
        }

        [Test]
        public void Loop_ClockOfTheDeviceThatStartsAnew_GoesOnWhereItWas()
        {
            var frame = new Frame();
            var times = new List<long>();
            for (int i = 0; i < 400; i++)
            {
                if (i == 100)
                    _camera.IsConnected = false;
                if (i == 110)
                {
                    _camera.IsConnected = true;
                    _camera.DeviceOffsetUs = -_camera.NowUs;
                }

                if (_loop.TryStep(frame, out int waitMs))
                {
                    times.Add(frame.TimeUs);
                    Assert.That(frame.Color.TimeUs, Is.EqualTo(frame.TimeUs));
                    Assert.That(frame.TimeUs, Is.EqualTo(_camera.NowUs).Within(1), "the host's clock");
                }

                _camera.NowUs += waitMs * 1000;
            }

            Assert.That(times, Is.Ordered.Ascending);
            Assert.That(times, Has.Count.GreaterThan(300));
        }

        [Test]
        public void Loop_ThatRuns_AllocatesNothing()
        {
            _camera.SettingList.Add(new CameraSetting(1, "exposure", "µs", 2500, 100, null, "x"));
            _camera.Used[1] = 2500;
            var frame = new Frame();
            Assert.That(Allocation.Of(() =>
            {
                for (int i = 0; i < 200; i++)
                    _loop.TryStep(frame, out _);
            }), Is.Zero);
        }

        [Test]
        public void Settings_ThatContradictEachOther_AreRefused()
        {
            Assert.That(() => new LiveCameraLoop(_camera, new LiveCameraSettings { LongestRetryMs = 1 }, () => 0, _reports.Add), Throws.ArgumentException);
            Assert.That(() => new LiveCameraLoop(_camera, new LiveCameraSettings { LatencyMs = double.NaN }, () => 0, _reports.Add), Throws.ArgumentException);
        }

        private bool Step()
        {
            bool isPicture = _loop.TryStep(_frame, out int waitMs);
            _camera.NowUs += waitMs * 1000;
            return isPicture;
        }

        private readonly Frame _frame = new Frame();

        /// <summary>Pictures until so many steps with the camera open.</summary>
        private int Run(int steps)
        {
            Step();
            return Enumerable.Range(0, steps).Count(_ => Step());
        }

        private int RunFor(double seconds)
        {
            long endUs = _camera.NowUs + (long)(seconds * 1e6);
            int pictures = 0;
            while (_camera.NowUs < endUs)
                pictures += Step() ? 1 : 0;
            return pictures;
        }
    }
}
