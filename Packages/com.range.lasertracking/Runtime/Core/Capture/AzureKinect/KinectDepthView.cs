using System;
using LaserTracking.Geometry;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>
    /// Whole depth pictures: as points in space, and as the colour camera would see them. Rays are looked up in a table made once. One
    /// thread at a time; allocates nothing once made.
    /// </summary>
    public sealed class KinectDepthView
    {
        // Neighbours further apart than this share of their depth are two things, with nothing between them (the SDK's value).
        private const float LargestStep = 0.0469f;

        private readonly KinectCalibration _calibration;
        private readonly int _width;
        private readonly int _height;
        private readonly Vector2D[] _rays;
        private readonly Vector3D[] _colorRays;
        private readonly Vertex[] _above;
        private readonly Vertex[] _below;

        public KinectDepthView(KinectCalibration calibration)
        {
            _calibration = calibration ?? throw new ArgumentNullException(nameof(calibration));
            PinholeCamera pinhole = calibration.Infrared.Pinhole;
            _width = pinhole.Width;
            _height = pinhole.Height;
            _rays = new Vector2D[_width * _height];
            _colorRays = new Vector3D[_rays.Length];
            _above = new Vertex[_width];
            _below = new Vertex[_width];
            var table = new LensTable(calibration.Infrared, 1);
            for (int i = 0; i < _rays.Length; i++)
            {
                _rays[i] = table.At(i % _width, i / _width);
                _colorRays[i] = calibration.InfraredToColorMm.TransformDirection(new Vector3D(_rays[i].X, _rays[i].Y, 1));
            }
        }

        /// <summary>Every pixel's point in the depth camera's space.</summary>
        /// <param name="depthMm">The depth picture, row by row without gaps; 0: nothing measured.</param>
        /// <param name="xyzMm">Three numbers a pixel, rounded to mm; zeros where nothing was measured or the lens model gives no ray.</param>
        public void PointCloud(ReadOnlySpan<ushort> depthMm, Span<short> xyzMm)
        {
            CheckDepth(depthMm);
            if (xyzMm.Length != 3 * _rays.Length)
                throw new ArgumentException("three numbers a pixel are needed", nameof(xyzMm));
            for (int i = 0; i < _rays.Length; i++)
            {
                bool isPoint = depthMm[i] > 0 && !double.IsNaN(_rays[i].X);
                double z = isPoint ? depthMm[i] : 0;
                xyzMm[3 * i] = Round(isPoint ? _rays[i].X * z : 0);
                xyzMm[3 * i + 1] = Round(isPoint ? _rays[i].Y * z : 0);
                xyzMm[3 * i + 2] = Round(z);
            }
        }

        /// <summary>
        /// Depth as the colour camera would measure it: the depth picture as a net of triangles, torn where depth jumps, the nearest on top.
        /// </summary>
        /// <param name="depthMm">The depth picture, row by row without gaps; 0: nothing measured.</param>
        /// <param name="colorDepthMm">One number a colour pixel: z in the colour camera's space; 0: nothing.</param>
        public void ToColor(ReadOnlySpan<ushort> depthMm, Span<ushort> colorDepthMm)
        {
            CheckDepth(depthMm);
            PinholeCamera color = _calibration.Color.Pinhole;
            if (colorDepthMm.Length != color.Width * color.Height)
                throw new ArgumentException("one number a colour pixel is needed", nameof(colorDepthMm));
            colorDepthMm.Clear();
            Vertex[] above = _above, below = _below;
            ProjectRow(depthMm, 0, below);
            for (int row = 1; row < _height; row++)
            {
                (above, below) = (below, above);
                ProjectRow(depthMm, row, below);
                for (int x = 1; x < _width; x++)
                {
                    // Where a corner is missing, the three others still make a triangle.
                    bool isOtherWay = !(above[x - 1].Depth > 0 && below[x].Depth > 0);
                    ref Vertex a = ref isOtherWay ? ref above[x] : ref above[x - 1], c = ref isOtherWay ? ref below[x - 1] : ref below[x];
                    Draw(a, isOtherWay ? below[x] : above[x], c, colorDepthMm, color.Width, color.Height);
                    Draw(a, isOtherWay ? above[x - 1] : below[x - 1], c, colorDepthMm, color.Width, color.Height);
                }
            }
        }

        private static short Round(double value) => (short)Math.Max(short.MinValue, Math.Min(short.MaxValue, Math.Floor(value + 0.5)));

        private void CheckDepth(ReadOnlySpan<ushort> depthMm)
        {
            if (depthMm.Length != _rays.Length)
                throw new ArgumentException("this is no depth picture of the calibration's mode", nameof(depthMm));
        }

        private void ProjectRow(ReadOnlySpan<ushort> depthMm, int row, Vertex[] vertices)
        {
            Vector3D offset = _calibration.InfraredToColorMm.Position;
            for (int x = 0; x < _width; x++)
            {
                int at = row * _width + x;
                Vector3D point = _colorRays[at] * depthMm[at] + offset;
                bool isSeen = depthMm[at] > 0 && _calibration.Color.TryProject(point, out vertices[x].Pixel);
                vertices[x].Depth = isSeen ? (float)point.Z : 0;
            }
        }

        private static void Draw(in Vertex a, in Vertex b, in Vertex c, Span<ushort> picture, int width, int height)
        {
            float nearest = Math.Min(a.Depth, Math.Min(b.Depth, c.Depth)), farthest = Math.Max(a.Depth, Math.Max(b.Depth, c.Depth));
            if (!(nearest > 0) || farthest - nearest > LargestStep * nearest)
                return;
            Vector2D ab = b.Pixel - a.Pixel, ac = c.Pixel - a.Pixel;
            double area = Vector2D.Cross(ab, ac);
            if (!(Math.Abs(area) > 0))
                return;
            int left = (int)Math.Ceiling(Math.Max(0, Math.Min(a.Pixel.X, Math.Min(b.Pixel.X, c.Pixel.X))));
            int right = (int)Math.Floor(Math.Min(width - 1, Math.Max(a.Pixel.X, Math.Max(b.Pixel.X, c.Pixel.X))));
            int top = (int)Math.Ceiling(Math.Max(0, Math.Min(a.Pixel.Y, Math.Min(b.Pixel.Y, c.Pixel.Y))));
            int bottom = (int)Math.Floor(Math.Min(height - 1, Math.Max(a.Pixel.Y, Math.Max(b.Pixel.Y, c.Pixel.Y))));
            for (int y = top; y <= bottom; y++)
            for (int x = left; x <= right; x++)
            {
                Vector2D p = new Vector2D(x, y) - a.Pixel;
                double shareB = Vector2D.Cross(p, ac) / area, shareC = Vector2D.Cross(ab, p) / area;
                if (shareB < 0 || shareC < 0 || shareB + shareC > 1)
                    continue;
                double depth = a.Depth + shareB * (b.Depth - a.Depth) + shareC * (c.Depth - a.Depth) + 0.5;
                ref ushort pixel = ref picture[y * width + x];
                ushort value = depth < ushort.MaxValue ? (ushort)depth : ushort.MaxValue;
                if (pixel == 0 || value < pixel)
                    pixel = value;
            }
        }

        private struct Vertex
        {
            public Vector2D Pixel;

            /// <summary>z in the colour camera's space, 0: none.</summary>
            public float Depth;
        }
    }
}
