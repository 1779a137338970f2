// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using System.Collections.Generic;
using System.Reflection;
using UnityEditor;
using UnityEditor.Compilation;
using UnityEngine;

namespace UnityEditorStandIn
{
    /// <summary>What the editor did, and what its user answers, in the hands of tests.</summary>
    public static class EditorLog
    {
        public static string FolderChosen { get; set; } = "";

        /// <summary>By path.</summary>
        public static Dictionary<string, Object> Assets { get; } = new Dictionary<string, Object>();

        /// <summary>Paths of all files of the project.</summary>
        public static List<string> Files { get; } = new List<string>();

        /// <summary>Scripting define symbols that are set.</summary>
        public static List<string> Symbols { get; } = new List<string>();

        public static List<BuildPlayerOptions> Built { get; } = new List<BuildPlayerOptions>();

        public static List<string> Drawn { get; } = new List<string>();

        public static List<Object> Undoable { get; } = new List<Object>();

        public static List<EditorWindow> Windows { get; } = new List<EditorWindow>();

        public static void Reset()
        {
            FolderChosen = "";
            Assets.Clear();
            Files.Clear();
            Symbols.Clear();
            EditorApplication.delayCall = null;
            CompilationPipeline.Forget();
            Built.Clear();
            Drawn.Clear();
            Undoable.Clear();
            Windows.Clear();
            EditorBuildSettings.scenes = new EditorBuildSettingsScene[0];
            Selection.activeGameObject = null;
        }

        /// <summary>As when scripts have been loaded: marked methods run at once, delayed calls in the editor's next round.</summary>
        public static void LoadScripts(Assembly scripts)
        {
            foreach (System.Type type in scripts.GetTypes())
            {
                foreach (MethodInfo method in type.GetMethods(BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic))
                {
                    if (method.GetCustomAttribute<InitializeOnLoadMethodAttribute>() != null)
                        method.Invoke(null, null);
                }
            }

            RunDelayed();
        }

        /// <summary>As when a compilation has failed: the scripts that were loaded stay.</summary>
        public static void FailToCompile()
        {
            CompilationPipeline.Finish();
            RunDelayed();
        }

        private static void RunDelayed()
        {
            EditorApplication.CallbackFunction calls = EditorApplication.delayCall;
            EditorApplication.delayCall = null;
            calls?.Invoke();
        }

        internal static T Show<T>(string title)
            where T : EditorWindow
        {
            T window = ScriptableObject.CreateInstance<T>();
            window.name = title;
            Windows.Add(window);
            return window;
        }
    }
}
