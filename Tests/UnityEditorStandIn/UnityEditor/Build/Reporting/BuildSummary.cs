// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
namespace UnityEditor.Build.Reporting
{
    public struct BuildSummary
    {
        public BuildResult result { get; internal set; }

        public int totalErrors { get; internal set; }
    }
}
