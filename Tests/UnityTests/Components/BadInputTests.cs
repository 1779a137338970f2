using System;
using System.Linq;
using NUnit.Framework;
using UnityEngine;
using UnityStandIn;

namespace LaserTracking.Unity
{
    /// <summary>Each mistake is one clear line, in the Console and as HealthChanged, and nothing is dead.</summary>
    public sealed class BadInputTests : StandInTests
    {
        [Test]
        public void ScreenWithoutCalibration_IsOneMessage()
        {
            var rig = new RangeRig(new StubSource(45, 0, (30, 320, 240)), withCalibration: false);
            rig.Play(2);
            ExpectOne(rig, "LaserRange range: the screen has no calibration, so shots have no place on it and cannot hit anything; calibrate it, or drag the calibration of camera 0 into the ScreenSurface");
            Assert.That(rig.Shots, Has.Count.EqualTo(1), "shots are still found");
        }

        [Test]
        public void TargetWithoutCollider_IsOneMessageAndTheOthersAreHit()
        {
            var rig = new RangeRig(new StubSource(45, 0, (30, 320, 240)));
            RangeRig.AddPlate("Plate 1", new Vector3(0, 0, 4), 0.5f).gameObject.SetActive(true);
            var hollow = new GameObject("Hollow");
            hollow.SetActive(false);
            SerializedFields.Set(hollow.AddComponent<LaserTarget>(), "_definition", RangeRig.Definition("hollow", 1));
            rig.Range.gameObject.SetActive(true);
            hollow.SetActive(true);
            rig.Play(2);
            ExpectOne(rig, "LaserTarget Hollow has no collider on its object or below, so nothing can hit it; add one");
            Assert.That(rig.Shots.Single().HasHit, Is.True);
        }

        [Test]
        public void TwoRangesOnOneCamera_TheSecondSaysSoAndTheFirstPlays()
        {
            var rig = new RangeRig(new StubSource(45, 0, (30, 320, 240)));
            var second = new GameObject("second");
            second.SetActive(false);
            LaserRange other = second.AddComponent<LaserRange>();
            SerializedFields.Set(other, "_source", rig.SourceAsset);
            string told = "";
            other.HealthChanged += health => told += health.Text;
            rig.Range.gameObject.SetActive(true);
            second.SetActive(true);
            rig.Play(2);
            const string Text = "LaserRange second: its source  already serves LaserRange range, and one camera can serve only one; give this one another source or disable it";
            Assert.That(ConsoleLog.Entries.Single().Message, Is.EqualTo(Text));
            Assert.That(told, Is.EqualTo(Text));
            Assert.That(rig.Shots, Has.Count.EqualTo(1));
            Assert.That(other.IsRunning, Is.False);
        }

        [Test]
        public void PathsWithCharactersThatNoPathHas_AreOneMessageEach()
        {
            var rig = new RangeRig(new StubSource(45, 0, (30, 320, 240)));
            SerializedFields.Set(rig.Screen, "_calibrationFile", "screen\0.json");
            rig.Play(1);
            ExpectOne(rig, "\"screen\\0.json\": this is no path; enter it without characters such as < > | * ?");
            SerializedFields.Set(rig.Screen, "_calibrationFile", "");
            RecordingSource recording = ScriptableObject.CreateInstance<RecordingSource>();
            SerializedFields.Set(recording, "_file", "\"a\0.mkv\"");
            ConsoleLog.Clear();
            rig.Health.Clear();
            rig.Range.Source = recording;
            rig.Play(1);
            ExpectOne(rig, "\"a\\0.mkv\": this is no path; enter it without characters such as < > | * ?");
        }

        [Test]
        public void PathInQuotationMarks_AsWindowsCopiesIt_IsTheFile()
        {
            string file = System.IO.Path.Combine(System.IO.Path.GetTempPath(), System.IO.Path.GetRandomFileName());
            System.IO.File.WriteAllText(file, RangeRig.Calibration);
            try
            {
                var rig = new RangeRig(new StubSource(1, 0), withCalibration: false);
                SerializedFields.Set(rig.Screen, "_calibrationFile", " \"" + file + "\" ");
                Assert.That(rig.Screen.ReadCalibration()!.ImageWidth, Is.EqualTo(640));
            }
            finally
            {
                System.IO.File.Delete(file);
            }
        }

