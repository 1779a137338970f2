// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
namespace UnityEditor.Build.Reporting
{
    public enum BuildResult
    {
        Succeeded = 1,
        Failed = 2,
    }
}
