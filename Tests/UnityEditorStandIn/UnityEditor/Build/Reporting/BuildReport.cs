// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using UnityEngine;

namespace UnityEditor.Build.Reporting
{
    public sealed class BuildReport : Object
    {
        internal BuildReport()
        {
        }

        public BuildSummary summary { get; internal set; }
    }
}
