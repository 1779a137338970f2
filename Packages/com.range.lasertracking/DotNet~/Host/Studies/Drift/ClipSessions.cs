using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Host.Scoring;
using LaserTracking.Host.Sources;
using LaserTracking.Host.Studies.Clips;

namespace LaserTracking.Host.Studies.Drift
{
    /// <summary>The recorded clips as they are, and displaced as a whole after three seconds.</summary>
    internal static class ClipSessions
    {
        private const string AsIs = "recorded clip as it is", Displaced = "recorded clip displaced after 3 s";
        private const double FromS = 3;

        public static readonly string[] Rows = { AsIs, Displaced };

        /// <summary>Whole pixels of the clip, so that nothing is blurred; none: as it is.</summary>
        public static readonly Vector2D[] Ways = { default, new(2, -1), new(-9, 6) };

        public static DriftSession Create(ClipSet clips, TruthClip clip, Vector2D wayPx)
        {
            bool moves = wayPx.Length > 0;
            double from = moves ? FromS : double.PositiveInfinity;
            return new DriftSession(clip.File, Play(clips.PathOf(clip), from, wayPx), [(moves ? Displaced : AsIs, null)], from, from, wayPx * (640.0 / clip.Width), false);
        }

        private static IEnumerable<Frame> Play(string path, double fromS, Vector2D wayPx)
        {
            using IFrameSource source = new PrefetchingFrameSource(FrameSources.OpenScreenCamera(path));
            using var frame = new Frame();
            using var moved = new Frame();
            long first = long.MinValue;
            while (source.TryRead(frame))
            {
                first = first == long.MinValue ? frame.TimeUs : first;
                moved.Begin(frame.Index, frame.TimeUs - first);
                moved.Color.CopyFrom(frame.Color);
                if (moved.TimeUs >= fromS * 1e6)
                    PictureStress.Displace(frame.Color, moved.Color, (int)wayPx.X, (int)wayPx.Y);
                yield return moved;
            }
        }
    }
}
