using System.Collections.Generic;
using System.Text.Json.Nodes;
using LaserTracking.Capture;

namespace LaserTracking.Host.Sources
{
    /// <summary>What `info` says about a video or a folder of pictures: the JSON object of the contract.</summary>
    public static class VideoInfo
    {
        /// <exception cref="InputException">The file is no video.</exception>
        public static JsonObject OfVideo(string path)
        {
            VideoProbe probe = VideoProbe.Open(path);
            long frames = probe.CountFrames(out string problem);
            var problems = new List<FrameProblem>();
            if (problem.Length > 0)
                problems.Add(new FrameProblem(-1, problem));
            bool isShort = probe.ContainerFormat == "avi" && probe.DeclaredFrames > frames;
            if (isShort)
                problems.Add(new FrameProblem(-1, $"the video breaks off after {frames} of {probe.DeclaredFrames} frames"));
            bool isTruncated = isShort || VideoProbe.MeansCut(problem);
            return Describe("video", probe.Codec.ToUpperInvariant(), probe.Width, probe.Height, probe.FramesPerSecond, frames, probe.DurationUs,
                probe.StartUs, isTruncated, problems);
        }

        /// <summary>Damaged pictures only show when they are decoded; here are problems of names, numbers and times.</summary>
        /// <exception cref="InputException">No picture in the folder can be read.</exception>
        public static JsonObject OfImageFolder(string path, double framesPerSecond = 30)
        {
            using var source = new ImageFolderSource(path, framesPerSecond);
            return Describe("images", source.Format, source.Info.Width, source.Info.Height, source.Info.NominalFramesPerSecond, source.Count,
                source.Info.DurationUs, source.StartUs, false, source.Problems);
        }

        private static JsonObject Describe(string container, string format, int width, int height, double framesPerSecond, long frames,
            long? durationUs, long startUs, bool isTruncated, IReadOnlyList<FrameProblem> problems)
        {
            var list = new JsonArray();
            foreach (FrameProblem problem in problems)
                list.Add(new JsonObject { ["offset"] = problem.Offset, ["what"] = problem.What });
            return new JsonObject
            {
                ["container"] = container,
                ["duration_us"] = durationUs,
                ["truncated"] = isTruncated,
                ["tracks"] = new JsonArray(new JsonObject
                {
                    ["name"] = "COLOR",
                    ["format"] = format,
                    ["width"] = width,
                    ["height"] = height,
                    ["fps"] = framesPerSecond,
                    ["frames"] = frames,
                }),
                ["captures"] = frames,
                ["imu_samples"] = 0,
                ["device"] = null,
                ["depth_mode"] = null,
                ["start_offset_us"] = startUs,
                ["sync"] = null,
                ["calibration"] = null,
                ["problems"] = list,
            };
        }
    }
}
