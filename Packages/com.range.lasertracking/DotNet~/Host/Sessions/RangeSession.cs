using System;
using System.Diagnostics;
using System.Reflection;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Health;
using LaserTracking.Host.Terminal;
using LaserTracking.Pipeline;
using LaserTracking.Scoring;
using LaserTracking.Session;

namespace LaserTracking.Host.Sessions
{
    /// <summary>Builds the pipeline for a plan and runs it to the end of its sources.</summary>
    internal static class RangeSession
    {
        public static string Version { get; } = typeof(RangeSession).Assembly.GetCustomAttribute<AssemblyInformationalVersionAttribute>()!.InformationalVersion.Split('+')[0];

        /// <summary>The detectors by the names of the command line.</summary>
        /// <param name="name">As on the command line.</param>
        /// <param name="infraredMapping">For "dual"; null: equal fields of view.</param>
        /// <param name="expected">For "shots"; null: the rendered pictures are not known.</param>
        /// <exception cref="InputException">There is no such detector.</exception>
        public static IShotDetector CreateDetector(string name, InfraredMapping? infraredMapping = null, ExpectedView? expected = null) => name switch
        {
            "shots" => new ShotDetector(null, expected),
            "paper" => new PaperShotDetector(),
            "dual" => new DualShotDetector(null, infraredMapping),
            _ => throw new InputException("--detector", $"there is no detector \"{name}\"", "known are shots, paper and dual"),
        };

        /// <summary>True when the end was reached, false when it was interrupted; the sink's session is ended in both cases.</summary>
        /// <param name="plan">On what it runs.</param>
        /// <param name="sink">Receives all events.</param>
        /// <param name="interrupted">Ends it early.</param>
        /// <param name="recorder">Told what each frame showed and cost; null: nobody.</param>
        public static bool Run(SessionPlan plan, IEventSink sink, CancellationToken interrupted, SessionRecorder? recorder = null)
        {
            var pipeline = RangePipeline.CreateDefault(
                CreateDetector(plan.Detector, plan.InfraredMapping, plan.Rendered?.Expected),
                plan.Calibration,
                plan.HandCamera != null,
                plan.Scene == null ? null : new ShotScorer(plan.Scene),
                sink,
                new PipelineSettings
                {
                    SceneTimeZeroUs = plan.SceneTimeZeroUs,
                    CameraTiming = plan.CameraTiming,
                    Monitor = new PictureMonitorSettings { ExposureUs = plan.CameraTiming.ExposureUs },
                    Advisor = new AdvisorSettings { ExposureUs = plan.CameraTiming.ExposureUs },
                },
                plan.HandModel);
            pipeline.Begin(new SessionHeader(plan.Version ?? Version, plan.Inputs, plan.CalibrationName, plan.Detector, plan.Seed));
            ReportOtherSizes(pipeline, plan);
            if (plan.Detector == "dual" && plan.InfraredProblem != null)
                pipeline.ReportInputProblem(new FrameProblem(-1, plan.InfraredProblem));
            if (plan.HandModelProblem.Length > 0)
                pipeline.ReportInputProblem(new FrameProblem(-1, plan.HandModelProblem));
            if (plan.InputProblem.Length > 0)
                pipeline.ReportInputProblem(new FrameProblem(-1, plan.InputProblem));

            var watch = Stopwatch.StartNew();
            using var progress = new ProgressLine();
            using var runner = new SessionRunner(pipeline, plan.ScreenCamera, plan.HandCamera, plan.HandClockOffsetUs);
            var pace = new Pace(plan.IsPaced, interrupted);
            long begun = 0;
            runner.BeforeFrame = frame =>
            {
                pace.WaitFor(frame.TimeUs);
                plan.Rendered?.AdvanceTo(frame.TimeUs);
                progress.Show(ProgressText(frame, plan.ScreenCamera.Info, watch));
                begun = Stopwatch.GetTimestamp();
            };
            if (recorder != null)
                runner.AfterFrame = frame => recorder.AddFrame(frame.TimeUs, pipeline.BlindShare, (Stopwatch.GetTimestamp() - begun) * 1e3 / Stopwatch.Frequency);
            bool isComplete = runner.Run(interrupted);
            if (isComplete && plan.HandCamera != null && !runner.HasHandsInTime)
                pipeline.ReportInputProblem(new FrameProblem(-1, "no frame of the second camera lies in the time of the first: nobody can be named; give the clocks' difference with --hand-offset-us"));
            // In whole milliseconds, as the event has it.
            double seconds = plan.SecondsWall ?? Math.Round(watch.Elapsed.TotalSeconds, 3);
            pipeline.End(seconds);
            plan.Ended?.Invoke(seconds);
            return isComplete;
        }

        /// <summary>A calibration made with pictures of another size maps to wrong places without anything else showing it.</summary>
        private static void ReportOtherSizes(RangePipeline pipeline, SessionPlan plan)
        {
            void Check(string camera, int width, int height, IFrameSource source)
            {
                if (source.Info.Width > 0 && (source.Info.Width != width || source.Info.Height != height))
                    pipeline.ReportInputProblem(new FrameProblem(-1, FormattableString.Invariant($"the calibration is for {camera} pictures of {width}×{height}, these have {source.Info.Width}×{source.Info.Height}: positions are wrong; calibrate with pictures of this size")));
            }

            if (plan.Calibration is { } calibration)
                Check("screen", calibration.ImageWidth, calibration.ImageHeight, plan.ScreenCamera);
            if (plan.HandCamera != null && plan.Calibration?.HandCamera is { } hand)
                Check("hand camera", hand.Intrinsics.Width, hand.Intrinsics.Height, plan.HandCamera);
        }

        private static string ProgressText(Frame frame, FrameSourceInfo info, Stopwatch watch)
        {
            double perSecond = (frame.Index + 1) / Math.Max(1e-3, watch.Elapsed.TotalSeconds);
            string total = info.DurationUs is { } duration && info.NominalFramesPerSecond > 0
                ? FormattableString.Invariant($" of about {duration * 1e-6 * info.NominalFramesPerSecond:F0}")
                : string.Empty;
            return FormattableString.Invariant($"frame {frame.Index + 1}{total}, {perSecond:F0} a second");
        }

        /// <summary>Lets frames through at the speed of their own clock.</summary>
        private sealed class Pace
        {
            private readonly bool _isOn;
            private readonly CancellationToken _interrupted;
            private readonly Stopwatch _watch = new();
            private long _firstTimeUs;

            public Pace(bool isOn, CancellationToken interrupted)
            {
                _isOn = isOn;
                _interrupted = interrupted;
            }

            public void WaitFor(long timeUs)
            {
                if (!_isOn)
                    return;
                if (!_watch.IsRunning)
                {
                    _firstTimeUs = timeUs;
                    _watch.Start();
                }

                long aheadMs = (timeUs - _firstTimeUs) / 1000 - _watch.ElapsedMilliseconds;
                if (aheadMs > 0)
                    _interrupted.WaitHandle.WaitOne((int)Math.Min(aheadMs, 60_000));
            }
        }
    }
}
