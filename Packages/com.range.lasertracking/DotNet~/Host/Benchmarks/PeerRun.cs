using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Runtime.InteropServices;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Host.Terminal;
using LaserTracking.Imaging;
using Newtonsoft.Json;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Benchmarks
{
    /// <summary>Times the published algorithms written with OpenCV on the frames that our benchmarks use (Benchmarks/peer/README.md).</summary>
    internal static class PeerRun
    {
        private const int Frames = 8;

        /// <summary>The peer's times with ratios to ours, or null and one line that says what is missing.</summary>
        /// <exception cref="InputException">The peer failed.</exception>
        public static IReadOnlyList<PeerResult>? TryRun(IReadOnlyList<BenchmarkResult> ours, CancellationToken interrupted, out string missing)
        {
            missing = string.Empty;
            if (FindPython(interrupted) is not { } python)
            {
                missing = "no python3 on the path can import cv2, so there is no peer to compare with; Debian: apt install python3-opencv";
                return null;
            }

            string folder = Directory.CreateTempSubdirectory("range-peer").FullName;
            try
            {
                WriteFrames(folder);
                string script = Path.Combine(RepositoryFolder.Find(), "Packages", "com.range.lasertracking", "DotNet~", "Benchmarks", "peer", "peer.py");
                (int exitCode, string output) = ChildProcess.Run(python, [script, folder], null, interrupted);
                string? json = output.Split('\n').FirstOrDefault(line => line.StartsWith('{'));
                if (exitCode != 0 || json == null)
                    throw new InputException(script, "failed: " + output.Trim().Split('\n')[^1], "run it by hand to see why");
                List<PeerResult> results = JObject.Parse(json)["results"]!.ToObject<List<PeerResult>>()!;
                foreach (PeerResult result in results)
                {
                    foreach (BenchmarkResult own in ours.Where(own => result.Compare.Contains(own.Name)))
                        result.Ratio[own.Name] = Math.Round(result.MedianMs / own.MedianMs, 2);
                }

                return results;
            }
            finally
            {
                Directory.Delete(folder, true);
            }
        }

        private static string? FindPython(CancellationToken interrupted)
        {
            foreach (string folder in (Environment.GetEnvironmentVariable("PATH") ?? string.Empty).Split(Path.PathSeparator, StringSplitOptions.RemoveEmptyEntries))
            {
                string program = Path.Combine(folder, "python3");
                if (File.Exists(program) && ChildProcess.Run(program, ["-c", "import cv2"], null, interrupted).ExitCode == 0)
                    return program;
            }

            return null;
        }

        private static void WriteFrames(string folder)
        {
            var list = new JObject();
            FrameLoop bgra = BenchmarkList.DetectFrames(1920, 1080, PixelFormat.Bgra32, Frames), dual = BenchmarkList.DualFrames(Frames, out _);
            Write(bgra, frame => frame.Color, "bgra", "u1", [Frames, 1080, 1920, 4]);
            Write(BenchmarkList.DetectFrames(1280, 720, PixelFormat.Nv12, Frames), frame => frame.Color, "nv12", "u1", [Frames, 1080, 1280]);
            Write(dual, frame => frame.Color, "dual_bgra", "u1", [Frames, 1080, 1920, 4]);
            Write(dual, frame => frame.Infrared, "dual_infrared", "<u2", [Frames, 1024, 1024]);
            PinholeCamera lens = LensBenchmark.Camera.Pinhole;
            File.WriteAllBytes(Path.Combine(folder, "lens.raw"), MemoryMarshal.AsBytes(LensBenchmark.RandomPixels().AsSpan()).ToArray());
            list["lens"] = new JObject { ["file"] = "lens.raw", ["type"] = "<f8", ["shape"] = new JArray(1, LensBenchmark.Pixels, 2), ["K"] = new JArray(lens.FocalXPx, lens.FocalYPx, lens.CenterXPx, lens.CenterYPx), ["dist"] = new JArray(LensBenchmark.Dist) };
            File.WriteAllText(Path.Combine(folder, "corners.json"), StereoBenchmark.Corners());
            using (FileStream boards = File.Create(Path.Combine(folder, "board.raw")))
            {
                for (int i = 0; i < BoardBenchmark.Pictures; i++)
                {
                    using Image picture = BoardBenchmark.Picture(i);
                    boards.Write(picture.Bytes);
                }
            }

            list["board"] = new JObject { ["file"] = "board.raw", ["type"] = "u1", ["shape"] = new JArray(BoardBenchmark.Pictures, 1080, 1920) };
            File.WriteAllText(Path.Combine(folder, "frames.json"), list.ToString(Formatting.None));

            void Write(FrameLoop frames, Func<Frame, Image> picture, string name, string type, int[] shape)
            {
                using FileStream file = File.Create(Path.Combine(folder, name + ".raw"));
                for (int i = 0; i < Frames; i++)
                    file.Write(picture(frames[i]).Bytes);
                list[name] = new JObject { ["file"] = name + ".raw", ["type"] = type, ["shape"] = new JArray(shape) };
            }
        }
    }
}