        [Test]
        public void HandSourceThatIsTheSourceToo_IsOneMessageAndShotsAreFound()
        {
            var rig = new RangeRig(new StubSource(45, 0, (30, 320, 240)));
            SerializedFields.Set(rig.Screen, "_calibration", new TextAsset(RangeRig.TwoCameraCalibration));
            rig.Range.HandSource = rig.SourceAsset;
            rig.Play(2);
            ExpectOne(rig, "its hand source  is its source too, and one camera can serve only once, so nobody knows who fires; drag in the asset of the camera that sees the trainees, or none", isEnd: true);
            Assert.That(rig.Shots, Has.Count.EqualTo(1));
        }

        [Test]
        public void TwoRangesOnOneHandCamera_TheSecondSaysSoAndFindsShotsWithoutIt()
        {
            var rig = new RangeRig(new StubSource(45, 0, (30, 320, 240)));
            SerializedFields.Set(rig.Screen, "_calibration", new TextAsset(RangeRig.TwoCameraCalibration));
            StubSourceAsset hands = ScriptableObject.CreateInstance<StubSourceAsset>(), source = ScriptableObject.CreateInstance<StubSourceAsset>();
            int opened = 0;
            hands.Create = () =>
            {
                opened++;
                return new StubSource(45, 0);
            };
            source.Create = () => new StubSource(45, 0, (30, 320, 240));
            rig.Range.HandSource = hands;
            var second = new GameObject("second");
            second.SetActive(false);
            LaserRange other = second.AddComponent<LaserRange>();
            SerializedFields.Set(other, "_screen", rig.Screen);
            SerializedFields.Set(other, "_viewpoint", rig.Range.Viewpoint);
            SerializedFields.Set(other, "_source", source);
            SerializedFields.Set(other, "_handSource", hands);
            int shots = 0;
            other.ShotFired += _ => shots++;
            rig.Range.gameObject.SetActive(true);
            second.SetActive(true);
            for (int i = 0; i < 120; i++)
            {
                rig.Step(1 / 60.0);
                other.CompleteDueFrames();
            }

            Assert.That(ConsoleLog.Entries.Count(entry => entry.Message.StartsWith("LaserRange second: its hand source  already serves LaserRange range, and one camera can serve only once")), Is.EqualTo(1));
            ConsoleLog.Clear();
            Assert.That((rig.Shots.Count, shots, opened), Is.EqualTo((1, 1, 1)));
        }

        [TestCase(0, "")]
        [TestCase(1, "draws on display 2, which is not plugged in, so nobody sees its picture; plug the projector in and start anew, or set Target Display of the camera")]
        public void DisplayThatIsNotPluggedIn_IsOneMessageAndShotsAreFound(int display, string text)
        {
            var rig = new RangeRig(new StubSource(45, 0, (30, 320, 240)));
            rig.Range.Viewpoint!.gameObject.AddComponent<Camera>().targetDisplay = display;
            rig.Play(2);
            if (text.Length > 0)
                ExpectOne(rig, text, isEnd: true);
            Assert.That((ConsoleLog.Entries.Count, rig.Shots.Count), Is.EqualTo((display, 1)));
        }

        [TestCase("", "recording source : names no file; give the path of an Azure Kinect recording")]
        [TestCase("nowhere.mkv", "nowhere.mkv: no such file; check the name")]
        public void RecordingThatIsNotThere_IsOneMessage(string file, string text)
        {
            var rig = new RangeRig(new StubSource(1, 0));
            RecordingSource recording = ScriptableObject.CreateInstance<RecordingSource>();
            SerializedFields.Set(recording, "_file", file);
            rig.Range.Source = recording;
            rig.Play(5);
            ExpectOne(rig, text, isEnd: true);
        }

        [TestCase(false, "has no viewpoint and the scene no main camera: shots cannot hit anything; drag a viewpoint in or tag the camera MainCamera")]
        [TestCase(true, "")]
        public void SceneWithoutMainCamera_IsOneMessage(bool hasCamera, string text)
        {
            var rig = new RangeRig(new StubSource(45, 0, (30, 320, 240)));
            RangeRig.AddPlate("Plate 1", new Vector3(0, 0, 4), 0.5f).gameObject.SetActive(true);
            SerializedFields.Set(rig.Range, "_viewpoint", null);
            if (hasCamera)
                RangeRig.AddMainCamera();
            rig.Play(2);
            if (text.Length > 0)
                ExpectOne(rig, text, isEnd: true);
            Assert.That(ConsoleLog.Entries, Has.Count.EqualTo(hasCamera ? 0 : 1));
            Assert.That(rig.Shots.Single().HasHit, Is.EqualTo(hasCamera), "the main camera is the eye where none is given");
        }

