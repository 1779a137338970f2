using System;
using System.Collections.Generic;
using System.IO;
using System.Threading;
using LaserTracking.Session;

namespace LaserTracking.Host.Sessions
{
    /// <summary>Where a session's results go: files that appear only when they are whole, and a table on standard output.</summary>
    internal sealed class SessionOutputs
    {
        private readonly string? _events;
        private readonly string? _dots;
        private readonly string? _reportFolder;

        /// <param name="events">File for events.jsonl, "-" for standard output, or null.</param>
        /// <param name="dots">File for every tracked dot, or null.</param>
        /// <param name="reportFolder">Folder for report.html, or null.</param>
        public SessionOutputs(string? events, string? dots, string? reportFolder)
        {
            _events = events;
            _dots = dots;
            _reportFolder = reportFolder;
        }

        /// <summary>What the projector showed as the scene's clock began, for the report, PNG; null: plain.</summary>
        public byte[]? BackgroundPng { get; set; }

        /// <summary>Which rejected candidates events.jsonl gets.</summary>
        public RejectedLines Rejected { get; init; }

        /// <summary>Gets shots and hands too, as they are found; null: nobody.</summary>
        public IEventSink? Listener { get; init; }

        /// <summary>What the last run found.</summary>
        public SessionRecorder Recorder { get; private set; } = new();

        /// <exception cref="InputException">The word is none of the three.</exception>
        public static RejectedLines ParseRejected(string word) => word switch
        {
            "all" => RejectedLines.All,
            "notable" => RejectedLines.Notable,
            "none" => RejectedLines.None,
            _ => throw new InputException("--rejected", $"\"{word}\" is not known", "give all, notable or none"),
        };

        /// <summary>Runs the plan and writes everything that was asked for; returns the exit code.</summary>
        public int Run(SessionPlan plan, string title, CancellationToken interrupted)
        {
            using ResultFile? events = _events == null ? null : new ResultFile(_events);
            using ResultFile? dots = _dots == null ? null : new ResultFile(_dots);
            using ResultFile? report = _reportFolder == null ? null : new ResultFile(Path.Combine(_reportFolder, "report.html"));
            Recorder = new SessionRecorder();
            var sinks = new List<IEventSink> { Recorder };
            if (events != null)
                sinks.Add(new JsonLinesSink(events.Stream, Rejected == RejectedLines.None ? EventTypes.Default & ~EventTypes.Rejected : EventTypes.Default) { SkipsOrdinaryRejected = Rejected == RejectedLines.Notable });
            if (dots != null)
                sinks.Add(new JsonLinesSink(dots.Stream, EventTypes.Dots));

            if (Listener != null)
                sinks.Add(Listener);
            bool isComplete = RangeSession.Run(plan, new EventSinkGroup(sinks), interrupted, Recorder);
            report?.Stream.Write(Report(plan, title));
            events?.Commit();
            dots?.Commit();
            report?.Commit();
            if (_events != "-")
                ShotTable.Print(Recorder, plan);
            return isComplete ? ExitCodes.Done : ExitCodes.Interrupted;
        }

        private byte[] Report(SessionPlan plan, string title)
        {
            var options = new ReportOptions
            {
                Title = title,
                Scene = plan.Scene,
                SceneZeroTimeUs = plan.SceneTimeZeroUs,
                ScreenSizeM = plan.Calibration?.Screen.ScreenSizeM,
                ImageSizePx = new Geometry.Vector2D(plan.ScreenCamera.Info.Width, plan.ScreenCamera.Info.Height),
                BackgroundPng = BackgroundPng,
                PictureTimeS = BackgroundPng == null ? null : 0,
            };
            return ReportBuilder.BuildUtf8(Recorder, options);
        }
    }
}
