using System;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>
    /// Whether the Sensor SDK finds a ray for a pixel. It searches in single precision (reference: its published equations, start and
    /// stopping rule) and refuses what it misses by a thousandth of a pixel: at the edge of large pictures that leaves out pixels that
    /// do have a ray. Every operation rounds to float, in the SDK's order. Immutable, allocates nothing.
    /// </summary>
    internal sealed class KinectLensCheck
    {
        private const int MaxPasses = 20;
        private const float LargestError = 1e-6f;
        private const float LeastError = 1e-22f;
        private readonly float _cx, _cy, _fx, _fy, _k1, _k2, _k3, _k4, _k5, _k6, _codx, _cody, _p2, _p1, _radius, _cross;

        /// <param name="parameters">cx, cy, fx, fy in px; k1 to k6; centre of distortion; p2, p1: the SDK's order.</param>
        /// <param name="radius">Metric radius.</param>
        /// <param name="cross">Factor of the mixed tangential terms.</param>
        public KinectLensCheck(ReadOnlySpan<double> parameters, double radius, double cross)
        {
            _cx = (float)parameters[0];
            _cy = (float)parameters[1];
            _fx = (float)parameters[2];
            _fy = (float)parameters[3];
            _k1 = (float)parameters[4];
            _k2 = (float)parameters[5];
            _k3 = (float)parameters[6];
            _k4 = (float)parameters[7];
            _k5 = (float)parameters[8];
            _k6 = (float)parameters[9];
            _codx = (float)parameters[10];
            _cody = (float)parameters[11];
            _p2 = (float)parameters[12];
            _p1 = (float)parameters[13];
            _radius = (float)radius;
            _cross = (float)cross;
        }

        public bool HasRay(double xPx, double yPx)
        {
            float u = (float)xPx, v = (float)yPx;
            float x = (u - _cx) / _fx - _codx, y = (v - _cy) / _fy - _cody;
            Radial(x * x + y * y, out float above, out float below);
            float scale = (above != 0 ? 1 / above : 1) * below;
            x *= scale;
            y *= scale;
            float mixed = 2 * x * y, xx = x * x, yy = y * y;
            x -= (yy + 3 * xx) * _p2 + mixed * _p1;
            y -= (xx + 3 * yy) * _p1 + mixed * _p2;
            x += _codx;
            y += _cody;

            float best = float.MaxValue;
            for (int pass = 0; pass < MaxPasses; pass++)
            {
                if (!TryProject(x, y, out float px, out float py, out float j0, out float j1, out float j2, out float j3))
                    return false;
                float ex = u - px, ey = v - py, error = ex * ex + ey * ey;
                if (!(error < best))
                    break;
                best = error;
                if (best < LeastError)
                    break;
                float inverse = 1 / (j0 * j3 - j1 * j2);
                x += inverse * j3 * ex + -inverse * j1 * ey;
                y += -inverse * j2 * ex + inverse * j0 * ey;
            }

            return best <= LargestError;
        }

        private void Radial(float rs, out float above, out float below)
        {
            float rss = rs * rs, rsc = rss * rs;
            above = 1 + _k1 * rs + _k2 * rss + _k3 * rsc;
            below = 1 + _k4 * rs + _k5 * rss + _k6 * rsc;
        }

        private bool TryProject(float x, float y, out float u, out float v, out float j0, out float j1, out float j2, out float j3)
        {
            x -= _codx;
            y -= _cody;
            float xx = x * x, yy = y * y, xy = x * y, rs = xx + yy, rss = rs * rs;
            Radial(rs, out float above, out float below);
            float inverse = below != 0 ? 1 / below : 1, d = above * inverse;
            u = (x * d + ((rs + 2 * xx) * _p2 + _cross * xy * _p1) + _codx) * _fx + _cx;
            v = (y * d + ((rs + 2 * yy) * _p1 + _cross * xy * _p2) + _cody) * _fy + _cy;
            float aboveSlope = _k1 + 2 * _k2 * rs + 3 * _k3 * rss, belowSlope = _k4 + 2 * _k5 * rs + 3 * _k6 * rss;
            float slope2 = (aboveSlope * below - above * belowSlope) * (inverse * inverse) * 2, xSlope = x * slope2, xySlope = y * xSlope;
            j0 = _fx * (d + x * xSlope + 6 * x * _p2 + _cross * y * _p1);
            j1 = _fx * (xySlope + 2 * y * _p2 + _cross * x * _p1);
            j2 = _fy * (xySlope + 2 * x * _p1 + _cross * y * _p2);
            j3 = _fy * (d + y * y * slope2 + 6 * y * _p1 + _cross * x * _p2);
            return !(rs > _radius * _radius);
        }
    }
}
