using LaserTracking.Scoring;
using LaserTracking.Unity;
using UnityEditor;
using UnityEngine;

namespace LaserTracking.Editor
{
    /// <summary>Below a target definition's fields: its zones drawn, the first on top as it counts first, or what is wrong with them.</summary>
    [CustomEditor(typeof(TargetDefinitionAsset))]
    public sealed class TargetDefinitionInspector : UnityEditor.Editor
    {
        private const float HeightPx = 280;

        public override void OnInspectorGUI()
        {
            DrawDefaultInspector();
            try
            {
                Draw(((TargetDefinitionAsset)target).ToDefinition(), GUILayoutUtility.GetRect(HeightPx, HeightPx));
            }
            catch (InputException problem)
            {
                EditorGUILayout.HelpBox(problem.Message, MessageType.Error);
            }
        }

        private static void Draw(TargetDefinition definition, Rect area)
        {
            if (Event.current.type != EventType.Repaint)
                return;
            var outline = new ZoneOutline(definition.SizeM, area);
            for (int i = definition.Zones.Count - 1; i >= 0; i--)
            {
                TargetZone zone = definition.Zones[i];
                Handles.color = zone.Points < 0 ? Color.red : Color.green;
                Handles.DrawAAPolyLine(2, outline.Of(zone));
                Handles.Label(outline.Of(zone)[0], zone.Name + " " + zone.Points);
            }
        }
    }
}
