// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using UnityEditorStandIn;
using UnityEngine;

namespace UnityEditor
{
    public sealed class AssetDatabase
    {
        public static T LoadAssetAtPath<T>(string assetPath)
            where T : Object => EditorLog.Assets.TryGetValue(assetPath, out Object asset) ? (T)asset : null;
    }
}
