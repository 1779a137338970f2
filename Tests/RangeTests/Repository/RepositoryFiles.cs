using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;

namespace LaserTracking.Repository
{
    /// <summary>What Unity sees of the repository, and the text files that people edit. Paths are relative, with '/'.</summary>
    internal static class RepositoryFiles
    {
        public const string Package = "Packages/com.range.lasertracking";
        public const string Core = Package + "/Runtime/Core";

        /// <summary>Hidden from Unity until somebody imports one: then it is copied into Assets, GUIDs and all.</summary>
        public const string Samples = Package + "/Samples~";

        private static readonly string[] TextExtensions =
        {
            ".cs", ".csproj", ".slnx", ".props", ".json", ".asmdef", ".md", ".meta", ".rsp", ".sh", ".yml", ".unity", ".asset", ".mat", ".prefab", ".txt",
        };

        /// <summary>Files and folders that Unity imports, with the samples; .meta files left out.</summary>
        public static IReadOnlyList<string> Assets { get; } = Imported().Where(path => !path.EndsWith(".meta", StringComparison.Ordinal)).ToList();

        public static IReadOnlyList<string> Metas { get; } = Imported().Where(path => path.EndsWith(".meta", StringComparison.Ordinal)).ToList();

        /// <summary>C# that Unity compiles.</summary>
        public static IReadOnlyList<string> UnitySources { get; } = Assets.Where(path => path.EndsWith(".cs", StringComparison.Ordinal)).ToList();

        /// <summary>All C# of the repository.</summary>
        public static IReadOnlyList<string> Sources { get; } = TextFiles().Where(path => path.EndsWith(".cs", StringComparison.Ordinal)).ToList();

        public static string Absolute(string path) => Path.Combine(TestFiles.Repository, path);

        public static string Read(string path) => File.ReadAllText(Absolute(path));

        public static bool IsFolder(string path) => Directory.Exists(Absolute(path));

        /// <summary>Text files below the folders that belong to the project, hidden ones and build output left out.</summary>
        public static IEnumerable<string> TextFiles()
        {
            IEnumerable<string> roots = new[] { Package, "Assets", "ProjectSettings", "Tests" }.Where(IsFolder);
            return roots.SelectMany(root => Below(root, folder => folder[0] != '.' && folder != "bin" && folder != "obj"))
                .Where(path => TextExtensions.Contains(Path.GetExtension(path)));
        }

        /// <summary>Files with one of these extensions in Unity's YAML.</summary>
        public static IEnumerable<string> YamlFiles() =>
            TextFiles().Where(path => path.EndsWith(".unity", StringComparison.Ordinal) || path.EndsWith(".asset", StringComparison.Ordinal)
                || path.EndsWith(".mat", StringComparison.Ordinal) || path.EndsWith(".prefab", StringComparison.Ordinal));

        private static IEnumerable<string> Imported() => new[] { Package, Samples, "Assets" }.SelectMany(Imported);

        private static IEnumerable<string> Imported(string root) =>
            IsFolder(root) ? Below(root, name => name[0] != '.' && name[name.Length - 1] != '~', withFolders: true) : Enumerable.Empty<string>();

        private static IEnumerable<string> Below(string folder, Func<string, bool> enters, bool withFolders = false)
        {
            foreach (string entry in Directory.GetFileSystemEntries(Absolute(folder)).OrderBy(entry => entry, StringComparer.Ordinal))
            {
                string name = Path.GetFileName(entry), path = folder + "/" + name;
                if (!Directory.Exists(entry))
                {
                    if (name[0] != '.')
                        yield return path;
                    continue;
                }

                if (!enters(name))
                    continue;
                if (withFolders)
                    yield return path;
                foreach (string below in Below(path, enters, withFolders))
                    yield return below;
            }
        }
    }
}
