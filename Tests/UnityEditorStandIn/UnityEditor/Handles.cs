// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using UnityEditorStandIn;
using UnityEngine;

namespace UnityEditor
{
    public sealed class Handles
    {
        public static Color color { get; set; }

        public static void DrawAAPolyLine(float width, params Vector3[] points) => EditorLog.Drawn.Add("line of " + points.Length);

        public static void Label(Vector3 position, string text) => EditorLog.Drawn.Add("label " + text);
    }
}
