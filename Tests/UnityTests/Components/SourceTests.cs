using System;
using System.IO;
using System.Linq;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Imaging;
using LaserTracking.Session;
using NUnit.Framework;
using UnityEngine;
using UnityStandIn;

namespace LaserTracking.Unity
{
    /// <summary>The sources that need neither a native library nor a second program.</summary>
    public sealed class SourceTests : StandInTests
    {
        [Test]
        public void MouseSource_ClickOnATarget_IsAShotThatHitsWhatTheRayMeets()
        {
            RangeRig rig = MouseRig(out MouseSource _);
            LaserTarget target = RangeRig.AddPlate("Plate 1", new Vector3(1, 0.5f, 4), 0.4f);
            target.gameObject.SetActive(true);
            Camera camera = RangeRig.AddMainCamera();
            rig.Range.gameObject.SetActive(true);
            PlayUntil(() => false, 30);
            Desk.Mouse = ToWindow(camera, target.transform.position);
            Desk.IsPressed = true;
            PlayerLoop.Step(1 / 60.0);
            Desk.IsPressed = false;
            PlayUntil(() => rig.Shots.Count > 0, 1200);
            ShotEvent shot = rig.Shots.Single();
            Assert.That((shot.HasHit, shot.Hit.Target), Is.EqualTo((true, "Plate 1")));
            Assert.That(shot.Hit.LocalPointM.X, Is.EqualTo(0).Within(0.005));
            Assert.That(shot.Hit.LocalPointM.Y, Is.EqualTo(0).Within(0.005));
            Assert.That(rig.Health.Where(health => health.Kind != HealthKind.Advice && health.Kind != HealthKind.FrameGap), Is.Empty);
        }

        [Test]
        public void MouseSource_ScreenWithACalibrationOfItsOwn_LandsAtTheSamePlace()
        {
            RangeRig rig = MouseRig(out MouseSource mouse, withCalibration: true);
            Camera camera = RangeRig.AddMainCamera();
            rig.Range.gameObject.SetActive(true);
            PlayUntil(() => false, 30);
            Vector3 window = ToWindow(camera, new Vector3(-0.6f, 0.4f, 0));
            mouse.Fire(new Vector2(window.x, window.y));
            PlayUntil(() => rig.Shots.Count > 0, 1200);
            Assert.That(rig.Shots.Single().ScreenM.X, Is.EqualTo(3.73 / 2 - 0.6).Within(0.003));
            Assert.That(rig.Shots[0].ScreenM.Y, Is.EqualTo(2.26 / 2 - 0.4).Within(0.003));
        }

        [Test]
        public void MouseSource_ClicksFasterThanFlashes_AreAllShots()
        {
            RangeRig rig = MouseRig(out MouseSource mouse);
            Camera camera = RangeRig.AddMainCamera();
            rig.Range.gameObject.SetActive(true);
            PlayUntil(() => false, 30);
            for (int i = 0; i < 6; i++)
            {
                Vector3 window = ToWindow(camera, new Vector3(-1 + 0.4f * i, 0, 0));
                mouse.Fire(new Vector2(window.x, window.y));
            }

            PlayUntil(() => rig.Shots.Count == 6, 1200);
            Assert.That(rig.Shots.Select(shot => Math.Round((shot.ScreenM.X - 3.73 / 2 + 1) / 0.4)), Is.EqualTo(new[] { 0, 1, 2, 3, 4, 5 }));
        }

        [TestCase(0, 0)]
        [TestCase(1920, 1)]
        public void MouseSource_ClickOnTheTrainersDisplay_IsNoShot(int clickAtPx, int shots)
        {
            RangeRig rig = MouseRig(out MouseSource _);
            RangeRig.AddMainCamera().targetDisplay = 1;
            Desk.Plug(1920, 1080);
            rig.Range.gameObject.SetActive(true);
            PlayUntil(() => false, 30);
            Desk.Mouse = new Vector3(clickAtPx + 960, 540, 0);
            Desk.IsPressed = true;
            PlayerLoop.Step(1 / 60.0);
            Desk.IsPressed = false;
            PlayUntil(() => rig.Shots.Count > 0, shots > 0 ? 1200 : 30);
            Assert.That(rig.Shots, Has.Count.EqualTo(shots));
        }

        [Test]
        public void MouseSource_ClickBesideTheScreen_IsNoShot()
        {
            RangeRig rig = MouseRig(out MouseSource mouse);
            Camera camera = RangeRig.AddMainCamera();
            rig.Range.gameObject.SetActive(true);
            PlayUntil(() => false, 20);
            mouse.Fire(new Vector2(ToWindow(camera, new Vector3(0, 1.4f, 0)).x, 1079));
            camera.transform.rotation = Quaternion.Euler(0, 180, 0);
            mouse.Fire(new Vector2(960, 540));
            PlayUntil(() => false, 20);
            Assert.That(rig.Shots, Is.Empty);
        }

        [Test]
        public void MouseSource_OnceWarm_AllocatesNothingInUpdate()
        {
            RangeRig rig = MouseRig(out MouseSource mouse);
            RangeRig.AddMainCamera();
            rig.Range.gameObject.SetActive(true);
            PlayUntil(() => false, 30);
            var update = (Action)Delegate.CreateDelegate(typeof(Action), rig.Range, "Update");
            Assert.That(Allocation.Of(() =>
            {
                for (int i = 0; i < 10; i++)
                {
                    PlayerLoop.AdvanceTime(1 / 60.0);
                    update();
                }
            }), Is.Zero);
        }

