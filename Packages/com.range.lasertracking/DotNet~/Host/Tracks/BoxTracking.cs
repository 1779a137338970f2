using System;
using System.Collections.Generic;
using System.Threading;
using LaserTracking.Geometry;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Tracks
{
    /// <summary>Runs a tracker over the boxes of a file, frame by frame from 1 to the last, and passes on what it reports.</summary>
    internal static class BoxTracking
    {
        /// <param name="rows">By frame; not empty.</param>
        /// <param name="report">Called with each tracked box.</param>
        /// <param name="ignored">Called with frame, detections and ignored ones where some had to be.</param>
        public static void Sort(List<MotRow> rows, SortTrackerSettings settings, Action<MotRow> report, Action<int, int, int> ignored, CancellationToken interrupted)
        {
            var tracker = new SortTracker(settings);
            EachFrame(rows, interrupted, (frame, first, count) =>
            {
                var boxes = new BoundingBox[count];
                for (int i = 0; i < count; i++)
                    boxes[i] = rows[first + i].Box;
                tracker.Process(boxes);
                if (tracker.IgnoredDetections > 0)
                    ignored(frame, count, tracker.IgnoredDetections);
                foreach (TrackedBox tracked in tracker.Boxes)
                    report(new MotRow(frame, tracked.TrackId, tracked.Box, 1));
            });
        }

        /// <summary>Dots stand where they were seen; those that have no number (yet) are left out.</summary>
        /// <param name="rows">By frame; not empty.</param>
        /// <param name="framesPerSecond">Of the sequence.</param>
        /// <param name="imageWidthPx">Width of the picture in which the boxes lie.</param>
        public static void Dots(List<MotRow> rows, DotTrackerSettings settings, double framesPerSecond, double imageWidthPx, Action<MotRow> report,
            Action<int, int, int> ignored, CancellationToken interrupted)
        {
            var tracker = new DotTracker(settings);
            EachFrame(rows, interrupted, (frame, first, count) =>
            {
                var places = new Vector2D[count];
                var ids = new int[count];
                for (int i = 0; i < count; i++)
                    places[i] = new Vector2D(rows[first + i].Box.CenterX, rows[first + i].Box.CenterY);
                tracker.Process((long)Math.Round(frame * 1e6 / framesPerSecond), places, imageWidthPx, ids);
                if (tracker.IgnoredDots > 0)
                    ignored(frame, count, tracker.IgnoredDots);
                for (int i = 0; i < count; i++)
                {
                    if (ids[i] > 0)
                        report(rows[first + i] with { Id = ids[i] });
                }
            });
        }

        /// <summary>Calls with frame, index of its first row and number of its rows; also for frames without rows.</summary>
        private static void EachFrame(List<MotRow> rows, CancellationToken interrupted, Action<int, int, int> process)
        {
            int first = 0, last = rows[^1].Frame;
            for (int frame = 1; frame <= last; frame++)
            {
                interrupted.ThrowIfCancellationRequested();
                int next = first;
                while (next < rows.Count && rows[next].Frame == frame)
                    next++;
                process(frame, first, next - first);
                first = next;
            }
        }
    }
}
