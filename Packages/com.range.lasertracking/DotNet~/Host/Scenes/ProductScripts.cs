using System.Collections.Generic;

namespace LaserTracking.Host.Scenes
{
    /// <summary>
    /// The package's components that decide what a shot meets, with their serialised fields. Their guids are known here because they
    /// are the package's public face (derived from the path at birth, never changed) and because a project may hold the package
    /// somewhere outside its folder.
    /// </summary>
    internal static class ProductScripts
    {
        public const string TargetDefinitionAsset = nameof(TargetDefinitionAsset);
        public const string LaserTarget = nameof(LaserTarget);
        public const string TargetMotion = nameof(TargetMotion);
        public const string ScreenSurface = nameof(ScreenSurface);
        public const string LaserRange = nameof(LaserRange);

        /// <summary>Folder of the package's scripts that need not be read: they show or feed, and move nothing that can be hit.</summary>
        public const string PackageFolder = "Packages/com.range.lasertracking/";

        /// <summary>Guid of the scripts that Unity brings itself, documents of its UI: they show and move nothing that can be hit.</summary>
        public const string UnitysOwn = "0000000000000000e000000000000000";

        /// <summary>Class by the guid of its script.</summary>
        public static readonly IReadOnlyDictionary<string, string> ClassByGuid = new Dictionary<string, string>
        {
            ["c05170ce6f0de0e4fcd39d93f0e24e3e"] = TargetDefinitionAsset,
            ["c3e9f9eb2bfb6c8c8c75d334ce0696af"] = LaserTarget,
            ["ce71f8e935d783cc490767973868b6e6"] = TargetMotion,
            ["626b6a64b9c32c7604acc4dfcae72615"] = ScreenSurface,
            ["b33198d265cad9bf2143c3cead4383f8"] = LaserRange,
        };

        /// <summary>Components that show or bring shots and decide nothing about what they meet, by the guids of their scripts.</summary>
        public static readonly IReadOnlyDictionary<string, string> ShowingByGuid = new Dictionary<string, string>
        {
            ["842ac62e1e1b4650b63394a694ed9b0a"] = "ShotVisuals",
            ["37ae146a84c2caefe0daa04317b60df8"] = "Scoreboard",
            ["8c7810aa1b663a441f2aa3614be26986"] = "CalibrationScreen",
            ["9860e2bcc19e5ce04f69d1ece3a5cc62"] = "PlayerSetup",
            ["4e594f06acf668db5e74aefd635dc51f"] = "RemoteInput",
            ["92034f8b2d58c3dbd64ac11007c926a2"] = "RenderedPictures",
        };

        /// <summary>Serialised fields by class; all of them are written by Unity, so a missing one is as wrong as an unknown one.</summary>
        public static readonly IReadOnlyDictionary<string, string[]> FieldsByClass = new Dictionary<string, string[]>
        {
            [TargetDefinitionAsset] = new[] { "_kind", "_sizeM", "_zones" },
            [LaserTarget] = new[] { "_definition" },
            [TargetMotion] = new[] { "_kind", "_travelM", "_periodS", "_phaseS" },
            [ScreenSurface] = new[] { "_sizeM", "_calibration" },
            [LaserRange] = new[] { "_screen", "_viewpoint", "_hitLayers", "_source" },
        };

        /// <summary>Further fields by class: who fired and who is told of a shot change nothing about what it meets.</summary>
        public static readonly IReadOnlyDictionary<string, string[]> EventsByClass = new Dictionary<string, string[]>
        {
            [LaserTarget] = new[] { "_hit" },
            [LaserRange] = new[] { "_handSource", "_handModelFile", "_shotFired", "_dotMoved", "_handMoved", "_healthChanged", "_aim" },
            [ScreenSurface] = new[] { "_calibrationFile", "_fillsCamera" },
        };

        /// <summary>Fields that every MonoBehaviour and ScriptableObject has.</summary>
        private static readonly string[] BaseFields =
        {
            "m_ObjectHideFlags", "m_CorrespondingSourceObject", "m_PrefabInstance", "m_PrefabAsset", "m_GameObject", "m_Enabled",
            "m_EditorHideFlags", "m_Script", "m_Name", "m_EditorClassIdentifier",
        };

        public static readonly string[] ZoneFields = { "name", "points", "shape", "centerM", "sizeM", "cornersM" };

        /// <summary>Fields of the class that may be there or not.</summary>
        public static IReadOnlyCollection<string> OptionalFields(string className)
        {
            var fields = new List<string>(BaseFields);
            if (EventsByClass.TryGetValue(className, out string[]? events))
                fields.AddRange(events);
            return fields;
        }
    }
}
