using System;
using System.Collections.Generic;
using System.CommandLine;
using System.Threading;
using System.Threading.Tasks;
using LaserTracking.Capture;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Geometry;
using LaserTracking.Hands.Model;
using LaserTracking.Host.HandModels;
using LaserTracking.Host.Remote;
using LaserTracking.Host.Scenes;
using LaserTracking.Host.Sessions;
using LaserTracking.Host.Sources;
using LaserTracking.Remote;
using LaserTracking.Scoring;
using LaserTracking.Session;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Commands
{
    /// <summary>range replay: runs the pipeline over recorded frames.</summary>
    internal static class ReplayCommand
    {
        public static Command Create()
        {
            var input = new Argument<string>("INPUT") { Description = "An Azure Kinect recording, any video that ffmpeg reads, a folder of numbered images, a recorded session's folder, or a simulation's scenario (.json)." };
            var hand = new Option<string?>("--hand") { HelpName = "FILE", Description = "The second camera's recording: who fired, from where." };
            var handOffset = new Option<long>("--hand-offset-us") { HelpName = "US", Description = "Added to the second camera's times, microseconds." };
            var handModel = new Option<string?>("--hand-model") { HelpName = "NAME", Description = "Sharpens palms and sides with the hand model lite or full, where the second camera's recording has infrared; './range models' fetches it. Left out: depth alone." };
            var calibration = new Option<string?>("--calibration") { HelpName = "FILE", Description = "Where the screen lies in the image (made by 'calibrate screen')." };
            var scene = new Option<string?>("--scene") { HelpName = "FILE.unity", Description = "The Unity scene (.unity) that was shown: shots are scored against it." };
            var rendered = new Option<string?>("--rendered") { HelpName = "VIDEO", Description = "What the projector showed, on any clock: shots are found while it moves." };
            var detector = new Option<string>("--detector") { HelpName = "NAME", Description = "shots; paper: the published algorithm, faithfully; dual: infrared and colour together, for recordings that hold both.", DefaultValueFactory = _ => "shots" };
            var mapping = new Option<string?>("--mapping") { HelpName = "FILE", Description = "For --detector dual: how infrared lies on colour (made by 'calibrate mapping'), in place of the device's factory calibration." };
            var events = new Option<string?>("--events") { HelpName = "FILE", Description = "Writes events.jsonl there; - is standard output." };
            var rejected = new Option<string>("--rejected") { HelpName = "WHICH", Description = "Rejected candidates among the events: all (default); notable: without those that moving edges make, too faint, too small or not compact; none.", DefaultValueFactory = _ => "all" };
            var dots = new Option<string?>("--dots") { HelpName = "FILE", Description = "Writes every tracked dot in every frame there." };
            var report = new Option<string?>("--report") { HelpName = "DIR", Description = "Writes report.html into this folder." };
            var session = new Option<string?>("--session") { HelpName = "DIR", Description = "Records the session into this folder: frames, calibration, scene, settings, events; './range replay DIR' runs it again and gives the same bytes." };
            var paced = new Option<bool>("--paced") { Description = "Runs at the recording's own speed." };
            var send = new Option<string?>("--send") { HelpName = "HOST:PORT", Description = "Sends shots and hands to a remote input as they are found; usually with --paced." };
            var sendFile = new Option<string?>("--send-file") { HelpName = "FILE", Description = "The same through a file that is replaced again and again, for a receiver on this machine." };
            var keyFile = new Option<string?>("--key-file") { HelpName = "FILE", Description = "The key for --send." };
            var exposure = new Option<double>("--exposure-us") { HelpName = "US", Description = "The camera's shutter, microseconds: narrows the uncertainty of time and place, and what is said about the picture." };
            var row = new Option<double>("--row-us") { HelpName = "US", Description = "Rolling shutter: delay from one row to the next, microseconds." };
            var command = new Command("replay", "Runs the pipeline over recorded frames: shots, shooters, scored hits.") { input, hand, handOffset, handModel, calibration, scene, rendered, detector, mapping, events, rejected, dots, report, session, paced, send, sendFile, keyFile, exposure, row };
            command.SetAction((parsed, interrupted) =>
            {
                RangeSession.CreateDetector(parsed.GetValue(detector)!);
                CameraTimingSettings timing = Timing(parsed.GetValue(exposure), parsed.GetValue(row));
                RejectedLines which = SessionOutputs.ParseRejected(parsed.GetValue(rejected)!);
                string name = parsed.GetValue(input)!;
                string? handName = parsed.GetValue(hand), calibrationName = parsed.GetValue(calibration), sceneName = parsed.GetValue(scene), renderedName = parsed.GetValue(rendered);
                string? sessionFolder = parsed.GetValue(session), eventsName = parsed.GetValue(events);
                if (sessionFolder != null && SessionLog.IsIn(sessionFolder))
                    throw new InputException(sessionFolder, "holds a session already, which is not overwritten", "name another folder");
                if (sessionFolder != null)
                    eventsName ??= System.IO.Path.Combine(sessionFolder, SessionLog.EventsFileName);
                string? sendTo = parsed.GetValue(send), key = parsed.GetValue(keyFile);
                string? sendFileName = parsed.GetValue(sendFile);
                if (sendTo != null && sendFileName != null)
                    throw new InputException("--send-file", "--send names another way", "give one of the two");
                ResultFile.CheckNotRead(sendFileName, name, handName, calibrationName, sceneName, renderedName);
                using IRemoteSender? sender = sendTo == null && sendFileName == null ? null : SendTarget.Open("--send", sendTo ?? "", key, sendFileName);
                int Run(SessionPlan plan, KinectRecording? device)
                {
                    var outputs = new SessionOutputs(eventsName, parsed.GetValue(dots), parsed.GetValue(report)) { Rejected = which, Listener = sender == null ? null : new RemoteEventSink(sender) };
                    int RunPlan(SessionPlan final) => outputs.Run(final, "Replay of " + name, interrupted);
                    return sessionFolder == null ? RunPlan(plan) : SessionFolder.Record(sessionFolder, plan, parsed.GetValue(handModel), device, RunPlan);
                }

                bool isSession = SessionLog.IsIn(name), isScenario = CameraInput.IsScenario(name);
                if (isSession || isScenario)
                {
                    Option[] own = isSession ? [hand, handOffset, handModel, calibration, scene, rendered, detector, mapping, session, exposure, row] : [hand, handOffset, calibration, rendered, mapping, exposure, row];
                    foreach (Option option in own)
                    {
                        if (parsed.GetResult(option) is { Implicit: false })
                            throw new InputException(option.Name, isSession ? "a recorded session brings its own" : "a simulation brings its own", "leave it out");
                    }

                    ResultFile.CheckNotRead(eventsName, isSession ? System.IO.Path.Combine(name, SessionLog.EventsFileName) : name);
                    return Task.FromResult(isSession ? ReplaySession(name, parsed.GetValue(paced), plan => Run(plan, null))
                        : Simulate(name, sceneName, parsed.GetValue(detector)!, parsed.GetValue(handModel), parsed.GetValue(paced), plan => Run(plan, null)));
                }

                foreach (string? result in new[] { eventsName, parsed.GetValue(dots) })
                    ResultFile.CheckNotRead(result, name, handName, calibrationName, sceneName, renderedName, parsed.GetValue(mapping));
                RangeCalibration? geometry = calibrationName == null ? null : RangeCalibrationFile.Read(calibrationName);
                SceneModel? model = sceneName == null ? null : UnitySceneReader.Read(sceneName);
                if (model != null && geometry == null)
                    throw new InputException(sceneName!, "a scene needs the screen's place in the image", "add --calibration FILE");
                if (handName != null && geometry?.HandCamera == null)
                    throw new InputException(handName, "the second camera's place is not known", "add --calibration FILE with a hand_camera");
                if (renderedName != null && geometry == null)
                    throw new InputException(renderedName, "the rendered frames need the screen's place in the image", "add --calibration FILE");
                if (renderedName != null && parsed.GetValue(detector) != "shots")
                    throw new InputException(renderedName, "only the detector shots uses rendered frames", "leave out --rendered or --detector");
                if (parsed.GetValue(handModel) != null && handName == null)
                    throw new InputException("--hand-model", "there is no second camera to look at hands with", "add --hand FILE");
                using HandLandmarkNetwork? hands = HandModelStore.TryOpen(parsed.GetValue(handModel), out string handModelProblem);
                if (renderedName != null && sessionFolder != null)
                    throw new InputException("--session", "rendered frames are not recorded", "leave out --session or --rendered");
                string? mappingName = parsed.GetValue(mapping);
                if (mappingName != null && parsed.GetValue(detector) != "dual")
                    throw new InputException(mappingName, "only the detector dual lays infrared on colour", "add --detector dual, or leave out --mapping");
                if (mappingName != null && sessionFolder != null)
                    throw new InputException("--session", "a mapping of one's own is not recorded", "leave out --session or --mapping");
                InfraredMapping? ownMapping = mappingName == null ? null : InfraredMappings.Read(mappingName);
                string problem = "";
                using RenderedVideo? video = renderedName == null ? null : RenderedVideo.Open(renderedName, name, geometry!, interrupted, out problem);
                IFrameSource screenFrames = FrameSources.OpenScreenCamera(name);
                string? infraredProblem = null;
                if (ownMapping != null)
                    InfraredMappings.CheckSizes(ownMapping, mappingName!, screenFrames);
                InfraredMapping? infraredMapping = ownMapping ?? InfraredMappings.Find(screenFrames, geometry, out infraredProblem);
                using IFrameSource screenCamera = new PrefetchingFrameSource(screenFrames);
                using IFrameSource? handCamera = handName == null ? null : new PrefetchingFrameSource(FrameSources.OpenHandCamera(handName, hands != null));
                if (geometry is { IsUnverified: true })
                    Console.Error.WriteLine($"range: {calibrationName}: this calibration is unverified, its millimetres are a claim: fire check shots and run 'range calibrate verify'");
                var inputs = new List<SessionInput> { InputHash.Of(name) };
                if (handName != null)
                    inputs.Add(InputHash.Of(handName));
                if (renderedName != null)
                    inputs.Add(InputHash.Of(renderedName));
                var plan = new SessionPlan
                {
                    ScreenCamera = screenCamera,
                    HandCamera = handCamera,
                    HandModel = hands,
                    HandModelProblem = handModelProblem,
                    HandClockOffsetUs = parsed.GetValue(handOffset),
                    Calibration = geometry,
                    CalibrationName = calibrationName,
                    Scene = model,
                    Rendered = video,
                    InputProblem = problem,
                    Detector = parsed.GetValue(detector)!,
                    InfraredMapping = infraredMapping,
                    InfraredProblem = infraredProblem,
                    Inputs = inputs,
                    CameraTiming = timing,
                    IsPaced = parsed.GetValue(paced),
                };
                return Task.FromResult(Run(plan, (screenFrames as KinectRecordingSource)?.Recording));
            });
            return command;
        }

        private static int ReplaySession(string folder, bool isPaced, Func<SessionPlan, int> run)
        {
            SessionPlan plan = SessionFolder.Open(folder, out string[] doubts) with { IsPaced = isPaced };
            using IFrameSource screen = plan.ScreenCamera;
            using IFrameSource? hands = plan.HandCamera;
            using HandLandmarkNetwork? model = plan.HandModel;
            foreach (string doubt in doubts)
                Console.Error.WriteLine($"range: {folder}: {doubt}: its events may come out otherwise than recorded");
            return run(plan);
        }

        private static int Simulate(string name, string? sceneName, string detector, string? handModel, bool isPaced, Func<SessionPlan, int> run)
        {
            if (detector == "dual")
                throw new InputException("--detector", "a simulation has no device calibration, which dual needs", "give shots or paper");
            SessionPlan plan = SimulatedSession.Create(name, name, sceneName == null ? null : UnitySceneReader.Read(sceneName), null, out _);
            using IFrameSource screen = plan.ScreenCamera;
            using IFrameSource? hands = plan.HandCamera;
            using HandLandmarkNetwork? model = HandModelStore.TryOpen(handModel, out string problem);
            return run(plan with { Detector = detector, HandModel = model, HandModelProblem = problem, IsPaced = isPaced });
        }

        private static CameraTimingSettings Timing(double exposureUs, double rowUs)
        {
            var timing = new CameraTimingSettings { ExposureUs = exposureUs, RowUs = rowUs };
            try
            {
                timing.Validate();
            }
            catch (ArgumentException problem)
            {
                throw new InputException("--exposure-us, --row-us", problem.Message, "give the camera's values in microseconds, or leave them out");
            }

            return timing;
        }
    }
}
