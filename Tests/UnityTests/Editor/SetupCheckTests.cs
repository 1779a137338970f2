using System.Linq;
using LaserTracking.Editor;
using LaserTracking.Scoring;
using NUnit.Framework;
using UnityEditor;
using UnityEditorStandIn;
using UnityEngine;
using UnityEngine.SceneManagement;
using UnityStandIn;

namespace LaserTracking.Unity
{
    public sealed class SetupCheckTests : StandInTests
    {
        [SetUp]
        public void Reset() => EditorLog.Reset();

        [Test]
        public void NextStep_LeadsStepByStepToARangeThatWorks()
        {
            var facts = new SetupFacts();
            Assert.That(Next(facts), Does.StartWith("range: choose GameObject"));
            facts.Ranges = 1;
            Assert.That(Next(facts), Does.StartWith("camera 0: drag a source"));
            facts.Source = "Simulation";
            Assert.That(Next(facts), Does.StartWith("screen: drag a ScreenSurface"));
            facts.HasScreen = true;
            Assert.That(Next(facts), Does.StartWith("screen: give the ScreenSurface the size"));
            facts.HasScreenSize = true;
            Assert.That(Next(facts), Does.StartWith("calibration: calibrate"));
            facts.CalibrationProblem = "calibration of Screen: not JSON; make it anew";
            Assert.That(Next(facts), Is.EqualTo("calibration: " + facts.CalibrationProblem));
            facts.CalibrationProblem = "";
            facts.HasCalibration = true;
            Assert.That(Next(facts), Does.StartWith("viewpoint: drag the camera"));
            facts.HasViewpoint = true;
            Assert.That(Next(facts), Does.StartWith("targets: nothing can be hit"));
            facts.Targets = 2;
            facts.TargetsWithoutCollider = new[] { "Plate" };
            Assert.That(Next(facts), Is.EqualTo("targets: without a collider nothing hits Plate; add one"));
            facts.TargetsWithoutCollider = new string[0];
            Assert.That(Next(facts), Is.Empty);
            facts.Ranges = 2;
            Assert.That(Next(facts), Does.Contain("the scene has 2 of them"));
        }

        [Test]
        public void Check_Libraries_AreActiveOrAsleepAndNeverMissing()
        {
            SetupLine[] lines = SetupCheck.Check(new SetupFacts { IsKinectAwake = true }).ToArray();
            Assert.That(lines.Single(line => line.Name.Contains("Kinect")).State, Is.EqualTo(SetupState.Active));
            Assert.That(lines.Single(line => line.Name.Contains("OpenCV")).State, Is.EqualTo(SetupState.Asleep));
        }

        [TestCase("RANGE_KINECT", "Microsoft.Azure.Kinect.Sensor.dll")]
        [TestCase("RANGE_OPENCV", "OpenCvSharp.dll")]
        [TestCase("RANGE_MATHNET", "MathNet.Numerics.dll")]
        public void Symbol_SetWithoutItsLibrary_IsSaidInPlainWords(string symbol, string file)
        {
            string said = symbol + " is set, but " + file + " is not in the project";
            EditorLog.Files.AddRange(new[] { "Assets/Readme.md", "Assets/Plugins/" + file + ".txt", "Assets/Plugins/x86_64/OpenCvSharpExtern.dll" });
            EditorLog.LoadScripts(typeof(SetupCheck).Assembly);
            Assert.That(ConsoleLog.Entries, Is.Empty, "nothing is asked for");
            EditorLog.Symbols.AddRange(new[] { "UNITY_EDITOR", symbol });
            EditorLog.FailToCompile();
            Assert.That(ConsoleLog.Entries.Single().Message, Does.StartWith(said).And.Contain("Scripting Define Symbols"));
            Assert.That(Next(SetupFacts.Of(SceneManager.GetActiveScene())), Does.StartWith("libraries: " + said));

            ConsoleLog.Clear();
            EditorLog.Files.Add("Packages/org.nuget.library/" + file);
            EditorLog.FailToCompile();
            EditorLog.LoadScripts(typeof(SetupCheck).Assembly);
            Assert.That(ConsoleLog.Entries, Is.Empty, "the library is there: what fails is something else");
            Assert.That(Next(SetupFacts.Of(SceneManager.GetActiveScene())), Does.StartWith("range: "));
        }

