// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using UnityEngine;

namespace UnityEditor
{
    /// <summary>A prefab has one instance here: itself.</summary>
    public sealed class PrefabUtility
    {
        public static Object InstantiatePrefab(Object assetComponentOrGameObject) => assetComponentOrGameObject;
    }
}
