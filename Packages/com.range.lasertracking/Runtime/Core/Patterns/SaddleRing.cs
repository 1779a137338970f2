using System;
using LaserTracking.Geometry;

namespace LaserTracking.Patterns
{
    /// <summary>Looks at one place of a smoothed picture: where it is level, and how brightness runs around it.</summary>
    internal sealed unsafe class SaddleRing
    {
        /// <summary>Least distance of a point from the border.</summary>
        public const int Margin = Radius + 2;

        private const int Radius = 5;
        private const int Half = 16;
        private const int Steps = 8;
        private const double LeastSector = Math.PI / 14;

        private readonly double[] _cosine = new double[2 * Half];
        private readonly double[] _sine = new double[2 * Half];
        private readonly double[] _even = new double[Half + 1];
        private ushort* _smooth;
        private int _width, _height;

        public SaddleRing()
        {
            for (int i = 0; i < 2 * Half; i++)
            {
                _cosine[i] = Math.Cos(i * Math.PI / Half);
                _sine[i] = Math.Sin(i * Math.PI / Half);
            }
        }

        /// <summary>The picture for the next calls; the caller keeps it fixed.</summary>
        public void Use(ushort* smooth, int width, int height)
        {
            _smooth = smooth;
            _width = width;
            _height = height;
        }

        /// <summary>Newton's steps to the stationary point of a saddle; false when there is none within reach of the start.</summary>
        public bool TrySettle(Vector2D start, double reachPx, out Vector2D at)
        {
            at = start;
            for (int step = 0; step < Steps; step++)
            {
                if (!IsInside(at))
                    return false;
                double center = Sample(at.X, at.Y);
                double left = Sample(at.X - 1, at.Y), right = Sample(at.X + 1, at.Y), above = Sample(at.X, at.Y - 1), below = Sample(at.X, at.Y + 1);
                double xx = left + right - 2 * center, yy = above + below - 2 * center;
                double xy = (Sample(at.X - 1, at.Y - 1) + Sample(at.X + 1, at.Y + 1) - Sample(at.X + 1, at.Y - 1) - Sample(at.X - 1, at.Y + 1)) / 4;
                double determinant = xx * yy - xy * xy;
                if (!(determinant < 0))
                    return false;
                double gx = (right - left) / 2, gy = (below - above) / 2;
                var move = new Vector2D((xy * gy - yy * gx) / determinant, (xy * gx - xx * gy) / determinant);
                if (move.Length > 1)
                    move *= 1 / move.Length;
                at += move;
                if ((at - start).Length > reachPx)
                    return false;
                if (move.LengthSquared < 1e-4)
                    return IsInside(at);
            }

            return false;
        }

        /// <summary>Edges, contrast and symmetry around a place; false where the ring does not go light, dark, light, dark.</summary>
        public bool TryMeasure(Vector2D at, out SaddlePoint point)
        {
            point = default;
            double mean = 0, odd = 0;
            for (int i = 0; i < Half; i++)
            {
                double here = Sample(at.X + Radius * _cosine[i], at.Y + Radius * _sine[i]);
                double opposite = Sample(at.X - Radius * _cosine[i], at.Y - Radius * _sine[i]);
                _even[i] = (here + opposite) / 2;
                odd += (here - opposite) * (here - opposite) / 4;
                mean += _even[i];
            }

            mean /= Half;
            _even[Half] = _even[0];
            double even = 0, lowest = double.MaxValue, highest = 0;
            for (int i = 0; i < Half; i++)
            {
                even += (_even[i] - mean) * (_even[i] - mean);
                lowest = Math.Min(lowest, _even[i]);
                highest = Math.Max(highest, _even[i]);
            }

            if (!(even > 0) || !TryFindEdges((lowest + highest) / 2, out double angleA, out double angleB, out double contrast))
                return false;
            point = new SaddlePoint(
                at,
                new Vector2D(Math.Cos(angleA), Math.Sin(angleA)),
                new Vector2D(Math.Cos(angleB), Math.Sin(angleB)),
                contrast / SaddleKernel.Scale,
                even / (even + odd));
            return true;
        }

        /// <summary>Where the half ring falls through a level (A) and where it rises through it again (B), each exactly once.</summary>
        private bool TryFindEdges(double middle, out double angleA, out double angleB, out double contrast)
        {
            angleA = angleB = contrast = 0;
            int falls = 0, rises = 0, lights = 0;
            double light = 0, dark = 0;
            for (int i = 0; i < Half; i++)
            {
                double here = _even[i] - middle, next = _even[i + 1] - middle;
                if (here > 0)
                {
                    light += here;
                    lights++;
                }
                else
                {
                    dark -= here;
                }

                if (here > 0 == next > 0)
                    continue;
                double angle = (i + here / (here - next)) * Math.PI / Half;
                if (here > 0)
                {
                    angleA = angle;
                    falls++;
                }
                else
                {
                    angleB = angle;
                    rises++;
                }
            }

            if (falls != 1 || rises != 1)
                return false;
            if (angleB < angleA)
                angleB += Math.PI;
            contrast = light / lights + dark / (Half - lights);
            return angleB - angleA > LeastSector && angleB - angleA < Math.PI - LeastSector;
        }

        /// <summary>Smoothed level between pixels; the place is at least one pixel inside.</summary>
        public double Sample(double x, double y)
        {
            int left = (int)x, top = (int)y;
            double fx = x - left, fy = y - top;
            ushort* p = _smooth + top * _width + left;
            double above = p[0] + fx * (p[1] - p[0]), below = p[_width] + fx * (p[_width + 1] - p[_width]);
            return above + fy * (below - above);
        }

        public bool IsInside(Vector2D at) => at.X >= Margin - 1 && at.Y >= Margin - 1 && at.X <= _width - Margin && at.Y <= _height - Margin;
    }
}
