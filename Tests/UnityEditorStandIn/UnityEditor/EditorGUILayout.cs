// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using UnityEditorStandIn;
using UnityEngine;

namespace UnityEditor
{
    public sealed class EditorGUILayout
    {
        public static void HelpBox(string message, MessageType type) => EditorLog.Drawn.Add(type + ": " + message);

        public static void LabelField(string label, string label2, params GUILayoutOption[] options) => EditorLog.Drawn.Add(label + ": " + label2);
    }
}
