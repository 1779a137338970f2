using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using LaserTracking.Host.Scenes;
using NUnit.Framework;

namespace LaserTracking.Scenes
{
    /// <summary>What the headless reader believes of the package's components against the components' files.</summary>
    public sealed class ProductScriptsTests
    {
        private static readonly IEnumerable<string> Classes = ProductScripts.FieldsByClass.Keys;

        [TestCaseSource(nameof(Classes))]
        public void ProductScripts_GuidAndFields_AreThoseOfTheComponent(string name)
        {
            string script = Path.Combine(TestFiles.Repository, Relative(name));
            string guid = Regex.Match(File.ReadAllText(script + ".meta"), "^guid: ([0-9a-f]{32})$", RegexOptions.Multiline).Groups[1].Value;
            Assert.That(ProductScripts.ClassByGuid.GetValueOrDefault(guid), Is.EqualTo(name));
            string source = File.ReadAllText(script);
            if (source.Contains(": ShotEmitter", StringComparison.Ordinal))
                source += File.ReadAllText(Path.Combine(TestFiles.Repository, Relative("ShotEmitter")));
            IEnumerable<string> fields = Regex.Matches(source,
                @"\[SerializeField\](?:\s*\[(?:""[^""]*""|[^\]""])*\])*\s*private\s[^;=]*?\s(_\w+)\s*[=;]").Select(match => match.Groups[1].Value);
            Assert.That(fields, Is.EquivalentTo(ProductScripts.FieldsByClass[name].Concat(ProductScripts.EventsByClass.GetValueOrDefault(name, Array.Empty<string>()))));
        }

        [Test]
        public void ProductScripts_ShowingComponents_AreThoseOfTheirGuids()
        {
            foreach ((string guid, string name) in ProductScripts.ShowingByGuid)
                Assert.That(File.ReadAllText(Path.Combine(TestFiles.Repository, Relative(name) + ".meta")), Does.Contain("guid: " + guid), name);
        }

        private static string Relative(string name)
        {
            string folder = Path.Combine(TestFiles.Repository, "Packages", "com.range.lasertracking", "Runtime", "Unity");
            return Path.GetRelativePath(TestFiles.Repository, Directory.GetFiles(folder, name + ".cs", SearchOption.AllDirectories).Single());
        }
    }
}
