using System;
using System.Collections.Generic;
using System.Runtime.InteropServices;
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
            var boxes = new List<BoundingBox>();
            int next = 0, last = rows[^1].Frame;
            for (int frame = 1; frame <= last; frame++)
            {
                interrupted.ThrowIfCancellationRequested();
                boxes.Clear();
                for (; next < rows.Count && rows[next].Frame == frame; next++)
                    boxes.Add(rows[next].Box);
                tracker.Process(CollectionsMarshal.AsSpan(boxes));
                if (tracker.IgnoredDetections > 0)
                    ignored(frame, boxes.Count, tracker.IgnoredDetections);
                foreach (TrackedBox tracked in tracker.Boxes)
                    report(new MotRow(frame, tracked.TrackId, tracked.Box, 1));
            }
        }

        /// <summary>Dots stand where they were seen; those that have no number (yet) are left out.</summary>
        /// <param name="rows">By frame.</param>
        /// <param name="framesPerSecond">Of the sequence.</param>
        /// <param name="imageWidthPx">Width of the picture in which the boxes lie.</param>
        public static void Dots(List<MotRow> rows, DotTrackerSettings settings, double framesPerSecond, double imageWidthPx, Action<MotRow> report,
            Action<int, int, int> ignored, CancellationToken interrupted)
        {
            var tracker = new DotTracker(settings);
            var places = new List<Vector2D>();
            int[] ids = [];
            for (int first = 0; first < rows.Count; first += places.Count)
            {
                interrupted.ThrowIfCancellationRequested();
                int frame = rows[first].Frame;
                places.Clear();
                for (int i = first; i < rows.Count && rows[i].Frame == frame; i++)
                    places.Add(new Vector2D(rows[i].Box.CenterX, rows[i].Box.CenterY));
                if (ids.Length < places.Count)
                    ids = new int[places.Count];
                tracker.Process((long)Math.Round(frame * 1e6 / framesPerSecond), CollectionsMarshal.AsSpan(places), imageWidthPx, ids);
                if (tracker.IgnoredDots > 0)
                    ignored(frame, places.Count, tracker.IgnoredDots);
                for (int i = 0; i < places.Count; i++)
                {
                    if (ids[i] > 0)
                        report(rows[first + i] with { Id = ids[i] });
                }
            }
        }
    }
}
