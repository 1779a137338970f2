// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using UnityEngine;

namespace UnityEditor
{
    public class Editor : ScriptableObject
    {
        public Object target { get; set; }

        public bool DrawDefaultInspector() => false;

        public virtual void OnInspectorGUI()
        {
        }
    }
}
