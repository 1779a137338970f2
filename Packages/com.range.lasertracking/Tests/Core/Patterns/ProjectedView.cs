using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Patterns
{
    /// <summary>A camera's picture of a projected pattern, drawn from the exact mapping by averaging many samples a pixel.</summary>
    internal sealed class ProjectedView : IDisposable
    {
        private const int Samples = 3;

        /// <summary>Side of the square of samples that a pixel gathers, nearly two pixels: no lens is sharper.</summary>
        private const int Footprint = 5;

        private readonly ScreenPattern _pattern;
        private readonly Homography _toPlace;
        private readonly Random _random = new Random(5);

        /// <param name="width">Of the camera's picture.</param>
        /// <param name="height">Of the camera's picture.</param>
        /// <param name="cornersPx">Where it sees the picture's corners, top-left first, clockwise as projected.</param>
        public ProjectedView(int width, int height, params Vector2D[] cornersPx)
        {
            Width = width;
            Height = height;
            _pattern = new ScreenPattern(640, 360);
            HomographyEstimator.TryFit(cornersPx, ScreenGeometry.CornersOf(new Vector2D(1, 1)), out _toPlace, out _);
        }

        public int Width { get; }

        public int Height { get; }

        public double Noise { get; set; } = 1;

        /// <summary>Somebody's outline, px; the room behind them is not seen.</summary>
        public Func<int, int, bool> IsHidden { get; set; } = (x, y) => false;

        /// <summary>Room light by pixel: posters, lamps.</summary>
        public Func<int, int, double> Room { get; set; } = (x, y) => 30;

        public Image Image { get; } = new Image();

        /// <summary>Where a place of the picture is seen.</summary>
        public Vector2D ToImagePx(Vector2D place) => _toPlace.Inverse.Map(place);

        public unsafe Image Draw(int picture)
        {
            Image.Reset(PixelFormat.Gray8, Width, Height, 0);
            float[] light = Light(picture);
            for (int y = 0; y < Height; y++)
            {
                for (int x = 0; x < Width; x++)
                {
                    double sum = 0;
                    for (int i = 0; i < Footprint * Footprint && !IsHidden(x, y); i++)
                    {
                        int u = Samples * x + Samples / 2 + i % Footprint - Footprint / 2, v = Samples * y + Samples / 2 + i / Footprint - Footprint / 2;
                        sum += light[Math.Max(0, Math.Min(Height * Samples - 1, v)) * Width * Samples + Math.Max(0, Math.Min(Width * Samples - 1, u))];
                    }

                    double noise = (_random.NextDouble() + _random.NextDouble() + _random.NextDouble() - 1.5) * 2 * Noise;
                    Image.Pixels[y * Image.Stride + x] = (byte)Math.Max(0, Math.Min(255, Room(x, y) + 0.5 * sum / (Footprint * Footprint) + noise + 0.5));
                }
            }

            return Image;
        }

        /// <summary>The projected picture, interpolated, on a grid finer than the camera's.</summary>
        private unsafe float[] Light(int picture)
        {
            using var drawn = new Image();
            _pattern.Draw(picture, drawn);
            var light = new float[Width * Height * Samples * Samples];
            for (int i = 0; i < light.Length; i++)
            {
                int row = i / (Width * Samples), column = i % (Width * Samples);
                Vector2D place = _toPlace.Map(new Vector2D((column + 0.5) / Samples - 0.5, (row + 0.5) / Samples - 0.5));
                double u = place.X * drawn.Width - 0.5, v = place.Y * drawn.Height - 0.5;
                if (!(u > -0.5 && v > -0.5 && u < drawn.Width - 0.5 && v < drawn.Height - 0.5))
                    continue;
                int left = Math.Max(0, Math.Min(drawn.Width - 2, (int)u)), top = Math.Max(0, Math.Min(drawn.Height - 2, (int)v));
                byte* p = drawn.Pixels + top * drawn.Stride + left;
                double fu = Math.Max(0, Math.Min(1, u - left)), fv = Math.Max(0, Math.Min(1, v - top));
                light[i] = (float)((p[0] * (1 - fu) + p[1] * fu) * (1 - fv) + (p[drawn.Stride] * (1 - fu) + p[drawn.Stride + 1] * fu) * fv);
            }

            return light;
        }

        public ScreenPatternView Look(params int[] pictures)
        {
            using var finder = new ScreenPatternFinder();
            foreach (int picture in pictures)
                finder.Add(Draw(picture));
            return finder.Find();
        }

        public void Dispose() => Image.Dispose();
    }
}
