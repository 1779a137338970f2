// Test code, never shipped: part of a stand-in for Unity's editor, see Tests/UnityEditorStandIn/README.md.
using System.Collections.Generic;
using UnityEditor;
using UnityEngine;

namespace UnityEditorStandIn
{
    /// <summary>What the editor did, and what its user answers, in the hands of tests.</summary>
    public static class EditorLog
    {
        public static string FolderChosen { get; set; } = "";

        /// <summary>By path.</summary>
        public static Dictionary<string, Object> Assets { get; } = new Dictionary<string, Object>();

        public static List<BuildPlayerOptions> Built { get; } = new List<BuildPlayerOptions>();

        public static List<string> Drawn { get; } = new List<string>();

        public static List<Object> Undoable { get; } = new List<Object>();

        public static List<EditorWindow> Windows { get; } = new List<EditorWindow>();

        public static void Reset()
        {
            FolderChosen = "";
            Assets.Clear();
            Built.Clear();
            Drawn.Clear();
            Undoable.Clear();
            Windows.Clear();
            EditorBuildSettings.scenes = new EditorBuildSettingsScene[0];
            Selection.activeGameObject = null;
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
