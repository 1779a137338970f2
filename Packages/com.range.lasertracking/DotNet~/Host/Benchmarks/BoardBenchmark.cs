using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Patterns;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Benchmarks
{
    /// <summary>A board held before the simulated range: a rendered 1080p picture with clutter, tilt, lens, blur, noise and uneven light.</summary>
    internal static class BoardBenchmark
    {
        public const int Pictures = 4;

        public static BoardSize Size { get; } = new(9, 6);

        /// <summary>The picture; another number is another pose.</summary>
        public static Image Picture(int number)
        {
            var picture = new Image();
            GrayConversion.ToGray(BenchmarkList.DetectFrames(1920, 1080, PixelFormat.Bgra32, 2)[0].Color, picture);
            var camera = new LensCamera(new PinholeCamera(1400, 1400, 959.5, 539.5, 1920, 1080), new BrownDistortion([-0.2, 0.05, 0], 0.001, -0.001));
            var board = new SimulatedBoard(Size, 40) { BlurPx = 1, Noise = 2, LightSlope = 0.3, Seed = number };
            board.Pose = board.Centered(700 + 50 * (number % 4), 0.4, -0.3 + 0.15 * (number % 5), 0.1 * number);
            board.Paint(camera, picture);
            return picture;
        }

        public static Action<int> Prepare()
        {
            var pictures = new Image[Pictures];
            for (int i = 0; i < Pictures; i++)
                pictures[i] = Picture(i);
            var finder = new CheckerboardFinder();
            var corners = new Vector2D[Size.Count];
            return number =>
            {
                if (!finder.TryFind(pictures[number % Pictures], Size, corners, out string reason))
                    throw new InvalidOperationException(reason);
            };
        }
    }
}
