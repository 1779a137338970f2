// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using UnityEditorStandIn;
using UnityEngine;

namespace UnityEditor
{
    public class Undo
    {
        public static void RegisterCreatedObjectUndo(Object objectToUndo, string name) => EditorLog.Undoable.Add(objectToUndo);
    }
}
