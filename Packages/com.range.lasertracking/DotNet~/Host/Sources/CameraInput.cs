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
            return new PrefetchingFrameSource(Simulate(name).CreateColorSource());
        }

        /// <summary>A scenario in the shipped scene.</summary>
        /// <exception cref="InputException">It cannot be read, or asks for what the scene does not have.</exception>
        public static SimulatedRange Simulate(string name) =>
            new(SimulationScenarioFile.Read(name), UnitySceneReader.Read(Path.Combine(RepositoryFolder.Find(), "Assets", "Scenes", "Range.unity")));
    }
}
