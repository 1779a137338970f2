using System;
using System.IO;
using System.Linq;
using LaserTracking.Capture;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Capture.Recording;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands.Model;
using LaserTracking.Host.HandModels;
using LaserTracking.Host.Sources;
using LaserTracking.Scoring;
using LaserTracking.Session;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Sessions
{
    /// <summary>A session in a folder: recorded while it runs, and run again from there.</summary>
    internal static class SessionFolder
    {
        /// <summary>
        /// Runs a plan and records all it takes to run it again. Calibration and scene are used as they were written, so that a replay
        /// cannot differ by a rounding.
        /// </summary>
        /// <param name="folder">Made; must not hold a session.</param>
        /// <param name="plan">With sources that can wait for the disk.</param>
        /// <param name="handModel">Name of the plan's hand model, or null.</param>
        /// <param name="device">The screen camera's recording, for the device's own calibration; null: it has none.</param>
        /// <param name="run">Runs the plan that it is given; returns the exit code.</param>
        /// <exception cref="InputException">The folder cannot be written to, or the disk is full.</exception>
        public static int Record(string folder, SessionPlan plan, string? handModel, KinectRecording? device, Func<SessionPlan, int> run)
        {
            string? calibration = plan.Calibration == null ? null : RangeCalibrationFile.Format(plan.Calibration);
            var log = new SessionLog
            {
                Header = new SessionHeader(plan.Version ?? RangeSession.Version, plan.Inputs, plan.CalibrationName, plan.Detector, plan.Seed),
                Build = SessionLog.ThisBuild,
                HandModel = handModel,
                HandClockOffsetUs = plan.HandClockOffsetUs,
                SceneTimeZeroUs = plan.SceneTimeZeroUs,
                ExposureUs = plan.CameraTiming.ExposureUs,
                RowUs = plan.CameraTiming.RowUs,
            };
            FrameRecorderSettings screen = SettingsFor(plan.ScreenCamera);
            if (device != null && device.TryReadCalibration(out byte[] json))
                screen.DeviceCalibration = () => json;
            using var writer = new SessionLogWriter(folder, log, screen, plan.HandCamera == null ? null : SettingsFor(plan.HandCamera), calibration, plan.Scene);
            var screenTap = new TappedFrameSource(plan.ScreenCamera) { Tap = writer.AddScreenFrame };
            TappedFrameSource? handTap = plan.HandCamera == null ? null : new TappedFrameSource(plan.HandCamera) { Tap = writer.AddHandFrame };
            int exitCode = run(plan with
            {
                Ended = seconds => log.SecondsWall = seconds,
                ScreenCamera = screenTap,
                HandCamera = handTap,
                Calibration = calibration == null ? null : RangeCalibrationFile.Parse(calibration, "calibration"),
                Scene = plan.Scene == null ? null : ScenePoseLog.Read(Path.Combine(folder, SessionLog.SceneFileName)),
            });
            writer.Finish(exitCode == ExitCodes.Done, screenTap.Problems.Count + (handTap?.Problems.Count ?? 0));
            return writer.Problem.Length == 0 ? exitCode : throw new InputException(folder, "the session is not recorded to its end", writer.Problem.Split("; ")[^1]);
        }

        /// <summary>The plan of a recorded session; its sources are the caller's to dispose.</summary>
        /// <param name="folder">Holds a session.</param>
        /// <param name="doubts">Why the events may be others than were recorded, one sentence each.</param>
        /// <exception cref="InputException">Something of it is missing or cannot be used.</exception>
        public static SessionPlan Open(string folder, out string[] doubts)
        {
            SessionLog log = SessionLogFile.Read(folder);
            doubts = log.Doubts(SessionLog.ThisBuild).ToArray();
            string PathOf(string name) => Path.Combine(folder, name);
            RangeCalibration? calibration = log.HasCalibration ? RangeCalibrationFile.Read(PathOf(SessionLog.CalibrationFileName)) : null;
            if (log.HasHandFrames && calibration?.HandCamera == null)
                throw new InputException(folder, "the second camera's place is not known", "take the session's folder as it was recorded");
            SceneModel? scene = log.HasScene ? ScenePoseLog.Read(PathOf(SessionLog.SceneFileName)) : null;
            RangeSession.CreateDetector(log.Header.Detector);
            HandLandmarkNetwork? hands = HandModelStore.TryOpen(log.HandModel, out string handProblem);
            IFrameSource screen = FrameSources.OpenScreenCamera(PathOf(SessionLog.ScreenFramesName));
            InfraredMapping? mapping = InfraredMappings.Find(screen, calibration, out string? infraredProblem);
            return new SessionPlan
            {
                ScreenCamera = new PrefetchingFrameSource(screen),
                HandCamera = log.HasHandFrames ? new PrefetchingFrameSource(FrameSources.OpenHandCamera(PathOf(SessionLog.HandFramesName), hands != null)) : null,
                HandModel = hands,
                HandModelProblem = handProblem,
                HandClockOffsetUs = log.HandClockOffsetUs,
                Calibration = calibration,
                CalibrationName = log.Header.Calibration,
                Scene = scene,
                Detector = log.Header.Detector,
                InfraredMapping = mapping,
                InfraredProblem = infraredProblem,
                Inputs = log.Header.Inputs,
                Seed = log.Header.Seed,
                SceneTimeZeroUs = log.SceneTimeZeroUs,
                CameraTiming = new CameraTimingSettings { ExposureUs = log.ExposureUs, RowUs = log.RowUs },
                Version = log.Header.Version,
                SecondsWall = log.IsComplete ? log.SecondsWall : null,
            };
        }

        private static FrameRecorderSettings SettingsFor(IFrameSource source) =>
            new() { WaitsWhenFull = true, FramesPerSecond = source.Info.NominalFramesPerSecond };
    }
}
