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
            if (!IsScenario(name))
                return new PrefetchingFrameSource(FrameSources.OpenScreenCamera(name));
            return new PrefetchingFrameSource(Simulate(name).CreateColorSource());
        }

        /// <summary>Camera 1, likewise.</summary>
        /// <exception cref="InputException">It cannot be used at all, or has no second camera.</exception>
        public static IFrameSource OpenHands(string name)
        {
            if (!IsScenario(name))
                return new PrefetchingFrameSource(FrameSources.OpenHandCamera(name, true));
            SimulatedRange range = Simulate(name);
            if (!range.Scenario.DepthCamera.Enabled)
                throw new InputException(name, "this scenario has no depth camera", "set enabled of its depth_camera");
            return new PrefetchingFrameSource(range.CreateDepthSource());
        }

        /// <summary>A scenario rather than something recorded.</summary>
        public static bool IsScenario(string name) => name.EndsWith(".json", StringComparison.OrdinalIgnoreCase);

        /// <summary>The scenario in the shipped scene.</summary>
        /// <exception cref="InputException">The scenario or the scene cannot be read.</exception>
        public static SimulatedRange Simulate(string name)
        {
            SimulationScenario scenario = SimulationScenarioFile.Read(name);
            return new SimulatedRange(scenario, UnitySceneReader.Read(Path.Combine(RepositoryFolder.Find(), "Assets", "Scenes", "Range.unity")));
        }
    }
}
