using UnityEditor;
using UnityEngine;

namespace LaserTracking.Editor
{
    /// <summary>GameObject > Laser Tracking > Laser Range: the package's prefab, which plays with the mouse until it is given a camera.</summary>
    public static class RangeMenu
    {
        internal const string Prefab = "Packages/com.range.lasertracking/Prefabs/LaserRange.prefab";

        [MenuItem("GameObject/Laser Tracking/Laser Range", false, 10)]
        public static void AddRange()
        {
            GameObject prefab = AssetDatabase.LoadAssetAtPath<GameObject>(Prefab);
            if (prefab == null)
            {
                Debug.LogError(Prefab + " is missing: install the package anew");
                return;
            }

            var range = (GameObject)PrefabUtility.InstantiatePrefab(prefab);
            Undo.RegisterCreatedObjectUndo(range, "Add Laser Range");
            Selection.activeGameObject = range;
            SetupWindow.Open();
        }
    }
}
