using System.Collections.Generic;
using System.IO;
using System.Linq;
using UnityEditor;
using UnityEditor.Compilation;
using UnityEngine;

namespace LaserTracking.Editor
{
    /// <summary>
    /// Says in the Console which library is missing when a symbol is set without it: the compiler only names a type that it does not
    /// know. Needs none of the assemblies that fail then; the editor goes on with the ones that it had.
    /// </summary>
    internal static class LibraryWatch
    {
        [InitializeOnLoadMethod]
        private static void Begin()
        {
            // Not now: while scripts are loaded or compiled, assets cannot be asked for.
            EditorApplication.delayCall += Tell;
            CompilationPipeline.compilationFinished += _ => EditorApplication.delayCall += Tell;
        }

        /// <summary>What is missing in this project now.</summary>
        internal static IEnumerable<string> Problems() =>
            OptionalLibrary.Problems(EditorUserBuildSettings.activeScriptCompilationDefines, OptionalLibrary.All.SelectMany(FilesLike).ToArray());

        private static void Tell()
        {
            foreach (string problem in Problems())
                Debug.LogError(problem);
        }

        private static IEnumerable<string> FilesLike(OptionalLibrary library) =>
            AssetDatabase.FindAssets(Path.GetFileNameWithoutExtension(library.File)).Select(guid => Path.GetFileName(AssetDatabase.GUIDToAssetPath(guid)));
    }
}
