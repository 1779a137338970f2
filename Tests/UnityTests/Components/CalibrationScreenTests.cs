using System;
using System.IO;
using System.Linq;
using System.Threading;
using LaserTracking.Geometry;
using LaserTracking.Patterns;
using NUnit.Framework;
using UnityEngine;
using UnityEngine.UIElements;
using UnityStandIn;

namespace LaserTracking.Unity
{
    /// <summary>A camera that looks at the very texture that is projected, from the side: pattern in, calibration and map out.</summary>
    public sealed class CalibrationScreenTests : StandInTests
    {
        private static readonly Vector2D SizeM = new Vector2D(3.73, 2.26);

        [Test]
        public void CalibrationScreen_Begun_ShowsThePatternsFindsTheScreenKeepsItAndShowsTheMap()
        {
            using var folder = new TemporaryFolder();
            Desk.PersistentDataPath = folder.Path;
            RangeRig rig = Rig(out ProjectedSource camera, out CalibrationScreen calibration);
            bool? told = null;
            calibration.Finished += found => told = found.IsAccepted;
            Play(rig, () => rig.Range.IsRunning);
            calibration.Begin();
            Assert.That(calibration.State, Is.EqualTo(CalibrationState.Showing));
            Play(rig, () => calibration.State >= CalibrationState.Accepted, calibration, camera);
            Assert.That(calibration.State, Is.EqualTo(CalibrationState.Accepted), calibration.Verdict);
            Assert.That(told, Is.True);
            Assert.That(calibration.Verdict, Does.StartWith("accepted: "));

            RangeCalibration stored = RangeCalibrationFile.Read(Path.Combine(folder.Path, "screen.json"));
            foreach (Vector2D place in new[] { new Vector2D(0.1, 0.1), new Vector2D(0.9, 0.15), new Vector2D(0.5, 0.5), new Vector2D(0.12, 0.88), new Vector2D(0.9, 0.9) })
            {
                Vector2D offM = stored.Screen.ToScreenM(camera.ToImagePx(place)) - new Vector2D(place.X * SizeM.X, place.Y * SizeM.Y);
                Assert.That(offM.Length, Is.LessThan(0.0015), "at " + place);
            }

            VisualElement sheet = calibration.GetComponent<UIDocument>().rootVisualElement[0];
            VisualElement[] shown = Enumerable.Range(0, sheet.childCount).Select(i => sheet[i]).ToArray();
            Assert.That(shown.Select(element => element.name), Is.SupersetOf(new[] { "top left", "middle", "bottom right", "verdict" }));
            Assert.That(shown.Count(element => element.name == "point"), Is.GreaterThan(200));
            Assert.That(((Label)shown.Single(element => element.name == "verdict")[0]).text, Is.EqualTo(calibration.Verdict));

            Play(rig, () => calibration.State == CalibrationState.Idle);
            Assert.That(calibration.GetComponent<UIDocument>().rootVisualElement.childCount, Is.Zero);
            Assert.That(rig.Range.IsRunning, Is.True, "with the new calibration");
            Assert.That(rig.Screen.ReadCalibration()!.ImageWidth, Is.EqualTo(ProjectedSource.Width));
        }

        [TestCase(true, false, 1024, 768)]
        [TestCase(true, true, 1024, 768)]
        [TestCase(false, true, 0, 0)]
        public void CalibrationScreen_ProjectorIsTheSecondDisplay_DrawsThePatternInItsSize(bool isPluggedIn, bool isEditor, int width, int height)
        {
            RangeRig rig = Rig(out ProjectedSource _, out CalibrationScreen calibration);
            Desk.IsEditor = isEditor;
            if (isPluggedIn)
                Desk.Plug(1024, 768);
            rig.Range.Viewpoint!.gameObject.AddComponent<Camera>().targetDisplay = 1;
            calibration.GetComponent<UIDocument>().panelSettings.targetDisplay = 1;
            Play(rig, () => rig.Range.IsRunning);
            calibration.Begin();
            Assert.That((calibration.Shown!.width, calibration.Shown.height), Is.EqualTo(isPluggedIn ? (width, height) : (Desk.Width, Desk.Height)), "the editor lists one display, whatever its Game view shows");
            Assert.That(Display.displays.Last().active, Is.True, "a player switches it on only when told");
            Assert.That(rig.Health.Where(health => health.Text.Contains("display")), Is.Empty);
        }

