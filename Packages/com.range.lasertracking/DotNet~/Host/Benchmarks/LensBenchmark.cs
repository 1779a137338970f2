using System;
using LaserTracking.Geometry;

namespace LaserTracking.Host.Benchmarks
{
    /// <summary>A depth camera's colour lens at 1920×1080: exact rays, the table of rays, and a million look-ups at random places.</summary>
    internal static class LensBenchmark
    {
        public const int Pixels = 1_000_000;

        public static double[] Dist { get; } = [-1.0575668, -1.3993427, 0.0006910161, -1.2259531e-05, 1.7508856, -1.148518, -1.1924416, 1.6220586];

        public static LensCamera Camera { get; } = new(new PinholeCamera(923.70233, 923.4313, 952.32214, 544.40265, 1920, 1080), BrownDistortion.FromOpenCv(Dist));

        public static Action<int> BuildTable() => _ => LensTable.Within(Camera);

        public static Action<int> LookUp()
        {
            LensTable table = LensTable.Within(Camera);
            Vector2D[] pixels = RandomPixels(), rays = new Vector2D[Pixels];
            return _ => table.Rays(pixels, rays);
        }

        public static Action<int> Exact()
        {
            Vector2D[] pixels = RandomPixels(), rays = new Vector2D[Pixels];
            return _ =>
            {
                for (int i = 0; i < pixels.Length; i++)
                    Camera.TryUnproject(pixels[i], out rays[i]);
            };
        }

        public static Vector2D[] RandomPixels()
        {
            var random = new Random(1);
            var pixels = new Vector2D[Pixels];
            for (int i = 0; i < pixels.Length; i++)
                pixels[i] = new Vector2D(random.NextDouble() * 1919, random.NextDouble() * 1079);
            return pixels;
        }
    }
}
