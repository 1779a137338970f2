using System.Collections.Generic;
using UnityEditor;
using UnityEngine;
using UnityEngine.SceneManagement;

namespace LaserTracking.Editor
{
    /// <summary>What of a range is active in the open scene, what is missing, and the one thing to do next.</summary>
    public sealed class SetupWindow : EditorWindow
    {
        private IReadOnlyList<SetupLine> _lines = new SetupLine[0];

        [MenuItem("Window/Laser Tracking/Set-up")]
        public static void Open() => GetWindow<SetupWindow>("Laser range");

        private void OnEnable() => Look();

        private void OnFocus() => Look();

        private void OnGUI()
        {
            string next = SetupCheck.NextStep(_lines);
            EditorGUILayout.HelpBox(next.Length > 0 ? "Next: " + next : "Ready: press Play.", next.Length > 0 ? MessageType.Warning : MessageType.Info);
            foreach (SetupLine line in _lines)
                EditorGUILayout.LabelField(MarkOf(line.State) + " " + line.Name, line.Text);
            if (GUILayout.Button("Look again"))
                Look();
        }

        private void Look() => _lines = SetupCheck.Check(SetupFacts.Of(SceneManager.GetActiveScene()));

        private static string MarkOf(SetupState state)
        {
            switch (state)
            {
                case SetupState.Active: return "[x]";
                case SetupState.Asleep: return "[ ]";
                case SetupState.Advised: return "[?]";
                default: return "[!]";
            }
        }
    }
}
