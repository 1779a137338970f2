using System;
using LaserTracking.Geometry;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Benchmarks
{
    /// <summary>Trackers on objects that circle over a 1920×1080 picture, pass one another and are missed in one frame of twelve; boxes overlap.</summary>
    internal static class TrackingBenchmarks
    {
        private const int Frames = 600;
        private const int MissedEvery = 12;

        public static Action<int> Sort(int objects)
        {
            var frames = new BoundingBox[Frames][];
            for (int f = 0; f < Frames; f++)
            {
                Vector2D[] places = Places(f, objects, 0.3);
                frames[f] = Array.ConvertAll(places, at => new BoundingBox(at.X - 40, at.Y - 80, 80 + 0.2 * (f % 7), 160));
            }

            var tracker = new SortTracker();
            return number => tracker.Process(frames[number % Frames]);
        }

        public static Action<int> Dots(int dots)
        {
            var frames = new Vector2D[Frames][];
            for (int f = 0; f < Frames; f++)
                frames[f] = Places(f, dots, 1);
            var tracker = new DotTracker();
            var ids = new int[dots];
            return number => tracker.Process(number * 33_333L, frames[number % Frames], 1920, ids);
        }

        private static Vector2D[] Places(int frame, int objects, double spread)
        {
            var places = new Vector2D[objects];
            int count = 0;
            for (int i = 0; i < objects; i++)
            {
                if ((frame + 5 * i) % MissedEvery == 0)
                    continue;
                double turn = 2 * Math.PI * (frame / 300.0 * (1 + i % 2) + i / (double)objects);
                places[count++] = new Vector2D(960 + spread * (300 + 30 * i) * Math.Cos(turn), 540 + spread * (200 + 15 * i) * Math.Sin(turn) + 3 * Math.Sin(frame * 1.4 + i));
            }

            return places[..count];
        }
    }
}
