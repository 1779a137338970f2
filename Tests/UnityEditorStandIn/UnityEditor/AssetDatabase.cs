// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using System;
using System.IO;
using System.Linq;
using UnityEditorStandIn;

namespace UnityEditor
{
    public sealed class AssetDatabase
    {
        public static T LoadAssetAtPath<T>(string assetPath)
            where T : UnityEngine.Object => EditorLog.Assets.TryGetValue(assetPath, out UnityEngine.Object asset) ? (T)asset : null;

        /// <summary>By a part of their names, as Unity does; the path itself stands for the identifier.</summary>
        public static string[] FindAssets(string filter) =>
            EditorLog.Files.Where(path => Path.GetFileNameWithoutExtension(path).IndexOf(filter, StringComparison.OrdinalIgnoreCase) >= 0).ToArray();

        public static string GUIDToAssetPath(string guid) => guid;
    }
}
