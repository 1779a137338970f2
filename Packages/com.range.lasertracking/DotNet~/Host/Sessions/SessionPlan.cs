using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Hands.Model;
using LaserTracking.Scoring;
using LaserTracking.Session;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Sessions
{
    /// <summary>What a session runs on, whoever asked for it: replay, demo, a test.</summary>
    internal sealed record SessionPlan
    {
        public required IFrameSource ScreenCamera { get; init; }

        public IFrameSource? HandCamera { get; init; }

        /// <summary>The hand landmark model; null: hands by depth alone.</summary>
        public HandLandmarkNetwork? HandModel { get; init; }

        /// <summary>Why the model that was asked for is not used; empty: it is, or none was.</summary>
        public string HandModelProblem { get; init; } = "";

        public RangeCalibration? Calibration { get; init; }

        /// <summary>Path of the calibration, for the header.</summary>
        public string? CalibrationName { get; init; }

        public SceneModel? Scene { get; init; }

        /// <summary>What the projector showed, on the camera's clock.</summary>
        public RenderedVideo? Rendered { get; init; }

        /// <summary>What is wrong with an input as a whole, for the first health line; empty: nothing.</summary>
        public string InputProblem { get; init; } = "";

        /// <summary>From infrared to colour px, for the detector "dual"; null: equal fields of view.</summary>
        public InfraredMapping? InfraredMapping { get; init; }

        /// <summary>Why there is no such mapping although there is infrared; null: nothing to say.</summary>
        public string? InfraredProblem { get; init; }

        /// <summary>"shots", "paper" or "dual".</summary>
        public string Detector { get; init; } = "shots";

        public IReadOnlyList<SessionInput> Inputs { get; init; } = Array.Empty<SessionInput>();

        public long? Seed { get; init; }

        /// <summary>See PipelineSettings.SceneTimeZeroUs.</summary>
        public long? SceneTimeZeroUs { get; init; }

        public long HandClockOffsetUs { get; init; }

        /// <summary>Shutter and rolling shutter of the screen camera.</summary>
        public CameraTimingSettings CameraTiming { get; init; } = new();

        /// <summary>Written into the header; null: this program's. A replayed session keeps its own.</summary>
        public string? Version { get; init; }

        /// <summary>Written as seconds_wall into the last line; null: what this run took. A replayed session keeps its own.</summary>
        public double? SecondsWall { get; init; }

        /// <summary>Told what is written there.</summary>
        public Action<double>? Ended { get; init; }

        /// <summary>Wait so that frames come at their own times.</summary>
        public bool IsPaced { get; init; }
    }
}