        [TestCase(1, 1, "display 2, which is not plugged in")]
        [TestCase(0, 1, "draws on display 2, the camera that draws the range's picture on 1")]
        public void CalibrationScreen_DisplayThatIsNotThePicturesOne_SaysSo(int cameras, int panels, string said)
        {
            RangeRig rig = Rig(out ProjectedSource _, out CalibrationScreen calibration);
            rig.Range.Viewpoint!.gameObject.AddComponent<Camera>().targetDisplay = cameras;
            calibration.GetComponent<UIDocument>().panelSettings.targetDisplay = panels;
            Play(rig, () => rig.Range.IsRunning);
            calibration.Begin();
            Assert.That(calibration.State, Is.EqualTo(CalibrationState.Idle));
            PlayerLoop.Step(0.02);
            Assert.That(rig.Health.Select(health => health.Text), Has.Some.Contains(said));
        }

        [Test]
        public void CalibrationScreen_CameraThatSeesNothingOfIt_IsRefusedAndTheOldOneStays()
        {
            using var folder = new TemporaryFolder();
            Desk.PersistentDataPath = folder.Path;
            RangeRig rig = Rig(out ProjectedSource camera, out CalibrationScreen calibration);
            camera.IsCovered = true;
            Play(rig, () => rig.Range.IsRunning);
            calibration.Begin();
            Play(rig, () => calibration.State >= CalibrationState.Accepted, calibration, camera);
            Assert.That(calibration.State, Is.EqualTo(CalibrationState.Refused));
            PlayerLoop.Step(0.02);
            Assert.That(rig.Health.Select(health => health.Text), Has.Some.StartsWith("calibration refused: "));
            Assert.That(Directory.GetFiles(folder.Path), Is.Empty);
        }

        [Test]
        public void CalibrationScreen_SwitchedOffHalfWay_LetsTheDetectorGoOn()
        {
            RangeRig rig = Rig(out ProjectedSource camera, out CalibrationScreen calibration);
            Play(rig, () => rig.Range.IsRunning);
            calibration.Begin();
            PlayerLoop.Step(0.1);
            calibration.enabled = false;
            Assert.That((calibration.State, calibration.Shown == null), Is.EqualTo((CalibrationState.Idle, true)));
            Assert.That(calibration.GetComponent<UIDocument>().rootVisualElement.childCount, Is.Zero);
            PlayerLoop.Step(0.1);
            Assert.That(rig.Range.IsRunning, Is.True);
        }

        [Test]
        public void CalibrationScreen_NoCameraPlaying_SaysSoOnce()
        {
            RangeRig rig = Rig(out _, out CalibrationScreen calibration);
            calibration.Begin();
            Assert.That(ConsoleLog.Entries.Single().Message, Does.EndWith("gets no pictures: the source of its LaserRange does not play; start the camera first"));
            Assert.That(rig.Range.IsRunning, Is.False);
        }

        private static RangeRig Rig(out ProjectedSource camera, out CalibrationScreen calibration)
        {
            Desk.Width = 640;
            Desk.Height = 388;
            var rig = new RangeRig(new StubSource(1, 0), withCalibration: false);
            var seen = new ProjectedSource();
            camera = seen;
            rig.SourceAsset.Live = true;
            rig.SourceAsset.Create = () => new ProjectedSource(seen);
            SerializedFields.Set(rig.Screen, "_calibrationFile", "screen.json");
            var owner = new GameObject("calibration");
            owner.SetActive(false);
            owner.AddComponent<UIDocument>().panelSettings = ScriptableObject.CreateInstance<PanelSettings>();
            calibration = owner.AddComponent<CalibrationScreen>();
            SerializedFields.Set(calibration, "_range", rig.Range);
            SerializedFields.Set(calibration, "_mapS", 0.5f);
            SerializedFields.Set(calibration, "_pictureS", 0.3f);
            owner.SetActive(true);
            rig.Range.gameObject.SetActive(true);
            return rig;
        }

        private static void Play(RangeRig rig, Func<bool> isSo, CalibrationScreen? calibration = null, ProjectedSource? camera = null)
        {
            var watch = System.Diagnostics.Stopwatch.StartNew();
            while (!isSo() && watch.Elapsed.TotalSeconds < 40)
            {
                PlayerLoop.Step(0.02);
                if (camera != null)
                    camera.Show(calibration!.Shown);
                Thread.Sleep(calibration != null && calibration.State == CalibrationState.Showing ? 15 : 2);
            }

            Assert.That(isSo(), Is.True, calibration == null ? "" : calibration.State.ToString());
        }
    }
}
