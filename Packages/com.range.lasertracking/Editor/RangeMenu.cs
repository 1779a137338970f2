using LaserTracking.Unity;
using UnityEditor;
using UnityEngine;

namespace LaserTracking.Editor
{
    /// <summary>GameObject > Laser Tracking > Laser Range: a range and its screen, wired to each other, three metres before the main camera.</summary>
    public static class RangeMenu
    {
        private const float ScreenDistanceM = 3;

        [MenuItem("GameObject/Laser Tracking/Laser Range", false, 10)]
        public static void AddRange()
        {
            var screen = new GameObject("Screen");
            ScreenSurface surface = screen.AddComponent<ScreenSurface>();
            Camera camera = Camera.main;
            if (camera != null)
                screen.transform.SetPositionAndRotation(camera.transform.TransformPoint(new Vector3(0, 0, ScreenDistanceM)), camera.transform.rotation);
            var owner = new GameObject("Laser Range");
            LaserRange range = owner.AddComponent<LaserRange>();
            owner.AddComponent<ShotVisuals>();
            using (var serialized = new SerializedObject(range))
            {
                Set(serialized, "_screen", surface);
                if (camera != null)
                    Set(serialized, "_viewpoint", camera.transform);
                serialized.ApplyModifiedPropertiesWithoutUndo();
            }

            Undo.RegisterCreatedObjectUndo(screen, "Add Laser Range");
            Undo.RegisterCreatedObjectUndo(owner, "Add Laser Range");
            Selection.activeGameObject = owner;
            SetupWindow.Open();
        }

        private static void Set(SerializedObject serialized, string field, Object value) => serialized.FindProperty(field).objectReferenceValue = value;
    }
}