        [Test]
        public void Libraries_ThatTheEditorKnows_AreThoseOfTheAssemblyDefinitions()
        {
            foreach (OptionalLibrary library in OptionalLibrary.All)
            {
                string definition = System.IO.Directory.GetFiles(System.IO.Path.Combine(TestFiles.Repository, "Packages", "com.range.lasertracking", "Runtime"), library.Assembly + ".asmdef", System.IO.SearchOption.AllDirectories).Single();
                Assert.That(System.IO.File.ReadAllText(definition), Does.Contain("\"defineConstraints\": [\"" + library.Symbol + "\"]").And.Contain("\"precompiledReferences\": [\"" + library.File + "\"]"));
            }
        }

        [Test]
        public void Facts_OfARig_AreWhatItHas()
        {
            var rig = new RangeRig(new StubSource(1, 0));
            rig.SourceAsset.name = "stub";
            LaserTarget target = RangeRig.AddPlate("plate", new Vector3(0, 0, 4), 0.5f);
            Object.DestroyImmediate(target.GetComponent<Collider>());
            SetupFacts facts = SetupFacts.Of(SceneManager.GetActiveScene());
            Assert.That((facts.Ranges, facts.HasScreen, facts.HasScreenSize, facts.HasCalibration, facts.HasViewpoint, facts.Source), Is.EqualTo((1, true, true, true, true, "stub")));
            Assert.That(facts.TargetsWithoutCollider, Is.EqualTo(new[] { "plate" }), "inactive ones too");
            SerializedFields.Set(rig.Screen, "_calibration", new TextAsset("{"));
            Assert.That(SetupFacts.Of(SceneManager.GetActiveScene()).CalibrationProblem, Does.StartWith("calibration of screen: "));
        }

        [Test]
        public void Menu_AddsThePrefab_ThatNeedsOnlyACameraAndTargets()
        {
            SceneLoader.Load(System.IO.Path.Combine(TestFiles.Repository, RangeMenu.Prefab));
            EditorLog.Assets[RangeMenu.Prefab] = PlayerLoop.All<LaserRange>().Single().gameObject;
            RangeMenu.AddRange();
            var range = Selection.activeGameObject.GetComponent<LaserRange>();
            Assert.That(range.Screen, Is.Not.Null);
            Assert.That(EditorLog.Undoable, Has.Count.EqualTo(1));
            Assert.That(Next(SetupFacts.Of(SceneManager.GetActiveScene())), Does.StartWith("viewpoint: "), "the empty scene has no camera");
            new GameObject("eye") { tag = "MainCamera" }.AddComponent<Camera>();
            SetupWindow window = EditorLog.Windows.OfType<SetupWindow>().Single();
            Call(window, "OnEnable");
            Call(window, "OnGUI");
            Assert.That(EditorLog.Drawn[0], Does.StartWith("Warning: Next: targets: nothing can be hit"));
            Assert.That(EditorLog.Drawn.Count(line => line.StartsWith("[x]")), Is.GreaterThanOrEqualTo(5));
        }

        [Test]
        public void Menu_WithoutThePrefab_SaysSo()
        {
            RangeMenu.AddRange();
            Assert.That(ConsoleLog.Entries.Single().Message, Does.Contain("install the package anew"));
        }

        [Test]
        public void Inspector_OfATarget_DrawsEveryZoneWithItsPoints()
        {
            var inspector = ScriptableObject.CreateInstance<TargetDefinitionInspector>();
            inspector.target = RangeRig.Definition("plate", 0.5f);
            inspector.OnInspectorGUI();
            Assert.That(EditorLog.Drawn, Is.EqualTo(new[] { "line of 5", "label plate 5" }));
            SerializedFields.Set(inspector.target, "_sizeM", new Vector2(-1, 0));
            EditorLog.Drawn.Clear();
            inspector.OnInspectorGUI();
            Assert.That(EditorLog.Drawn.Single(), Does.StartWith("Error: target definition plate: "));
        }

