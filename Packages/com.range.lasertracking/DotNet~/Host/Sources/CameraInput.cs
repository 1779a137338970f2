using System;
using System.IO;
using LaserTracking.Capture;
using LaserTracking.Host.Scenes;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Sources
{
    /// <summary>Camera 0 from whatever a user names: recorded, or simulated from a scenario.</summary>
    internal static class CameraInput
    {
        /// <summary>A recording, video, picture or folder of pictures; a scenario (.json) plays in the shipped scene, as in the demo.</summary>
        /// <exception cref="InputException">It cannot be used at all.</exception>
        public static IFrameSource Open(string name)
        {
            if (!name.EndsWith(".json", StringComparison.OrdinalIgnoreCase))
                return new PrefetchingFrameSource(FrameSources.OpenScreenCamera(name));
            SimulationScenario scenario = SimulationScenarioFile.Read(name);
            var range = new SimulatedRange(scenario, UnitySceneReader.Read(Path.Combine(RepositoryFolder.Find(), "Assets", "Scenes", "Range.unity")));
            return new PrefetchingFrameSource(range.CreateColorSource());
        }
    }
}