        [Test]
        public void WebCamTextureSource_Picture_ArrivesUprightAndBlueFirst()
        {
            WebCams.PlugIn("cam");
            WebCamTextureSource asset = ScriptableObject.CreateInstance<WebCamTextureSource>();
            var rig = new RangeRig(new StubSource(1, 0));
            using IFrameSource source = asset.CreateSource(rig.Range);
            var pixels = new Color32[64 * 48];
            // A red pixel in the picture's top row, third from the left.
            pixels[47 * 64 + 2] = new Color32(250, 20, 10, 255);
            WebCams.Show(64, 48, pixels);
            PlayerLoop.Step(0.1);
            asset.UpdateSource();
            using var frame = new Frame();
            Assert.That(source.TryRead(frame), Is.True);
            Assert.That((frame.Color.Format, frame.Color.Width, frame.Color.Height, frame.TimeUs), Is.EqualTo((PixelFormat.Bgra32, 64, 48, 100_000L)));
            Assert.That(frame.Color.Bytes.Slice(8, 4).ToArray(), Is.EqualTo(new byte[] { 10, 20, 250, 255 }));
            Assert.That(frame.Color.Bytes.ToArray().Count(value => value == 250), Is.EqualTo(1));
            Assert.That(ConsoleLog.Entries.Single().Message, Does.StartWith("webcam cam: Unity cannot lock its exposure"));
            asset.ReleaseSource();
            Assert.That(WebCams.Playing, Is.Zero);
            Assert.That(source.TryRead(frame), Is.False);
        }

        [Test]
        public void WebCamTextureSource_UnpluggedAndBack_PlaysAgainAndSaysSo()
        {
            WebCams.PlugIn("cam");
            var rig = new RangeRig(new StubSource(1, 0));
            rig.Range.Source = ScriptableObject.CreateInstance<WebCamTextureSource>();
            rig.Range.gameObject.SetActive(true);
            var pixels = new Color32[64 * 64];
            PlayUntil(() => false, 10, () => WebCams.Show(64, 64, pixels));
            WebCams.Unplug();
            PlayUntil(() => rig.Health.Any(health => health.Text.Contains("gives no more pictures")), 1200);
            Assert.That(WebCams.Playing, Is.Zero);
            WebCams.PlugIn("cam");
            PlayUntil(() => rig.Health.Any(health => health.Text.Contains("is there again")), 1200);
            Assert.That((WebCams.Playing, rig.Range.IsRunning), Is.EqualTo((1, true)));
            Assert.That(rig.Health.Count(health => health.Text.Contains("exposure")), Is.EqualTo(1), "said once");
        }

        [Test]
        public void WebCamTextureSource_NoneThereOrAnotherOne_SaysWhatThereIs()
        {
            var rig = new RangeRig(new StubSource(1, 0));
            WebCamTextureSource asset = ScriptableObject.CreateInstance<WebCamTextureSource>();
            Assert.That(() => asset.CreateSource(rig.Range), Throws.TypeOf<InputException>().With.Message.Contains("no camera is there"));
            WebCams.PlugIn("Built-in");
            SerializedFields.Set(asset, "_device", "Logi");
            Assert.That(() => asset.CreateSource(rig.Range), Throws.TypeOf<InputException>().With.Message.Contains("name one of these: Built-in"));
        }

        [Test]
        [Category("Reference")]
        public void RecordingSource_ReferenceRecording_GivesTheShotsOfTheHeadlessReplay()
        {
            string file = TestFiles.Reference("k4a", "rec_laser_720p_mjpg.mkv");
            var rig = new RangeRig(new StubSource(1, 0), withCalibration: false);
            RecordingSource recording = ScriptableObject.CreateInstance<RecordingSource>();
            SerializedFields.Set(recording, "_file", Path.GetFileName(file));
            Desk.StreamingAssetsPath = Path.GetDirectoryName(file)!;
            rig.Range.Source = recording;
            rig.Range.gameObject.SetActive(true);
            for (int i = 0; i < 600 && (i < 5 || rig.Range.IsRunning); i++)
                rig.Step(0.05);
            PlayerLoop.Step(0.05);
            Assert.That(rig.Range.IsRunning, Is.False);
            Assert.That(rig.Shots, Is.Not.Empty);
            Assert.That(rig.Shots.Select(shot => shot.Shot.TimeUs), Is.Ordered);
        }

        private static RangeRig MouseRig(out MouseSource mouse, bool withCalibration = false)
        {
            var rig = new RangeRig(new StubSource(1, 0), withCalibration);
            mouse = ScriptableObject.CreateInstance<MouseSource>();
            rig.Range.Source = mouse;
            return rig;
        }

        /// <summary>Where a camera at the eye shows a point of the world, pixels from the lower left corner.</summary>
        private static Vector3 ToWindow(Camera camera, Vector3 world)
        {
            Vector3 seen = camera.transform.InverseTransformPoint(world);
            double up = Math.Tan(camera.fieldOfView * Math.PI / 360);
            return new Vector3((float)((seen.x / seen.z / up * Desk.Height / Desk.Width + 1) / 2 * Desk.Width), (float)((seen.y / seen.z / up + 1) / 2 * Desk.Height), 0);
        }

        private static void PlayUntil(Func<bool> isSo, int frames, Action? before = null)
        {
            for (int i = 0; i < frames && !isSo(); i++)
            {
                before?.Invoke();
                PlayerLoop.Step(1 / 60.0);
                // Real time for the detector's thread, which nobody waits for here.
                Thread.Sleep(5);
            }
        }
    }
}
