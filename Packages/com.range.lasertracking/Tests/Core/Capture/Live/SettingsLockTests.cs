using System.Collections.Generic;
using System.Linq;
using NUnit.Framework;

namespace LaserTracking.Capture.Live
{
    public sealed class SettingsLockTests
    {
        private const int Exposure = 1;
        private const int Gain = 2;

        private readonly List<string> _reports = new List<string>();
        private ScriptedCamera _camera = new ScriptedCamera();
        private SettingsLock _lock = null!;
        private long _nowUs;

        [SetUp]
        public void Prepare()
        {
            _reports.Clear();
            _nowUs = 0;
            _camera = new ScriptedCamera();
            _camera.SettingList.Add(new CameraSetting(Exposure, "exposure", "µs", 2000, 100, 2500, "choose another"));
            _camera.SettingList.Add(new CameraSetting(Gain, "gain", "", 10, 1, null, "choose another"));
            _lock = new SettingsLock(_camera, new LiveCameraSettings(), _reports.Add);
        }

        [Test]
        public void Lock_WaitsUntilTheCameraHasSettled()
        {
            Pictures(1.9);
            Assert.That(_camera.Sets, Is.Zero);
            Pictures(0.2);
            Assert.That(_camera.Values[Exposure], Is.EqualTo(2000));
            Assert.That(_camera.Sets, Is.EqualTo(2));
            Pictures(60);
            Assert.That(_camera.Sets, Is.EqualTo(2), "what holds is not set again");
            Assert.That(_reports, Is.Empty);
        }

        [Test]
        public void Lock_NextStepThatTheCameraHas_IsAsGoodAsAsked()
        {
            _camera.Stubborn[Exposure] = 2500;
            Pictures(20);
            Assert.That(_reports, Is.Empty);
        }

        [Test]
        public void Lock_Refused_IsSaidOnceAndTriedOn()
        {
            _camera.Stubborn[Exposure] = 8330;
            Pictures(60);
            Assert.That(_reports.Single(), Is.EqualTo("exposure: asked for 2000 µs, the camera has 8330 µs; choose another"));
            _camera.Stubborn.Clear();
            Pictures(20);
            Assert.That(_reports, Has.Count.EqualTo(2));
            Assert.That(_reports[1], Is.EqualTo("exposure is now 2000 µs, as asked"));
        }

        [Test]
        public void Lock_PicturesThatSayOtherwise_AreBelievedAndNotTheCamera()
        {
            Pictures(5);
            _camera.Used[Exposure] = 16670;
            Pictures(30);
            Assert.That(_reports.Single(), Does.Contain("asked for 2000 µs, the camera has 16670 µs"));
            Assert.That(_camera.Values[Exposure], Is.EqualTo(2000), "what it says when asked");
        }

        [Test]
        public void Lock_FewPicturesOfTheOldExposure_AreNoProof()
        {
            Pictures(5);
            _camera.Used[Exposure] = 16670;
            Pictures(0.2);
            _camera.Used[Exposure] = 2000;
            Pictures(30);
            Assert.That(_reports, Is.Empty);
        }

        [Test]
        public void Lock_SettingThatIsLostLater_IsSetAgain()
        {
            Pictures(10);
            _camera.Values[Gain] = 99;
            Pictures(10);
            Assert.That(_camera.Values[Gain], Is.EqualTo(10));
            Assert.That(_reports, Is.Empty, "set again before it was worth a word");
        }

        [Test]
        public void Lock_CameraThatTellsNothing_IsSaid()
        {
            _camera.SettingList.RemoveAt(1);
            var mute = new MuteCamera(_camera);
            _lock = new SettingsLock(mute, new LiveCameraSettings(), _reports.Add);
            Pictures(20);
            Assert.That(_reports.Single(), Is.EqualTo("exposure: asked for 2000 µs, the camera does not tell what it has; choose another"));
        }

        [Test]
        public void Lock_AfterRestart_SetsAnew()
        {
            Pictures(10);
            _lock.Restart();
            _camera.Values.Clear();
            Pictures(1.9);
            Assert.That(_camera.Values, Is.Empty);
            Pictures(0.2);
            Assert.That(_camera.Values[Exposure], Is.EqualTo(2000));
        }

        private void Pictures(double seconds)
        {
            for (int i = 0; i < seconds * 30; i++)
            {
                _nowUs += ScriptedCamera.IntervalUs;
                _lock.Update(_nowUs);
            }
        }

        private sealed class MuteCamera : ILiveCamera
        {
            private readonly ScriptedCamera _camera;

            public MuteCamera(ScriptedCamera camera)
            {
                _camera = camera;
            }

            public FrameSourceInfo Info => _camera.Info;

            public IReadOnlyList<CameraSetting> Settings => _camera.Settings;

            public bool TryOpen(out string problem) => _camera.TryOpen(out problem);

            public LiveReading Read(Frame frame, int timeoutMs, out string problem) => _camera.Read(frame, timeoutMs, out problem);

            public bool TrySet(CameraSetting setting) => false;

            public bool TryGet(CameraSetting setting, out double value)
            {
                value = 0;
                return false;
            }

            public bool TryGetUsed(CameraSetting setting, out double value)
            {
                value = 0;
                return false;
            }

            public void Close() => _camera.Close();
        }
    }
}
