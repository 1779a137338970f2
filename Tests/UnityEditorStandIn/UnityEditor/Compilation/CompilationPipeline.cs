// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using System;

namespace UnityEditor.Compilation
{
    public static class CompilationPipeline
    {
        public static event Action<object> compilationFinished;

        internal static void Finish() => compilationFinished?.Invoke(null);

        internal static void Forget() => compilationFinished = null;
    }
}
