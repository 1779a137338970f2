using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace LaserTracking.Repository
{
    /// <summary>
    /// Unity reads a subset of YAML: no comments, no blank lines, no block scalars, plain text in ASCII. What it cannot read it drops
    /// or refuses, so files written by hand are held to the subset here.
    /// </summary>
    public sealed class UnityYamlTests
    {
        private const int GameObject = 1;
        private const int Transform = 4;
        private const int PrefabInstance = 1001;
        private const int SceneRoots = 1660057539;

        // Unity's built-in resources.
        private static readonly string[] BuiltIn = { "0000000000000000e000000000000000", "0000000000000000f000000000000000" };

        private static readonly Dictionary<string, string> AssetOfGuid = RepositoryFiles.Metas.ToDictionary(
            meta => Regex.Match(RepositoryFiles.Read(meta), "^guid: (\\w+)$", RegexOptions.Multiline).Groups[1].Value, meta => meta.Substring(0, meta.Length - ".meta".Length));

        private static IEnumerable<string> Files => RepositoryFiles.YamlFiles();

        // Of Unity's own scripts those that are used: PanelSettings, UIDocument.
        private static readonly string[] BuiltInScripts = { "{fileID: 19101, guid: 0000000000000000e000000000000000, type: 0}", "{fileID: 19102, guid: 0000000000000000e000000000000000, type: 0}" };

        private static IEnumerable<string> Hierarchies => Files.Where(path => path.EndsWith(".unity", StringComparison.Ordinal) || path.EndsWith(".prefab", StringComparison.Ordinal));

        private static IEnumerable<string> Scenes => Files.Where(path => path.EndsWith(".unity", StringComparison.Ordinal));

        [TestCaseSource(nameof(Files))]
        public void Yaml_File_StaysInUnitysSubset(string path)
        {
            string[] lines = RepositoryFiles.Read(path).Split('\n');
            Assert.That(lines.Last(), Is.Empty, "a line feed at the end");
            Assert.That(lines.Take(2), Is.EqualTo(new[] { "%YAML 1.1", "%TAG !u! tag:unity3d.com,2011:" }));
            var wrong = new List<string>();
            for (int i = 2; i < lines.Length - 1; i++)
            {
                string problem = ProblemOf(lines[i]);
                if (problem != "")
                    wrong.Add(path + " line " + (i + 1) + ": " + problem + ": " + lines[i]);
            }

            Assert.That(wrong, Is.Empty);
        }

        [TestCase("", "blank line")]
        [TestCase("  m_Name: a\tb", "not printable ASCII")]
        [TestCase("  m_Name: Grün", "not printable ASCII")]
        [TestCase("# a remark", "comment")]
        [TestCase("  m_Name: a # remark", "comment")]
        [TestCase("  m_Text: |", "block scalar")]
        [TestCase("  m_Text: >-", "block scalar")]
        [TestCase("   m_Name: a", "odd indentation")]
        [TestCase("--- !u!1 &12 stripped", "document head")]
        [TestCase("  ? complex", "complex key")]
        [TestCase("  m_Name: 'a # b'", "")]
        [TestCase("  - component: {fileID: 12}", "")]
        [TestCase("--- !u!1 &12", "")]
        public void ProblemOf_Line_IsFound(string line, string problem)
        {
            Assert.That(ProblemOf(line), Is.EqualTo(problem));
        }

        [TestCaseSource(nameof(Files))]
        public void Yaml_References_Resolve(string path)
        {
            List<YamlDocument> documents = YamlDocument.Read(path);
            Assert.That(documents, Is.Not.Empty);
            Assert.That(documents.Select(document => document.FileId), Is.Unique);
            Assert.That(documents.Where(document => document.ClassId == PrefabInstance), Is.Empty, "prefab instances are not written by hand");
            var ids = new HashSet<long>(documents.Select(document => document.FileId)) { 0 };
            var wrong = new List<string>();
            foreach (YamlDocument document in documents)
            {
                foreach ((long fileId, string guid) in document.References)
                {
                    if (guid == "" && !ids.Contains(fileId))
                        wrong.Add(document + ": no document &" + fileId);
                    if (guid != "" && !BuiltIn.Contains(guid) && !AssetOfGuid.ContainsKey(guid))
                        wrong.Add(document + ": no asset with GUID " + guid);
                }
            }

            Assert.That(wrong, Is.Empty);
        }

        [TestCaseSource(nameof(Files))]
        public void Yaml_References_LeadNowhereThatMayBeMissing(string path)
        {
            // A sample needs only the package, which needs nothing else; this project has both but not the samples.
            string home = IsOfASample(path) ? string.Join("/", path.Split('/').Take(4)) + "/" : path.Split('/')[0] + "/";
            IEnumerable<string> outside = YamlDocument.Read(path).SelectMany(document => document.References)
                .Where(reference => AssetOfGuid.ContainsKey(reference.Guid)).Select(reference => AssetOfGuid[reference.Guid])
                .Where(asset => IsOfASample(asset) || !asset.StartsWith(RepositoryFiles.Package + "/", StringComparison.Ordinal))
                .Where(asset => !asset.StartsWith(home, StringComparison.Ordinal) || IsOfASample(asset) != IsOfASample(path));
            Assert.That(outside, Is.Empty);
        }

        [TestCaseSource(nameof(Files))]
        public void Yaml_Scripts_AreClassesNamedAsTheirFiles(string path)
        {
            foreach (YamlDocument document in YamlDocument.Read(path).Where(document => document.ClassId == 114))
            {
                if (document.Lines.Any(line => BuiltInScripts.Any(script => line == "  m_Script: " + script)))
                    continue;
                Assert.That(AssetOfGuid.TryGetValue(document.ScriptGuid, out string? script), Is.True, document + ": script " + document.ScriptGuid);
                Assert.That(script, Does.EndWith(".cs"), document.ToString());
                Assert.That(RepositoryFiles.Read(script!), Does.Match("class " + Path.GetFileNameWithoutExtension(script) + @"\b[^{]*:"), document.ToString());
            }
        }

        [TestCaseSource(nameof(Hierarchies))]
        public void Scene_Hierarchy_AgreesInBothDirections(string path)
        {
            List<YamlDocument> documents = YamlDocument.Read(path);
            var byId = documents.ToDictionary(document => document.FileId);
            var wrong = new List<string>();
            foreach (YamlDocument document in documents)
            {
                if (document.ClassId == GameObject)
                {
                    long[] components = document.Ids("m_Component").ToArray();
                    if (components.Length == 0 || byId[components[0]].ClassId != Transform)
                        wrong.Add(document + ": the first component is not a Transform");
                    wrong.AddRange(components.Where(id => byId[id].Ids("m_GameObject").Single() != document.FileId).Select(id => byId[id] + ": belongs to another object than " + document));
                    continue;
                }

                foreach (long owner in document.Ids("m_GameObject").Where(id => id != 0 && !byId[id].Ids("m_Component").Contains(document.FileId)))
                    wrong.Add(document + ": object &" + owner + " does not list it");
                if (document.ClassId == Transform)
                    wrong.AddRange(FamilyProblems(document, byId));
            }

            Assert.That(wrong, Is.Empty);
        }

        [TestCaseSource(nameof(Scenes))]
        public void Scene_Roots_AreAllTransformsWithoutFather(string path)
        {
            List<YamlDocument> documents = YamlDocument.Read(path);
            YamlDocument roots = documents.Last();
            Assert.That(roots.ClassId, Is.EqualTo(SceneRoots), "the list of roots closes a scene");
            Assert.That(roots.FileId, Is.EqualTo(long.MaxValue));
            Assert.That(roots.Ids("m_Roots"), Is.EquivalentTo(documents.Where(document => document.ClassId == Transform && document.Ids("m_Father").Single() == 0).Select(document => document.FileId)));
        }

        [TestCaseSource(nameof(Hierarchies))]
        public void Prefab_Root_IsOne(string path)
        {
            if (path.EndsWith(".prefab", StringComparison.Ordinal))
                Assert.That(YamlDocument.Read(path).Count(document => document.ClassId == Transform && document.Ids("m_Father").Single() == 0), Is.EqualTo(1));
        }

        [Test]
        public void EditorBuildSettings_Scenes_AreThereUnderTheirGuids()
        {
            const string Settings = "ProjectSettings/EditorBuildSettings.asset";
            if (!File.Exists(RepositoryFiles.Absolute(Settings)))
                Assert.Ignore(Settings + " is not there");
            MatchCollection entries = Regex.Matches(RepositoryFiles.Read(Settings), @"    path: (\S+)\n    guid: (\w+)\n");
            Assert.That(entries, Is.Not.Empty);
            foreach (Match entry in entries)
                Assert.That(AssetOfGuid.GetValueOrDefault(entry.Groups[2].Value), Is.EqualTo(entry.Groups[1].Value));
        }

        private static bool IsOfASample(string path) => path.StartsWith(RepositoryFiles.Samples + "/", StringComparison.Ordinal);

        private static IEnumerable<string> FamilyProblems(YamlDocument transform, Dictionary<long, YamlDocument> byId)
        {
            foreach (long child in transform.Ids("m_Children").Where(id => byId[id].Ids("m_Father").Single() != transform.FileId))
                yield return byId[child] + ": has another father than " + transform;
            foreach (long father in transform.Ids("m_Father").Where(id => id != 0 && !byId[id].Ids("m_Children").Contains(transform.FileId)))
                yield return transform + ": its father &" + father + " does not list it";
        }

        private static string ProblemOf(string line)
        {
            if (line.Trim() == "")
                return "blank line";
            if (line.Any(letter => letter < ' ' || letter > '~'))
                return "not printable ASCII";
            if (line.StartsWith("---", StringComparison.Ordinal))
                return Regex.IsMatch(line, @"^--- !u!\d+ &-?\d+$") ? "" : "document head";
            string text = line.TrimStart(' ');
            if ((line.Length - text.Length) % 2 != 0)
                return "odd indentation";
            string unquoted = Regex.Replace(text, "'(?:[^']|'')*'|\"(?:[^\"\\\\]|\\\\.)*\"", "''");
            if (unquoted.StartsWith("#", StringComparison.Ordinal) || unquoted.Contains(" #", StringComparison.Ordinal))
                return "comment";
            if (Regex.IsMatch(unquoted, @"(?:^|: |- )[|>][-+0-9]*$"))
                return "block scalar";
            return unquoted.StartsWith("? ", StringComparison.Ordinal) ? "complex key" : "";
        }
    }
}