        [Test]
        public void MouseInASceneWithoutMainCamera_IsOneMessageUntilThereIsOne()
        {
            var rig = new RangeRig(new StubSource(1, 0));
            rig.Range.Source = ScriptableObject.CreateInstance<MouseSource>();
            rig.Play(5);
            ExpectOne(rig, "mouse source : the scene has no main camera, so a click points nowhere; tag the camera that draws the picture MainCamera");
            RangeRig.AddMainCamera();
            rig.Play(3);
            Assert.That(rig.Range.IsRunning, Is.True);
        }

        [TestCase(0, 2.26f)]
        [TestCase(3.73f, -1)]
        [TestCase(float.PositiveInfinity, 2.26f)]
        [TestCase(3.73f, float.NaN)]
        public void ScreenWithoutSize_IsOneMessage(float widthM, float heightM)
        {
            var rig = new RangeRig(new StubSource(45, 0, (30, 320, 240)));
            SerializedFields.Set(rig.Screen, "_sizeM", new Vector2(widthM, heightM));
            rig.Play(2);
            ExpectOne(rig, "has no place for shots, so nothing can be hit; set the picture's width and height in metres", isEnd: true);
            Assert.That(rig.Shots.Single().HasHit, Is.False);
        }

        [Test]
        public void HandCameraThatCannotOpen_IsOneMessageAndTheRangePlays()
        {
            var rig = new RangeRig(new StubSource(45, 0, (30, 320, 240)));
            SerializedFields.Set(rig.Screen, "_calibration", new TextAsset(RangeRig.TwoCameraCalibration));
            StubSourceAsset hands = ScriptableObject.CreateInstance<StubSourceAsset>();
            hands.Create = () => throw new InputException("camera 1", "is not there", "plug it in");
            SerializedFields.Set(rig.Range, "_handSource", hands);
            rig.Play(2);
            ExpectOne(rig, "camera 1: is not there; plug it in; until the range is switched off and on again nobody knows who fires");
            Assert.That(rig.Shots, Has.Count.EqualTo(1));
        }

        [Test]
        public void SourceWhoseLibraryIsMissing_IsOneMessage()
        {
            var rig = new RangeRig(new StubSource(1, 0));
            rig.SourceAsset.Create = () => throw new DllNotFoundException("k4a");
            rig.SourceAsset.Live = true;
            rig.Play(5);
            ExpectOne(rig, "LaserRange range: the source  needs a library that is not there or does not fit (k4a); install it, or choose another source");
        }

        [Test]
        public void CalibrationFileThatIsDamaged_IsOneMessage()
        {
            using var folder = new TemporaryFolder();
            Desk.PersistentDataPath = folder.Path;
            System.IO.File.WriteAllText(System.IO.Path.Combine(folder.Path, "screen.json"), "{");
            var rig = new RangeRig(new StubSource(45, 0));
            SerializedFields.Set(rig.Screen, "_calibrationFile", "screen.json");
            rig.Play(1);
            Assert.That(ConsoleLog.Entries.Single().Message, Does.Contain("screen.json: ").And.Contain("JSON"));
            Assert.That(rig.Health, Has.Count.EqualTo(1));
        }

        [TestCase(typeof(ShotVisuals), "has no emitter, so it shows nothing; drag the LaserRange in")]
        [TestCase(typeof(Scoreboard), "cannot be seen: its UIDocument has no panel settings; drag RangePanel in")]
        public void VisualPartOnItsOwn_IsOneMessage(Type part, string text)
        {
            var rig = new RangeRig(new StubSource(45, 0));
            rig.Range.gameObject.SetActive(true);
            var owner = new GameObject("part");
            owner.SetActive(false);
            Component added = owner.AddComponent(part);
            if (part == typeof(Scoreboard))
                SerializedFields.Set(added, "_emitter", rig.Range);
            owner.SetActive(true);
            rig.Play(1);
            ExpectOne(rig, text, isEnd: true);
        }

        private static void ExpectOne(RangeRig rig, string text, bool isEnd = false)
        {
            Assert.That(ConsoleLog.Entries, Has.Count.EqualTo(1));
            Assert.That(ConsoleLog.Entries[0].Message, isEnd ? Does.EndWith(text) : Is.EqualTo(text));
            Assert.That(rig.Health.Select(health => health.Text), Is.EqualTo(new[] { ConsoleLog.Entries[0].Message }));
        }
    }
}
