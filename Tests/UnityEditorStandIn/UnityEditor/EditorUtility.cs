// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using UnityEditorStandIn;

namespace UnityEditor
{
    public class EditorUtility
    {
        public static string SaveFolderPanel(string title, string folder, string defaultName) => EditorLog.FolderChosen;
    }
}
