// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using UnityEngine;

namespace UnityEditor
{
    public sealed class Selection
    {
        public static GameObject activeGameObject { get; set; }
    }
}
