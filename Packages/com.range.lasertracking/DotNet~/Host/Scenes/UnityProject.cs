using System;
using System.Collections.Generic;
using System.IO;

namespace LaserTracking.Host.Scenes
{
    /// <summary>Finds a project's assets by guid, through the .meta files below its Assets and Packages folders.</summary>
    internal sealed class UnityProject
    {
        private readonly string? _root;
        private Dictionary<string, string>? _paths;

        private UnityProject(string? root) => _root = root;

        /// <summary>The project that a file belongs to: the nearest folder above it that has Assets. May be none.</summary>
        public static UnityProject Around(string file)
        {
            for (DirectoryInfo? folder = new FileInfo(file).Directory; folder != null; folder = folder.Parent)
            {
                if (Directory.Exists(Path.Combine(folder.FullName, "Assets")))
                    return new UnityProject(folder.FullName);
            }

            return new UnityProject(null);
        }

        /// <summary>Path of the asset with the guid, relative to the project with forward slashes, and in full.</summary>
        public bool TryFind(string guid, out string relative, out string path)
        {
            relative = path = "";
            if (_root == null)
                return false;
            _paths ??= Index(_root);
            if (!_paths.TryGetValue(guid, out string? found))
                return false;
            path = found;
            relative = Path.GetRelativePath(_root, found).Replace('\\', '/');
            return true;
        }

        private static Dictionary<string, string> Index(string root)
        {
            var paths = new Dictionary<string, string>(StringComparer.Ordinal);
            var hidden = new EnumerationOptions { RecurseSubdirectories = true, IgnoreInaccessible = true };
            foreach (string top in new[] { "Assets", "Packages", Path.Combine("Library", "PackageCache") })
            {
                string folder = Path.Combine(root, top);
                if (!Directory.Exists(folder))
                    continue;
                foreach (string meta in Directory.EnumerateFiles(folder, "*.meta", hidden))
                {
                    foreach (string line in File.ReadLines(meta))
                    {
                        if (!line.StartsWith("guid:", StringComparison.Ordinal))
                            continue;
                        paths.TryAdd(line[5..].Trim(), meta[..^5]);
                        break;
                    }
                }
            }

            return paths;
        }
    }
}
