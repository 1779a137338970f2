using System;
using System.Numerics;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>A target painted once at about the projector's resolution, then drawn at every place it moves to. Immutable.</summary>
    internal sealed unsafe class TargetSprite
    {
        private readonly Vector4[] _texels;
        private readonly int _width, _height;
        private readonly PlaneMap _planeToTexel;
        private readonly double _left, _top, _right, _bottom;

        /// <param name="painter">What to paint.</param>
        /// <param name="texelM">Size of a texel in the target's plane.</param>
        public TargetSprite(TargetPainter painter, double texelM)
        {
            painter.Bounds(out double halfWidth, out _top, out _bottom);
            _left = -halfWidth;
            _right = halfWidth;
            _width = (int)Math.Ceiling(2 * halfWidth / texelM) + 2;
            _height = (int)Math.Ceiling((_top - _bottom) / texelM) + 2;
            _texels = new Vector4[_width * _height];
            _planeToTexel = new PlaneMap(1 / texelM, 0, -_left / texelM, 0, -1 / texelM, _top / texelM, 0, 0, 1);
            // The outermost texels stay transparent, so that sampling fades out at the border.
            for (int y = 1; y < _height - 1; y++)
            for (int x = 1; x < _width - 1; x++)
                _texels[y * _width + x] = painter.Paint(new Vector2D(_left + x * texelM, _top - y * texelM), texelM);
        }

        /// <summary>Pixels that the sprite can touch under a mapping of its plane to the picture.</summary>
        public PixelRect Bounds(in PlaneMap planeToPicture)
        {
            double left = double.PositiveInfinity, top = left, right = double.NegativeInfinity, bottom = right;
            for (int corner = 0; corner < 4; corner++)
            {
                Vector2D p = planeToPicture.Map(new Vector2D(corner % 2 == 0 ? _left : _right, corner / 2 == 0 ? _top : _bottom));
                left = Math.Min(left, p.X);
                right = Math.Max(right, p.X);
                top = Math.Min(top, p.Y);
                bottom = Math.Max(bottom, p.Y);
            }

            return new PixelRect((int)Math.Floor(left) - 1, (int)Math.Floor(top) - 1, (int)Math.Ceiling(right) + 2, (int)Math.Ceiling(bottom) + 2);
        }

        /// <summary>Draws over the pixels of a rectangle of a BGRA picture.</summary>
        public void Draw(in PlaneMap planeToPicture, byte* pixels, int stride, PixelRect rect)
        {
            PlaneMap map = _planeToTexel * planeToPicture.Inverse;
            fixed (Vector4* texels = _texels)
            {
                for (int y = rect.Top; y < rect.Bottom; y++)
                {
                    byte* pixel = pixels + (long)y * stride + rect.Left * 4;
                    for (int x = rect.Left; x < rect.Right; x++, pixel += 4)
                    {
                        double w = 1 / (map.G * x + map.H * y + map.I);
                        float u = (float)((map.A * x + map.B * y + map.C) * w), v = (float)((map.D * x + map.E * y + map.F) * w);
                        if (!(u >= 0 && v >= 0 && u < _width - 1 && v < _height - 1))
                            continue;
                        int iu = (int)u, iv = (int)v;
                        Vector4* texel = texels + iv * _width + iu;
                        float fu = u - iu, fv = v - iv;
                        Vector4 upper = texel[0] + (texel[1] - texel[0]) * fu;
                        Vector4 lower = texel[_width] + (texel[_width + 1] - texel[_width]) * fu;
                        Vector4 color = upper + (lower - upper) * fv;
                        float rest = 1 - color.W;
                        pixel[0] = (byte)(int)(color.X + pixel[0] * rest + 0.5f);
                        pixel[1] = (byte)(int)(color.Y + pixel[1] * rest + 0.5f);
                        pixel[2] = (byte)(int)(color.Z + pixel[2] * rest + 0.5f);
                    }
                }
            }
        }
    }
}
