using System.Collections.Generic;
using System.Linq;
using LaserTracking.Unity;
using UnityEditor;
using UnityEditor.Build.Reporting;
using UnityEngine;

namespace LaserTracking.Editor
{
    /// <summary>Builds the trainer's player from the scenes of the build settings. Its scene, calibration and sources are then chosen on the command line.</summary>
    public static class TrainerBuild
    {
        [MenuItem("Window/Laser Tracking/Build Trainer's Player")]
        public static void Build()
        {
            string folder = EditorUtility.SaveFolderPanel("Where the trainer's player goes", "", "Laser Range");
            if (folder.Length == 0)
                return;
            if (!TryMakeOptions(EditorBuildSettings.scenes, folder, Application.platform, out BuildPlayerOptions options, out string problem))
            {
                Debug.LogError("The trainer's player was not built: " + problem);
                return;
            }

            BuildSummary summary = BuildPipeline.BuildPlayer(options).summary;
            if (summary.result == BuildResult.Succeeded)
                Debug.Log("The trainer's player is in " + folder + ". Start it with " + PlayerArguments.Usage);
            else
                Debug.LogError("The trainer's player was not built: " + summary.totalErrors + " errors, the Console has them");
        }

        /// <summary>For the operating system that the editor runs on.</summary>
        internal static bool TryMakeOptions(IEnumerable<EditorBuildSettingsScene> scenes, string folder, RuntimePlatform editor, out BuildPlayerOptions options, out string problem)
        {
            string[] paths = scenes.Where(scene => scene.enabled).Select(scene => scene.path).ToArray();
            problem = paths.Length > 0 ? "" : "the build settings have no scene; add the open one in File > Build Settings";
            bool isMac = editor == RuntimePlatform.OSXEditor, isLinux = editor == RuntimePlatform.LinuxEditor;
            options = new BuildPlayerOptions
            {
                scenes = paths,
                locationPathName = folder + "/Laser Range" + (isMac ? ".app" : isLinux ? ".x86_64" : ".exe"),
                target = isMac ? BuildTarget.StandaloneOSX : isLinux ? BuildTarget.StandaloneLinux64 : BuildTarget.StandaloneWindows64,
                targetGroup = BuildTargetGroup.Standalone,
                options = BuildOptions.None,
            };
            return problem.Length == 0;
        }
    }
}
