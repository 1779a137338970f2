using System.IO;
using System.Linq;
using LaserTracking.Host.Scenes;
using NUnit.Framework;

namespace LaserTracking.Scenes
{
    /// <summary>The settings of the Unity project that the headless raycaster and the scene rely on.</summary>
    public sealed class ProjectSettingsTests
    {
        [Test]
        public void ProjectSettings_PhysicsQueries_AreThoseOfTheAnalyticRaycaster()
        {
            UnityFields physics = Read("DynamicsManager", 55);
            Assert.That(physics.Integer("m_QueriesHitTriggers"), Is.EqualTo(1));
            Assert.That(physics.Integer("m_QueriesHitBackfaces"), Is.EqualTo(0));
        }

        [Test]
        public void ProjectSettings_Layers_NameTheTargets()
        {
            string[] lines = File.ReadAllLines(PathOf("TagManager"));
            string[] layers = lines.SkipWhile(line => line != "  layers:").Skip(1).TakeWhile(line => line.StartsWith("  - ", System.StringComparison.Ordinal)).ToArray();
            Assert.That(layers, Has.Length.EqualTo(32));
            Assert.That(layers[8], Is.EqualTo("  - Targets"));
            Assert.That(layers[0], Is.EqualTo("  - Default"));
        }

        [Test]
        public void ProjectSettings_BuildScene_IsTheShippedOne()
        {
            UnityFields scene = Read("EditorBuildSettings", 1045).Items("m_Scenes").Single();
            Assert.That(scene.Integer("enabled"), Is.EqualTo(1));
            string meta = File.ReadAllText(Path.Combine(TestFiles.Repository, scene.Text("path") + ".meta"));
            Assert.That(meta, Does.Contain("guid: " + scene.Text("guid") + "\n"));
        }

        [Test]
        public void ProjectSettings_Editor_SerialisesAsTextOnOneLine()
        {
            UnityFields editor = Read("EditorSettings", 159);
            Assert.That(editor.Integer("m_SerializationMode"), Is.EqualTo(2));
            Assert.That(editor.Integer("m_SerializeInlineMappingsOnOneLine"), Is.EqualTo(1));
        }

        private static UnityFields Read(string name, int classId) =>
            UnityFields.Parse(UnityDocument.ReadAll(PathOf(name)).Single(document => document.ClassId == classId));

        private static string PathOf(string name) => Path.Combine(TestFiles.Repository, "ProjectSettings", name + ".asset");
    }
}
