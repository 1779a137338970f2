using System;
using System.Numerics;
using LaserTracking.Imaging;

namespace LaserTracking.Simulation
{
    /// <summary>The projector's picture as linear light, with a dark border one pixel wide, ready to be sampled through a warp.</summary>
    internal sealed unsafe class ProjectorRaster
    {
        private readonly Vector4[] _light;
        private readonly float[] _toLinear = new float[256];
        private readonly int _width, _height, _stride;

        public ProjectorRaster(int width, int height, ProjectorSettings projector)
        {
            _width = width;
            _height = height;
            _stride = width + 2;
            _light = new Vector4[_stride * (height + 2)];
            for (int i = 0; i < 256; i++)
                _toLinear[i] = (float)(projector.BlackLevel + (1 - projector.BlackLevel) * Math.Pow(i / 255.0, projector.Gamma));
        }

        /// <summary>Takes over the changed parts of the picture.</summary>
        public void Update(Image picture, ReadOnlySpan<PixelRect> changed)
        {
            fixed (float* linear = _toLinear)
            fixed (Vector4* light = _light)
            {
                foreach (PixelRect rect in changed)
                {
                    for (int y = rect.Top; y < rect.Bottom; y++)
                    {
                        byte* pixel = picture.Pixels + (long)y * picture.Stride + rect.Left * 4;
                        int index = (y + 1) * _stride + rect.Left + 1;
                        for (int x = rect.Left; x < rect.Right; x++, pixel += 4)
                            light[index++] = new Vector4(linear[pixel[0]], linear[pixel[1]], linear[pixel[2]], 0);
                    }
                }
            }
        }

        /// <summary>Adds a row of the camera's view, sampled bilinearly (several times a pixel where the camera is the coarser one).</summary>
        public void AddRow(in PlaneMap imageToPicture, int y, int left, int right, float weight, Span<Vector4> row)
        {
            imageToPicture.Jacobian(new Geometry.Vector2D((left + right) / 2.0, y), out double a, out double b, out double c, out double d);
            int times = Math.Max(1, Math.Min(6, (int)Math.Round(Math.Sqrt(Math.Abs(a * d - b * c)))));
            float share = weight / (times * times);
            for (int i = 0; i < times; i++)
            for (int j = 0; j < times; j++)
                AddRow(imageToPicture, y + (i + 0.5) / times - 0.5, (j + 0.5) / times - 0.5, left, right, share, row);
        }

        /// <summary>The same for a camera with a lens: where each pixel would lie without it, then the warp.</summary>
        public void AddRow(in PlaneMap idealToPicture, LensMap lens, int y, int left, int right, float weight, Span<Vector4> row)
        {
            idealToPicture.Jacobian(new Geometry.Vector2D((left + right) / 2.0, y), out double a, out double b, out double c, out double d);
            int times = Math.Max(1, Math.Min(6, (int)Math.Round(Math.Sqrt(Math.Abs(a * d - b * c)))));
            float share = weight / (times * times);
            for (int i = 0; i < times * times; i++)
            {
                float offsetX = (i % times + 0.5f) / times - 0.5f, offsetY = (i / times + 0.5f) / times - 0.5f;
                for (int x = left; x < right; x++)
                {
                    Vector2 ideal = lens.At(x, y);
                    Geometry.Vector2D p = idealToPicture.Map(new Geometry.Vector2D(ideal.X + offsetX, ideal.Y + offsetY));
                    row[x] += At((float)p.X + 1, (float)p.Y + 1) * share;
                }
            }
        }

        private Vector4 At(float u, float v)
        {
            if (!(u >= 0 && v >= 0 && u < _width + 1 && v < _height + 1))
                return default;
            int left = (int)u, at = (int)v * _stride + left;
            Vector4 upper = Vector4.Lerp(_light[at], _light[at + 1], u - left), lower = Vector4.Lerp(_light[at + _stride], _light[at + _stride + 1], u - left);
            return Vector4.Lerp(upper, lower, v - (int)v);
        }

        private void AddRow(in PlaneMap map, double y, double offsetX, int left, int right, float weight, Span<Vector4> row)
        {
            double u = map.B * y + map.C, v = map.E * y + map.F, w = map.H * y + map.I;
            float widest = _width + 1, highest = _height + 1;
            fixed (Vector4* light = _light, target = row)
            {
                for (int x = left; x < right; x++)
                {
                    double px = x + offsetX, scale = 1 / (map.G * px + w);
                    float fu = (float)((map.A * px + u) * scale) + 1, fv = (float)((map.D * px + v) * scale) + 1;
                    if (!(fu >= 0 && fv >= 0 && fu < widest && fv < highest))
                        continue;
                    int iu = (int)fu, iv = (int)fv;
                    Vector4* p = light + iv * _stride + iu;
                    fu -= iu;
                    fv -= iv;
                    Vector4 upper = p[0] + (p[1] - p[0]) * fu;
                    Vector4 lower = p[_stride] + (p[_stride + 1] - p[_stride]) * fu;
                    target[x] += (upper + (lower - upper) * fv) * weight;
                }
            }
        }
    }
}
