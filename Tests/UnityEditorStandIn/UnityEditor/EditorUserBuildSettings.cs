// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using UnityEditorStandIn;

namespace UnityEditor
{
    public class EditorUserBuildSettings : UnityEngine.Object
    {
        private EditorUserBuildSettings()
        {
        }

        public static string[] activeScriptCompilationDefines => EditorLog.Symbols.ToArray();
    }
}
