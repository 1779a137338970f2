// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
namespace UnityEditor
{
    public enum BuildTargetGroup
    {
        Standalone = 1,
    }
}
