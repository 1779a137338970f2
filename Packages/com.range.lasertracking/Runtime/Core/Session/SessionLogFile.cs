using System;
using System.IO;
using System.Linq;
using System.Text;
using LaserTracking.Geometry;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Session
{
    /// <summary>Reads and writes session.json. Unknown fields are passed over.</summary>
    public static class SessionLogFile
    {
        private const string Remedy = "take the session's folder as it was recorded";

        /// <exception cref="InputException">Not there, not JSON, a newer version, or a field of another kind.</exception>
        public static SessionLog Read(string folder)
        {
            string path = Path.Combine(folder, SessionLog.FileName);
            JObject root = CalibrationJson.ReadFile(path);
            CalibrationJson.CheckVersion(root, path);
            try
            {
                if ((string?)root["kind"] != "session")
                    throw new FormatException("field kind is not \"session\"");
                return new SessionLog
                {
                    Header = new SessionHeader(Text(root, "version"), Inputs(root), (string?)root["calibration"], Text(root, "detector"), (long?)root["seed"]),
                    Build = Text(root, "build"),
                    HasHandFrames = (bool?)root["has_hand_frames"] ?? false,
                    HasCalibration = (bool?)root["has_calibration"] ?? false,
                    HasScene = (bool?)root["has_scene"] ?? false,
                    HandModel = (string?)root["hand_model"],
                    HandClockOffsetUs = (long?)root["hand_clock_offset_us"] ?? 0,
                    SceneTimeZeroUs = (long?)root["scene_time_zero_us"],
                    ExposureUs = (double?)root["exposure_us"] ?? 0,
                    RowUs = (double?)root["row_us"] ?? 0,
                    SecondsWall = (double?)root["seconds_wall"],
                    Frames = (long?)root["frames"] ?? 0,
                    Lost = (long?)root["lost"] ?? 0,
                    IsReduced = (bool?)root["reduced"] ?? false,
                    InputProblems = (int?)root["input_problems"] ?? 0,
                    IsComplete = (bool?)root["complete"] ?? false,
                };
            }
            catch (Exception problem) when (problem is ArgumentException || problem is FormatException || problem is InvalidCastException || problem is OverflowException)
            {
                throw new InputException(path, "cannot be used (" + problem.Message.Split('\n')[0].TrimEnd('.', '\r') + ")", Remedy);
            }
        }

        /// <summary>Written beside it and moved to its place: it is whole or it is the one before.</summary>
        /// <exception cref="IOException">It cannot be written.</exception>
        public static void Write(SessionLog log, string folder)
        {
            var root = new JObject
            {
                ["v"] = CalibrationJson.Version,
                ["kind"] = "session",
                ["version"] = log.Header.Version,
                ["build"] = log.Build,
                ["detector"] = log.Header.Detector,
                ["seed"] = log.Header.Seed,
                ["inputs"] = new JArray(log.Header.Inputs.Select(input => new JObject { ["path"] = input.Path, ["sha256"] = input.Sha256 })),
                ["calibration"] = log.Header.Calibration,
                ["has_hand_frames"] = log.HasHandFrames,
                ["has_calibration"] = log.HasCalibration,
                ["has_scene"] = log.HasScene,
                ["hand_model"] = log.HandModel,
                ["hand_clock_offset_us"] = log.HandClockOffsetUs,
                ["scene_time_zero_us"] = log.SceneTimeZeroUs,
                ["exposure_us"] = log.ExposureUs,
                ["row_us"] = log.RowUs,
                ["seconds_wall"] = log.SecondsWall,
                ["frames"] = log.Frames,
                ["lost"] = log.Lost,
                ["reduced"] = log.IsReduced,
                ["input_problems"] = log.InputProblems,
                ["complete"] = log.IsComplete,
            };
            string path = Path.Combine(folder, SessionLog.FileName), temporary = path + ".part";
            byte[] text = new UTF8Encoding(false).GetBytes(root.ToString(Formatting.Indented).Replace("\r\n", "\n") + "\n");
            using (var file = new FileStream(temporary, FileMode.Create, FileAccess.Write))
            {
                file.Write(text, 0, text.Length);
                // On the disk before it takes the old one's place, or a power cut could leave neither.
                file.Flush(true);
            }

            File.Delete(path);
            File.Move(temporary, path);
        }

        private static string Text(JObject root, string field) => (string?)root[field] ?? throw new FormatException("field " + field + " is missing");

        private static SessionInput[] Inputs(JObject root) =>
            (root["inputs"] as JArray ?? throw new FormatException("field inputs is missing")).Select(entry => entry as JObject ?? throw new FormatException("field inputs holds something else than objects"))
                .Select(input => new SessionInput(Text(input, "path"), (string?)input["sha256"])).ToArray();
    }
}
