// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using UnityEngine;

namespace UnityEditor
{
    public class EditorBuildSettings : Object
    {
        private EditorBuildSettings()
        {
        }

        public static EditorBuildSettingsScene[] scenes { get; set; } = new EditorBuildSettingsScene[0];
    }
}
