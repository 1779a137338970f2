using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Patterns;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// A checkerboard before a camera with its lens, painted with exact corners known: pixels integrate the light that falls on them,
    /// then come uneven light, glare, blur, noise and eight bits. Board space is mm: origin at the first corner, x along the columns,
    /// y along the rows, z away from the viewer; the square between the first four corners is dark. Not thread-safe.
    /// </summary>
    public sealed unsafe class SimulatedBoard
    {
        private const int SamplesAcross = 8;

        private float[] _light = Array.Empty<float>();
        private float[] _blurred = Array.Empty<float>();
        private Vector2D[] _above = Array.Empty<Vector2D>();
        private Vector2D[] _below = Array.Empty<Vector2D>();

        /// <param name="size">Inner corners.</param>
        /// <param name="squareMm">Side of a square, above zero.</param>
        public SimulatedBoard(BoardSize size, double squareMm)
        {
            Size = size;
            SquareMm = squareMm > 0 ? squareMm : throw new ArgumentOutOfRangeException(nameof(squareMm), "above 0");
        }

        public BoardSize Size { get; }

        public double SquareMm { get; }

        /// <summary>Board space in camera space, mm.</summary>
        public Pose Pose { get; set; } = Pose.Identity;

        /// <summary>Grey levels of dark squares, light squares and margin.</summary>
        public double Dark { get; set; } = 25;

        /// <summary>Grey level of light squares and of the margin.</summary>
        public double Light { get; set; } = 215;

        /// <summary>Light margin around the outer squares, in squares.</summary>
        public double Margin { get; set; } = 0.5;

        /// <summary>Standard deviation of the camera's Gaussian blur, px.</summary>
        public double BlurPx { get; set; }

        /// <summary>Standard deviation of the sensor's noise, grey levels.</summary>
        public double Noise { get; set; }

        /// <summary>Uneven light: from 1 - this at the picture's left to 1 + this at its right; -1 to 1.</summary>
        public double LightSlope { get; set; }

        /// <summary>Light added by a reflex at its centre, grey levels.</summary>
        public double Glare { get; set; }

        public Vector2D GlareCenterPx { get; set; }

        /// <summary>Standard deviation of the reflex, px.</summary>
        public double GlareRadiusPx { get; set; } = 30;

        public int Seed { get; set; } = 1;

        /// <summary>A pose that shows the board's middle at the camera's axis: turned about x and y, then about z, at a distance.</summary>
        public Pose Centered(double distanceMm, double tiltXRad, double tiltYRad, double rollRad)
        {
            Rotation3D rotation = Rotation3D.AboutAxis(new Vector3D(0, 0, 1), rollRad)
                * Rotation3D.AboutAxis(new Vector3D(0, 1, 0), tiltYRad)
                * Rotation3D.AboutAxis(new Vector3D(1, 0, 0), tiltXRad);
            var middle = new Vector3D((Size.Columns - 1) * SquareMm / 2, (Size.Rows - 1) * SquareMm / 2, 0);
            return new Pose(new Vector3D(0, 0, distanceMm) - rotation * middle, rotation);
        }

        /// <summary>Where the corners are seen, row by row; false when one is behind the camera or beyond the lens model.</summary>
        public bool TryProject(LensCamera camera, Span<Vector2D> cornersPx)
        {
            for (int row = 0, k = 0; row < Size.Rows; row++)
            for (int column = 0; column < Size.Columns; column++, k++)
            {
                Vector3D point = Pose.TransformPoint(new Vector3D(column * SquareMm, row * SquareMm, 0));
                if (!(point.Z > 0) || !camera.TryProject(new Vector2D(point.X / point.Z, point.Y / point.Z), out cornersPx[k]))
                    return false;
            }

            return true;
        }

        /// <summary>Paints the board over what a <see cref="PixelFormat.Gray8"/> picture of the camera's size shows already.</summary>
        /// <exception cref="ArgumentException">Another format or size.</exception>
        public void Paint(LensCamera camera, Image picture)
        {
            if (picture.Format != PixelFormat.Gray8 || picture.Width != camera.Pinhole.Width || picture.Height != camera.Pinhole.Height)
                throw new ArgumentException("the picture must be grey and of the camera's size", nameof(picture));
            MakeRoom(picture.Width, picture.Height);
            MapCorners(camera, 0, _below);
            for (int y = 0; y < picture.Height; y++)
            {
                (_above, _below) = (_below, _above);
                MapCorners(camera, y + 1, _below);
                byte* row = picture.Pixels + (long)y * picture.Stride;
                for (int x = 0; x < picture.Width; x++)
                    _light[y * picture.Width + x] = (float)Expose(x, y, picture.Width, Integrate(x, row[x]));
            }

            Blur(picture.Width, picture.Height);
            Read(picture);
        }

        private void MakeRoom(int width, int height)
        {
            if (_light.Length < width * height)
            {
                _light = new float[width * height];
                _blurred = new float[width * height];
            }

            if (_above.Length < width + 1)
            {
                _above = new Vector2D[width + 1];
                _below = new Vector2D[width + 1];
            }
        }

        /// <summary>Board places, in squares, seen at the corners between one row of pixels and the next; NaN beside the lens model.</summary>
        private void MapCorners(LensCamera camera, int row, Vector2D[] places)
        {
            Rotation3D toBoard = Pose.Rotation.Inverse;
            Vector3D eye = toBoard * (Pose.Position * -1);
            for (int i = 0; i <= camera.Pinhole.Width; i++)
            {
                places[i] = new Vector2D(double.NaN, double.NaN);
                if (!camera.TryUnproject(new Vector2D(i - 0.5, row - 0.5), out Vector2D ray))
                    continue;
                Vector3D direction = toBoard * new Vector3D(ray.X, ray.Y, 1);
                double distance = -eye.Z / direction.Z;
                if (distance > 0)
                    places[i] = new Vector2D((eye.X + distance * direction.X) / SquareMm, (eye.Y + distance * direction.Y) / SquareMm);
            }
        }

        private double Integrate(int x, double background)
        {
            Vector2D a = _above[x], b = _above[x + 1], c = _below[x], d = _below[x + 1];
            double first = Level(a, background);
            if (!(a + b + c + d).IsFinite)
                return background;
            if (IsSameSquare(a, b) && IsSameSquare(a, c) && IsSameSquare(a, d))
                return first;
            double sum = 0;
            for (int j = 0; j < SamplesAcross; j++)
            for (int i = 0; i < SamplesAcross; i++)
            {
                double u = (i + 0.5) / SamplesAcross, v = (j + 0.5) / SamplesAcross;
                sum += Level((a * (1 - u) + b * u) * (1 - v) + (c * (1 - u) + d * u) * v, background);
            }

            return sum / (SamplesAcross * SamplesAcross);
        }

        private double Level(Vector2D place, double background)
        {
            if (!(place.X > -1 - Margin && place.Y > -1 - Margin && place.X < Size.Columns + Margin && place.Y < Size.Rows + Margin))
                return background;
            bool isSquare = place.X > -1 && place.Y > -1 && place.X < Size.Columns && place.Y < Size.Rows;
            return isSquare && ((int)Math.Floor(place.X) + (int)Math.Floor(place.Y)) % 2 == 0 ? Dark : Light;
        }

        /// <summary>Also true for two places beside the board at its own rim, where the margin ends: it is no corner's edge.</summary>
        private static bool IsSameSquare(Vector2D a, Vector2D b) => Math.Floor(a.X) == Math.Floor(b.X) && Math.Floor(a.Y) == Math.Floor(b.Y);

        private double Expose(int x, int y, int width, double light)
        {
            light *= 1 + LightSlope * (2.0 * x / width - 1);
            return Glare == 0
                ? light
                : light + Glare * Math.Exp(-(new Vector2D(x, y) - GlareCenterPx).LengthSquared / (2 * GlareRadiusPx * GlareRadiusPx));
        }

        private void Blur(int width, int height)
        {
            int radius = BlurPx > 0.05 ? (int)Math.Ceiling(3.5 * BlurPx) : 0;
            if (radius == 0)
                return;
            var kernel = new float[radius + 1];
            double sum = 0;
            for (int i = -radius; i <= radius; i++)
                sum += Math.Exp(-i * i / (2 * BlurPx * BlurPx));
            for (int i = 0; i <= radius; i++)
                kernel[i] = (float)(Math.Exp(-i * i / (2 * BlurPx * BlurPx)) / sum);
            for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++)
            {
                float value = kernel[0] * _light[y * width + x];
                for (int i = 1; i <= radius; i++)
                    value += kernel[i] * (_light[y * width + Math.Max(0, x - i)] + _light[y * width + Math.Min(width - 1, x + i)]);
                _blurred[y * width + x] = value;
            }

            for (int y = 0; y < height; y++)
            for (int x = 0; x < width; x++)
            {
                float value = kernel[0] * _blurred[y * width + x];
                for (int i = 1; i <= radius; i++)
                    value += kernel[i] * (_blurred[Math.Max(0, y - i) * width + x] + _blurred[Math.Min(height - 1, y + i) * width + x]);
                _light[y * width + x] = value;
            }
        }

        private void Read(Image picture)
        {
            for (int y = 0; y < picture.Height; y++)
            {
                byte* row = picture.Pixels + (long)y * picture.Stride;
                for (int x = 0; x < picture.Width; x++)
                {
                    double value = _light[y * picture.Width + x];
                    if (Noise > 0)
                        value += Noise * CounterRandom.Gaussian(Seed, RandomStream.BoardNoise, y, x);
                    row[x] = (byte)Math.Max(0, Math.Min(255, Math.Round(value)));
                }
            }
        }
    }
}