        [Test]
        public void Outline_OfZones_IsUprightAndFits()
        {
            var outline = new ZoneOutline(new Geometry.Vector2D(1, 0.5), new Rect(100, 200, 216, 216));
            Assert.That(outline.ToPx(default), Is.EqualTo(new Vector3(208, 308, 0)));
            Assert.That(outline.ToPx(new Geometry.Vector2D(0.5, 0.25)), Is.EqualTo(new Vector3(308, 258, 0)), "up is less");
            var ellipse = new TargetZone("x", 1, ZoneShape.Ellipse, default, new Geometry.Vector2D(0.2, 0.4), new Geometry.Vector2D[0]);
            Vector3[] points = outline.Of(ellipse);
            Assert.That(points.Length, Is.EqualTo(49));
            Assert.That(points.Max(point => point.x), Is.EqualTo(228).Within(0.01));
            Assert.That(points.Min(point => point.y), Is.EqualTo(268).Within(0.01));
            Assert.That(points[48], Is.EqualTo(points[0]));
        }

        [TestCase(RuntimePlatform.WindowsEditor, ".exe", BuildTarget.StandaloneWindows64)]
        [TestCase(RuntimePlatform.OSXEditor, ".app", BuildTarget.StandaloneOSX)]
        [TestCase(RuntimePlatform.LinuxEditor, ".x86_64", BuildTarget.StandaloneLinux64)]
        public void Build_Options_AreThoseOfThisSystem(RuntimePlatform platform, string ending, BuildTarget target)
        {
            EditorBuildSettingsScene[] scenes = { new EditorBuildSettingsScene("A.unity", true), new EditorBuildSettingsScene("B.unity", false) };
            Assert.That(TrainerBuild.TryMakeOptions(scenes, "/x", platform, out BuildPlayerOptions options, out _), Is.True);
            Assert.That((options.locationPathName, options.target, string.Join(",", options.scenes)), Is.EqualTo(("/x/Laser Range" + ending, target, "A.unity")));
        }

        [Test]
        public void Build_WithoutScenesOrFolder_BuildsNothing()
        {
            TrainerBuild.Build();
            EditorLog.FolderChosen = "/x";
            TrainerBuild.Build();
            Assert.That(EditorLog.Built, Is.Empty);
            Assert.That(ConsoleLog.Entries.Single().Message, Does.Contain("the build settings have no scene"));
            EditorBuildSettings.scenes = new[] { new EditorBuildSettingsScene("A.unity", true) };
            TrainerBuild.Build();
            Assert.That(EditorLog.Built, Has.Count.EqualTo(1));
            Assert.That(ConsoleLog.Entries.Last().Message, Does.Contain("-range-calibration FILE"));
        }

        [Test]
        public void Gizmos_OfAnyRange_AreDrawn()
        {
            var rig = new RangeRig(new StubSource(1, 0));
            Assert.That(() => RangeGizmos.Draw(rig.Range, GizmoType.Selected), Throws.Nothing);
            SerializedFields.Set(rig.Screen, "_calibration", new TextAsset("{"));
            Assert.That(() => RangeGizmos.Draw(rig.Range, GizmoType.Selected), Throws.Nothing);
            SerializedFields.Set(rig.Range, "_screen", null!);
            Assert.That(() => RangeGizmos.Draw(rig.Range, GizmoType.Selected), Throws.Nothing);
        }

        [Test]
        public void Gizmos_CalibrationWithCheckPoints_DrawsHowFarItIsOff()
        {
            var rig = new RangeRig(new StubSource(1, 0));
            SerializedFields.Set(rig.Screen, "_calibration", new TextAsset(RangeRig.Calibration.TrimEnd('}') + ",\"residuals_mm\":[[1.865,1.13,20,0],[0,0,0,-30]]}"));
            RangeGizmos.Draw(rig.Range, GizmoType.Selected);
            var lines = GizmoLines.Drawn.Where(line => line.Color.Equals(Color.red)).ToArray();
            Assert.That(lines, Has.Length.EqualTo(2));
            Assert.That(new[] { lines[0].From.magnitude, lines[0].To.x }, Is.EqualTo(new[] { 0f, 0.2f }).Within(1e-5), "20 mm, ten times as far");
            Assert.That((lines[1].To - lines[1].From).y, Is.EqualTo(0.3f).Within(1e-5), "screen space's y goes down");
        }

        private static string Next(SetupFacts facts) => SetupCheck.NextStep(SetupCheck.Check(facts));

        private static void Call(object target, string message) =>
            target.GetType().GetMethod(message, System.Reflection.BindingFlags.Instance | System.Reflection.BindingFlags.NonPublic)!.Invoke(target, null);
    }
}
