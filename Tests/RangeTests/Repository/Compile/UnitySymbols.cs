using System.Collections.Generic;
using System.Linq;

namespace LaserTracking.Repository
{
    /// <summary>The symbols that Unity defines for its compiler, as far as a package may rely on them.</summary>
    internal static class UnitySymbols
    {
        /// <summary>Lines of editors that the package is for.</summary>
        public static readonly string[] Versions = { "2022_3", "6000_0", "6000_3" };

        // Oldest first; each version has the OR_NEWER of all before it.
        private static readonly string[] AllVersions =
        {
            "5_3", "2017_1", "2018_1", "2019_1", "2020_1", "2021_1", "2021_2", "2021_3", "2022_1", "2022_2", "2022_3", "2023_1", "2023_2", "2023_3", "6000_0", "6000_1", "6000_2", "6000_3",
        };

        private static readonly string[] Always =
        {
            "NETSTANDARD", "NETSTANDARD2_1", "NET_STANDARD", "NET_STANDARD_2_1", "CSHARP_7_3_OR_NEWER", "TRACE", "UNITY_64", "UNITY_STANDALONE", "UNITY_STANDALONE_WIN",
        };

        private static readonly string[] OfTheEditor = { "UNITY_EDITOR", "UNITY_EDITOR_64", "UNITY_EDITOR_WIN", "UNITY_INCLUDE_TESTS", "DEBUG", "ENABLE_MONO", "UNITY_ASSERTIONS", "DEVELOPMENT_BUILD", "ENABLE_UNITY_COLLECTIONS_CHECKS" };

        private static readonly string[] OfAPlayer = { "ENABLE_IL2CPP" };

        /// <summary>Symbols that a project's settings switch: both ways must compile.</summary>
        public static readonly string[] OfTheProject = { "ENABLE_LEGACY_INPUT_MANAGER" };

        /// <summary>Everything that is defined by some version, in the editor or a player.</summary>
        public static IEnumerable<string> Known => Versions.SelectMany(version => For(version, true).Concat(For(version, false))).Distinct();

        public static IEnumerable<string> For(string version, bool isEditor)
        {
            int last = System.Array.IndexOf(AllVersions, version);
            IEnumerable<string> newer = AllVersions.Take(last + 1).Select(older => "UNITY_" + older + "_OR_NEWER");
            return Always.Concat(isEditor ? OfTheEditor : OfAPlayer).Concat(newer).Append("UNITY_" + version).Append("UNITY_" + version.Split('_')[0]);
        }
    }
}
