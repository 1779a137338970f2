// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
namespace UnityEditor
{
    public class EditorBuildSettingsScene
    {
        public EditorBuildSettingsScene(string path, bool enabled)
        {
            this.path = path;
            this.enabled = enabled;
        }

        public bool enabled { get; set; }

        public string path { get; set; }
    }
}
