using System;
using System.Numerics;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>
    /// Where a camera without distortion would see what camera 0 sees in each pixel. Computed on every fourth pixel and interpolated:
    /// a thousandth of a pixel from the exact place.
    /// </summary>
    internal sealed class LensMap
    {
        private const int Step = 4;
        private readonly Vector2[] _nodes;
        private readonly int _columns;

        /// <param name="lens">Of the camera.</param>
        /// <param name="shiftPx">How far the whole picture is displaced.</param>
        public LensMap(LensCamera lens, Vector2D shiftPx)
        {
            PinholeCamera pinhole = lens.Pinhole;
            _columns = pinhole.Width / Step + 2;
            int rows = pinhole.Height / Step + 2;
            _nodes = new Vector2[_columns * rows];
            for (int i = 0; i < _nodes.Length; i++)
            {
                var px = new Vector2D(i % _columns * Step, i / _columns * Step);
                if (!lens.TryUnproject(px - shiftPx, out Vector2D ray))
                    throw new ArgumentException("color_camera's lens folds the picture; correct lens_k1 or lens_k2");
                _nodes[i] = new Vector2((float)(ray.X * pinhole.FocalXPx + pinhole.CenterXPx), (float)(ray.Y * pinhole.FocalYPx + pinhole.CenterYPx));
            }
        }

        public Vector2 At(float x, float y)
        {
            float u = Math.Max(0, x) / Step, v = Math.Max(0, y) / Step;
            int left = Math.Min((int)u, _columns - 2), top = Math.Min((int)v, _nodes.Length / _columns - 2), at = top * _columns + left;
            Vector2 above = Vector2.Lerp(_nodes[at], _nodes[at + 1], u - left), below = Vector2.Lerp(_nodes[at + _columns], _nodes[at + _columns + 1], u - left);
            return Vector2.Lerp(above, below, v - top);
        }
    }
}
