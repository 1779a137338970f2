using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Text.RegularExpressions;
using NUnit.Framework;

namespace LaserTracking.Repository
{
    /// <summary>Unity knows an asset by the GUID in its .meta: without one it is ignored or given a new one, and scenes lose it.</summary>
    public sealed class MetaFileTests
    {
        private static readonly Regex GuidLine = new Regex("^guid: ([0-9a-f]{32})$");

        [Test]
        public void Asset_EveryOne_HasAMeta()
        {
            Assert.That(RepositoryFiles.Assets, Is.Not.Empty);
            Assert.That(RepositoryFiles.Assets.Where(path => !File.Exists(RepositoryFiles.Absolute(path + ".meta"))), Is.Empty, "run DotNet~/tools/create-metas.sh");
        }

        [Test]
        public void Meta_EveryOne_HasAnAsset()
        {
            IEnumerable<string> orphans = RepositoryFiles.Metas.Where(meta =>
            {
                string asset = RepositoryFiles.Absolute(meta.Substring(0, meta.Length - ".meta".Length));
                return !File.Exists(asset) && !Directory.Exists(asset);
            });
            Assert.That(orphans, Is.Empty);
        }

        [Test]
        public void Meta_Guid_IsWellFormedAndUnique()
        {
            var owners = new Dictionary<string, string>();
            var wrong = new List<string>();
            foreach (string meta in RepositoryFiles.Metas)
            {
                string[] lines = RepositoryFiles.Read(meta).Split('\n');
                Match guid = GuidLine.Match(lines.Length > 1 ? lines[1] : "");
                if (lines[0] != "fileFormatVersion: 2" || !guid.Success)
                    wrong.Add(meta + ": must begin with the format version and a GUID of 32 lower-case hex digits");
                else if (!owners.TryAdd(guid.Groups[1].Value, meta))
                    wrong.Add(meta + ": same GUID as " + owners[guid.Groups[1].Value]);
            }

            Assert.That(wrong, Is.Empty);
        }

        [Test]
        public void Meta_Importer_FitsTheKindOfAsset()
        {
            var wrong = new List<string>();
            foreach (string path in RepositoryFiles.Assets)
            {
                string meta = RepositoryFiles.Read(path + ".meta");
                string importer = RepositoryFiles.IsFolder(path) ? "folderAsset: yes" : Path.GetExtension(path) switch
                {
                    ".cs" => "MonoImporter:",
                    ".asmdef" => "AssemblyDefinitionImporter:",
                    ".asset" => "mainObjectFileID: 11400000",
                    ".mat" => "mainObjectFileID: 2100000",
                    ".md" => "TextScriptImporter:",
                    ".json" => path == RepositoryFiles.Package + "/package.json" ? "PackageManifestImporter:" : "TextScriptImporter:",
                    ".prefab" => "PrefabImporter:",
                    ".tss" => "ScriptedImporter:",
                    ".dll" => "PluginImporter:",
                    _ => "DefaultImporter:",
                };
                if (!meta.Contains("\n" + importer, StringComparison.Ordinal) && !meta.Contains("  " + importer + "\n", StringComparison.Ordinal))
                    wrong.Add(path + ": its .meta has no " + importer);
            }

            Assert.That(wrong, Is.Empty);
        }

        [Test]
        public void Path_Length_IsWithinUnitysLimits()
        {
            // 140 characters inside the package and ten folders deep: the rules of Unity's package validation.
            IEnumerable<string> inside = RepositoryFiles.Assets.Concat(RepositoryFiles.Metas)
                .Where(path => path.StartsWith(RepositoryFiles.Package + "/", StringComparison.Ordinal)).Select(path => path.Substring(RepositoryFiles.Package.Length + 1));
            Assert.That(inside.Where(path => path.Length > 140 || path.Count(letter => letter == '/') > 10), Is.Empty);
        }

        [Test]
        public void Folder_EveryOne_HoldsSomething()
        {
            Assert.That(RepositoryFiles.Assets.Where(RepositoryFiles.IsFolder).Where(folder => !RepositoryFiles.Assets.Any(path => path.StartsWith(folder + "/", StringComparison.Ordinal))), Is.Empty);
        }
    }
}
