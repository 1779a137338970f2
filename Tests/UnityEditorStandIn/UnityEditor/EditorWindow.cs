// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using UnityEditorStandIn;
using UnityEngine;

namespace UnityEditor
{
    public class EditorWindow : ScriptableObject
    {
        public static T GetWindow<T>(string title)
            where T : EditorWindow => EditorLog.Show<T>(title);
    }
}
