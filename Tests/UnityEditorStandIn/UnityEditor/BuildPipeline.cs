// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using UnityEditor.Build.Reporting;
using UnityEditorStandIn;

namespace UnityEditor
{
    public class BuildPipeline
    {
        public static BuildReport BuildPlayer(BuildPlayerOptions buildPlayerOptions)
        {
            EditorLog.Built.Add(buildPlayerOptions);
            return new BuildReport { summary = new BuildSummary { result = BuildResult.Succeeded } };
        }
    }
}
