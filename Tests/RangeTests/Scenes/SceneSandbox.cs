using System;
using System.IO;
using LaserTracking.Host.Scenes;
using LaserTracking.Scoring;
using NUnit.Framework;

namespace LaserTracking.Scenes
{
    /// <summary>A copy of the repository's Assets in a temporary project, to be damaged by a test.</summary>
    internal sealed class SceneSandbox : IDisposable
    {
        private readonly string _root = Path.Combine(Path.GetTempPath(), "range-scene-" + Guid.NewGuid().ToString("N"));

        public SceneSandbox()
        {
            string from = Path.Combine(TestFiles.Repository, "Assets");
            foreach (string folder in Directory.EnumerateDirectories(from, "*", SearchOption.AllDirectories))
                Directory.CreateDirectory(Path.Combine(_root, "Assets", Path.GetRelativePath(from, folder)));
            foreach (string file in Directory.EnumerateFiles(from, "*", SearchOption.AllDirectories))
                File.Copy(file, Path.Combine(_root, "Assets", Path.GetRelativePath(from, file)));
            Text = File.ReadAllText(Scene);
        }

        public string Scene => PathOf("Assets/Scenes/Range.unity");

        /// <summary>The scene, to be changed and then read.</summary>
        public string Text { get; set; }

        public string PathOf(string relative) => Path.Combine(_root, relative);

        /// <summary>Changes the first occurrence; the test fails when there is none.</summary>
        public void Replace(string old, string by) => Text = ReplaceFirst(Text, old, by);

        /// <summary>Changes the first occurrence after the object of the name.</summary>
        public void ReplaceIn(string objectName, string old, string by)
        {
            int at = Text.IndexOf("  m_Name: " + objectName + "\n", StringComparison.Ordinal);
            Assert.That(at, Is.GreaterThan(0), objectName);
            Text = Text[..at] + ReplaceFirst(Text[at..], old, by);
        }

        public void ReplaceInAsset(string relative, string old, string by)
        {
            string path = PathOf(relative);
            File.WriteAllText(path, ReplaceFirst(File.ReadAllText(path), old, by));
        }

        public SceneModel Read()
        {
            File.WriteAllText(Scene, Text);
            return UnitySceneReader.Read(Scene);
        }

        /// <summary>The scene is refused with one line that names the file and holds all the parts.</summary>
        public void ExpectRefusal(params string[] parts)
        {
            InputException? refusal = Assert.Throws<InputException>(() => Read());
            string message = refusal!.Message;
            Assert.That(message, Does.Not.Contain("\n"));
            Assert.That(message, Does.StartWith(_root));
            foreach (string part in parts)
                Assert.That(message, Does.Contain(part));
        }

        public void Dispose() => Directory.Delete(_root, true);

        private static string ReplaceFirst(string text, string old, string by)
        {
            int at = text.IndexOf(old, StringComparison.Ordinal);
            Assert.That(at, Is.GreaterThanOrEqualTo(0), "not there to be changed: " + old);
            return text[..at] + by + text[(at + old.Length)..];
        }
    }
}
