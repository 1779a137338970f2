using System;
using LaserTracking.Imaging;

namespace LaserTracking.Simulation
{
    /// <summary>Six large shapes that bounce between the picture's edges, over a plain grey or a texture that scrolls. Immutable.</summary>
    internal sealed unsafe class MovingContent : IPictureContent
    {
        private const int ShapeCount = 6;
        private const int TileSize = 512;
        private const uint Grey = 0xFF484848u;
        private readonly int _width, _height;
        private readonly double _speedPxPerS;
        private readonly uint[]? _tile;
        private readonly Shape[] _shapes = new Shape[ShapeCount];

        public MovingContent(ProjectorSettings projector, int seed)
        {
            _width = projector.Width;
            _height = projector.Height;
            _speedPxPerS = projector.ContentSpeed * projector.Width;
            if (projector.Content == ProjectedContent.ShapesOverTexture)
                _tile = PaintTile(Math.Max(0.5, _width / 1280.0));
            for (int i = 0; i < ShapeCount; i++)
            {
                double Random(int what) => CounterRandom.Uniform(seed, RandomStream.Content, i, what);
                double angle = 2 * Math.PI * Random(0);
                _shapes[i] = new Shape
                {
                    HalfWidth = _width * (0.07 + 0.06 * Random(1)),
                    HalfHeight = _width * (0.05 + 0.06 * Random(2)),
                    StartX = Random(3),
                    StartY = Random(4),
                    VelocityX = Math.Cos(angle),
                    VelocityY = Math.Sin(angle),
                    IsEllipse = i % 2 == 0,
                    Color = Color(i, Random(5), Random(6), Random(7)),
                };
            }
        }

        public void Draw(Image picture, PixelRect rect, double timeS)
        {
            int scrollX = (int)Math.Floor(timeS * _speedPxPerS / 3), scrollY = (int)Math.Floor(timeS * _speedPxPerS / 7);
            for (int y = rect.Top; y < rect.Bottom; y++)
            {
                uint* row = (uint*)(picture.Pixels + (long)y * picture.Stride);
                for (int x = rect.Left; x < rect.Right; x++)
                    row[x] = _tile == null ? Grey : _tile[(y + scrollY & TileSize - 1) * TileSize + (x + scrollX & TileSize - 1)];
                foreach (Shape shape in _shapes)
                    DrawRow(shape, row, y, rect, timeS);
            }
        }

        private void DrawRow(in Shape shape, uint* row, int y, PixelRect rect, double timeS)
        {
            double centerX = Bounce(shape.StartX * _width + shape.VelocityX * _speedPxPerS * timeS, _width);
            double dy = (y - Bounce(shape.StartY * _height + shape.VelocityY * _speedPxPerS * timeS, _height)) / shape.HalfHeight;
            if (Math.Abs(dy) > 1)
                return;
            double half = shape.IsEllipse ? shape.HalfWidth * Math.Sqrt(1 - dy * dy) : shape.HalfWidth;
            int x1 = Math.Min(rect.Right, (int)Math.Ceiling(centerX + half));
            for (int x = Math.Max(rect.Left, (int)Math.Ceiling(centerX - half)); x < x1; x++)
                row[x] = shape.Color;
        }

        private static double Bounce(double position, double length)
        {
            double turn = position % (2 * length);
            if (turn < 0)
                turn += 2 * length;
            return turn < length ? turn : 2 * length - turn;
        }

        /// <summary>White, black, a green and three at random: what a projector shows at its brightest, and the laser's own colour.</summary>
        private static uint Color(int shape, double blue, double green, double red)
        {
            switch (shape)
            {
                case 0: return 0xFFFFFFFFu;
                case 1: return 0xFF080808u;
                case 2: return 0xFF28DC28u;
                default: return 0xFF000000u | (uint)(40 + 200 * blue) | (uint)(40 + 200 * green) << 8 | (uint)(40 + 200 * red) << 16;
            }
        }

        private static uint[] PaintTile(double scale)
        {
            var tile = new uint[TileSize * TileSize];
            for (int y = 0; y < TileSize; y++)
            {
                for (int x = 0; x < TileSize; x++)
                {
                    double coarse = ValueNoise.At(x / (40 * scale), y / (40 * scale), 60), fine = ValueNoise.At(x / (9 * scale), y / (9 * scale), 61);
                    double level = 25 + 120 * coarse + 60 * fine;
                    uint blue = (uint)(level * 0.8), green = (uint)level, red = (uint)(level * (0.7 + 0.3 * coarse));
                    tile[y * TileSize + x] = 0xFF000000u | blue | green << 8 | red << 16;
                }
            }

            return tile;
        }

        private struct Shape
        {
            public double HalfWidth;
            public double HalfHeight;
            public double StartX;
            public double StartY;
            public double VelocityX;
            public double VelocityY;
            public bool IsEllipse;
            public uint Color;
        }
    }
}
