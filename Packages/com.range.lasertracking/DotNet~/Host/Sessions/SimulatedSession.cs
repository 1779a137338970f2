using System.IO;
using LaserTracking.Capture;
using LaserTracking.Host.Scenes;
using LaserTracking.Scoring;
using LaserTracking.Session;
using LaserTracking.Simulation;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Sessions
{
    /// <summary>A scenario played in a scene, as a session to run: both cameras, exact calibration, settings.</summary>
    internal static class SimulatedSession
    {
        /// <summary>The plan's sources are the caller's to dispose.</summary>
        /// <param name="scenarioFile">The scenario.</param>
        /// <param name="inputName">How the header names it.</param>
        /// <param name="scene">Where it is played; null: the shipped scene.</param>
        /// <param name="seed">In place of the scenario's own.</param>
        /// <param name="range">What is simulated.</param>
        /// <exception cref="InputException">The scenario cannot be read or does not fit the scene.</exception>
        public static SessionPlan Create(string scenarioFile, string inputName, SceneModel? scene, int? seed, out SimulatedRange range)
        {
            SimulationScenario scenario = SimulationScenarioFile.Read(scenarioFile);
            if (seed is { } other)
                scenario.Seed = other;
            range = new SimulatedRange(scenario, scene ?? UnitySceneReader.Read(Path.Combine(RepositoryFolder.Find(), "Assets", "Scenes", "Range.unity")));
            bool hasHands = scenario.DepthCamera.Enabled;
            return new SessionPlan
            {
                ScreenCamera = new PrefetchingFrameSource(range.CreateColorSource()),
                HandCamera = hasHands ? new PrefetchingFrameSource(range.CreateDepthSource()) : null,
                HandClockOffsetUs = hasHands ? range.Truth.ColorClockUs(0) - range.Truth.DepthClockUs(0) : 0,
                Calibration = range.Calibration,
                CalibrationName = "simulation",
                CameraTiming = new CameraTimingSettings { ExposureUs = scenario.ColorCamera.ExposureUs, RowUs = scenario.ColorCamera.RollingShutterRowUs },
                Scene = range.Scene,
                SceneTimeZeroUs = range.Truth.ColorClockUs(0),
                Inputs = new[] { new SessionInput(inputName, InputHash.Of(scenarioFile).Sha256) },
                Seed = scenario.Seed,
            };
        }
    }
}
