using System;
using System.Collections.Generic;
using System.IO;

namespace LaserTracking.Session
{
    /// <summary>
    /// What a recorded session ran on, besides its frames: a folder that holds all it takes to run it again and get the same events.
    /// Documentation~/recording.md has the files.
    /// </summary>
    public sealed class SessionLog
    {
        public const string FileName = "session.json";
        public const string ScreenFramesName = "camera0.mkv";
        public const string HandFramesName = "camera1.mkv";
        public const string CalibrationFileName = "calibration.json";
        public const string SceneFileName = "scene.jsonl";
        public const string EventsFileName = "events.jsonl";

        /// <summary>This program's own build: equal sources, compiled by the same compiler, have the same; "unknown" where the runtime does not tell.</summary>
        public static string ThisBuild { get; } = FindBuild();

        /// <summary>The session's own header: a replay writes it again.</summary>
        public SessionHeader Header { get; set; } = new SessionHeader("", new SessionInput[0], null, "shots", null);

        /// <summary>Identifies the program to the byte; another one may find other events.</summary>
        public string Build { get; set; } = "";

        public bool HasHandFrames { get; set; }

        public bool HasCalibration { get; set; }

        public bool HasScene { get; set; }

        /// <summary>"lite" or "full"; null: hands by depth alone.</summary>
        public string? HandModel { get; set; }

        /// <summary>Brings camera 1's times on camera 0's clock.</summary>
        public long HandClockOffsetUs { get; set; }

        /// <summary>Camera 0's time at scene time zero; null: its first frame's.</summary>
        public long? SceneTimeZeroUs { get; set; }

        /// <summary>Camera 0's shutter, 0: unknown.</summary>
        public double ExposureUs { get; set; }

        /// <summary>Camera 0's delay from row to row.</summary>
        public double RowUs { get; set; }

        /// <summary>What its run took by the host's clock, seconds: a replay writes it again, so that its events are the same to the last byte; null: not known.</summary>
        public double? SecondsWall { get; set; }

        /// <summary>Frames in both recordings; known at the end.</summary>
        public long Frames { get; set; }

        /// <summary>Frames that the recorders had to drop, or could not hold: a replay then finds other events.</summary>
        public long Lost { get; set; }

        /// <summary>The recordings do not hold every bit of what the detector saw: JPEG, or only the screen's part.</summary>
        public bool IsReduced { get; set; }

        /// <summary>Damage that the sources reported and that the recordings do not show again.</summary>
        public int InputProblems { get; set; }

        /// <summary>Recorded from its first frame to its last.</summary>
        public bool IsComplete { get; set; }

        /// <summary>Why a replay may give other bytes, one sentence each; empty: it gives the same.</summary>
        /// <param name="build">Of the program that replays.</param>
        public List<string> Doubts(string build)
        {
            var doubts = new List<string>();
            if (!IsComplete)
                doubts.Add("it was not recorded from its beginning to its end");
            if (Lost > 0)
                doubts.Add(Lost + " frames are not in its recordings");
            if (IsReduced)
                doubts.Add("its recordings do not hold every bit of the pictures");
            if (InputProblems > 0)
                doubts.Add("its own input was damaged in " + InputProblems + " places");
            if (Build != build)
                doubts.Add("it was recorded by another build (" + Build + ", this one is " + build + ")");
            return doubts;
        }

        private static string FindBuild()
        {
            try
            {
                return typeof(SessionLog).Module.ModuleVersionId.ToString("N");
            }
            catch (Exception problem) when (problem is NotSupportedException || problem is NotImplementedException)
            {
                // Compiled ahead of time: there are no modules.
                return "unknown";
            }
        }

        /// <summary>Whether a folder holds a session.</summary>
        public static bool IsIn(string folder) => Directory.Exists(folder) && File.Exists(Path.Combine(folder, FileName));
    }
}
