using System;
using System.Collections.Generic;
using System.CommandLine;
using System.IO;
using System.Threading;
using System.Threading.Tasks;
using LaserTracking.Host.Sessions;
using LaserTracking.Host.Tracks;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Commands
{
    /// <summary>range track: follows the boxes of a file of detections.</summary>
    internal static class TrackCommand
    {
        private const int DefaultDotAge = 30;

        public static Command Create()
        {
            var input = new Argument<string>("DET.txt") { Description = "Detections as MOT15 text: frame,-1,x,y,w,h,score; frames from 1." };
            var tracker = new Option<string>("--tracker") { HelpName = "NAME", Description = "'sort': SORT as published; 'dots': for small fast dots that look alike.", DefaultValueFactory = _ => "sort" };
            tracker.AcceptOnlyFromAmong("sort", "dots");
            var maxAge = new Option<int?>("--max-age") { HelpName = "N", Description = $"Frames without a detection after which a track ends; 1 for sort, {DefaultDotAge} for dots." };
            var minHits = new Option<int?>("--min-hits") { HelpName = "N", Description = "Detections before a track is reported; 3 for sort, 2 for dots." };
            var iou = new Option<double?>("--iou") { HelpName = "X", Description = "sort: least overlap (intersection over union) of a detection and a predicted box; 0.3." };
            var fps = new Option<double?>("--fps") { HelpName = "X", Description = "dots: frames per second; 30." };
            var width = new Option<double?>("--width") { HelpName = "PX", Description = "dots: width of the picture in which the boxes lie; 1920." };
            var output = new Option<string>("--out") { HelpName = "FILE", Description = "Tracks: frame,id,x,y,w,h with 6 decimals.", Required = true };
            var command = new Command("track", "Follows boxes from frame to frame: detections in, numbered tracks out.") { input, tracker, maxAge, minHits, iou, fps, width, output };
            command.SetAction((parsed, interrupted) =>
            {
                bool isSort = parsed.GetValue(tracker) == "sort";
                foreach (Option option in isSort ? new Option[] { fps, width } : new Option[] { iou })
                {
                    if (parsed.GetResult(option) != null)
                        throw new InputException(option.Name, "does not apply to --tracker " + (isSort ? "sort" : "dots"), "leave it out");
                }

                int hits = InRange(minHits, parsed.GetValue(minHits) ?? (isSort ? 3 : 2), isSort ? 0 : 1, isSort ? 1_000_000 : 60);
                int age = InRange(maxAge, parsed.GetValue(maxAge) ?? (isSort ? 1 : DefaultDotAge), 0, isSort ? 1_000_000 : 1000);
                double overlap = InRange(iou, parsed.GetValue(iou) ?? 0.3, 0, 1);
                double framesPerSecond = InRange(fps, parsed.GetValue(fps) ?? 30, 1, 10_000), imageWidth = InRange(width, parsed.GetValue(width) ?? 1920, 1, 100_000);
                Run(parsed.GetValue(input)!, parsed.GetValue(output)!, (rows, report, ignored) =>
                {
                    if (isSort)
                        BoxTracking.Sort(rows, new SortTrackerSettings { MaxAge = age, MinHits = hits, IouThreshold = overlap }, report, ignored, interrupted);
                    else
                        BoxTracking.Dots(rows, DotSettings(age, hits, framesPerSecond), framesPerSecond, imageWidth, report, ignored, interrupted);
                });
                return Task.FromResult(ExitCodes.Done);
            });
            return command;
        }

        /// <summary>Half a frame more than asked for, so that rounded times do not cost the last one.</summary>
        private static DotTrackerSettings DotSettings(int age, int hits, double framesPerSecond) =>
            new() { MinHits = hits, MemoryUs = Math.Min(60_000_000, (long)((age + 0.5) * 1e6 / framesPerSecond)) };

        private delegate void Tracking(List<MotRow> rows, Action<MotRow> report, Action<int, int, int> ignored);

        private static void Run(string input, string output, Tracking track)
        {
            ResultFile.CheckNotRead(output, input);
            List<MotRow> rows = MotFile.Read(input);
            if (rows.Count == 0)
                throw MotFile.Empty(input);
            int frames = 0, worstFrame = 0, worstCount = 0, worstIgnored = 0;
            using var result = new ResultFile(output);
            using (var writer = new StreamWriter(result.Stream, bufferSize: 1 << 16, leaveOpen: true))
            {
                track(rows, row => MotFile.Write(writer, row), (frame, count, ignored) =>
                {
                    frames++;
                    if (ignored > worstIgnored)
                        (worstFrame, worstCount, worstIgnored) = (frame, count, ignored);
                });
            }

            result.Commit();
            if (frames > 0)
                Console.Error.WriteLine(FormattableString.Invariant($"range: {input}: too many detections in {frames} frame(s); in frame {worstFrame} {worstIgnored} of {worstCount} were not used"));
        }

        private static T InRange<T>(Option option, T value, T least, T most)
            where T : IComparable<T> =>
            value.CompareTo(least) >= 0 && value.CompareTo(most) <= 0
                ? value
                : throw new InputException(option.Name, FormattableString.Invariant($"{value} is not in {least}…{most}"), "give another value");
    }
}
