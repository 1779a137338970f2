using System;
using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Sums of a dot's light under a bell-shaped window: the centroid's step and, by error propagation, its covariance. The bell
    /// (1 − q/9)⁴, q the squared distance in the window's deviations, is close to exp(−q/2) and the same to the bit on every machine.
    /// </summary>
    internal struct WindowedSums
    {
        private double _sum, _x, _y, _slopeXX, _slopeXY, _slopeYY, _errorXX, _errorXY, _errorYY;
        private double _inverseXX, _inverseXY, _inverseYX, _inverseYY;

        /// <summary>The last step could be made.</summary>
        public bool IsSound { get; private set; }

        /// <summary>Covariance of the centroid at the fixed point, px².</summary>
        public Covariance2D ErrorCovariance { get; private set; }

        /// <summary>Sums over the pixels within three of the window's deviations of (x, y).</summary>
        public void Collect(DotWindow dot, in Covariance2D window, double x, double y, double speckle)
        {
            double determinant = window.XX * window.YY - window.XY * window.XY;
            double a = window.YY / determinant, b = -2 * window.XY / determinant, c = window.XX / determinant;
            double noise2 = dot.Noise * dot.Noise, speckle2 = speckle * speckle;
            _sum = _x = _y = _slopeXX = _slopeXY = _slopeYY = _errorXX = _errorXY = _errorYY = 0;
            int reachX = (int)(3 * Math.Sqrt(window.XX)) + 1, reachY = (int)(3 * Math.Sqrt(window.YY)) + 1;
            for (int py = Math.Max(0, (int)y - reachY); py <= Math.Min(dot.Height - 1, (int)y + reachY); py++)
            {
                double dy = py - y;
                for (int px = Math.Max(0, (int)x - reachX); px <= Math.Min(dot.Width - 1, (int)x + reachX); px++)
                {
                    double dx = px - x, distance = a * dx * dx + b * dx * dy + c * dy * dy;
                    if (distance >= 9)
                        continue;
                    double near = 1 - distance / 9, weight = near * near * near * near, light = dot.Light[py * dot.Width + px], part = weight * light;
                    _sum += part;
                    _x += part * dx;
                    _y += part * dy;

                    // The weight's derivative is −8/9 (1 − q/9)³ times the distance through the window's variance.
                    double slope = 8.0 / 9 * near * near * near * light;
                    _slopeXX += slope * dx * dx;
                    _slopeXY += slope * dx * dy;
                    _slopeYY += slope * dy * dy;
                    double variance = weight * weight * (noise2 + (dot.Clipped[py * dot.Width + px] ? 0 : speckle2 * light * light));
                    _errorXX += variance * dx * dx;
                    _errorXY += variance * dx * dy;
                    _errorYY += variance * dy * dy;
                }
            }
        }

        /// <summary>Newton's step from the place of the sums towards the fixed point. False: the light has no centre here.</summary>
        public bool TryStep(in Covariance2D window, out double dx, out double dy)
        {
            dx = dy = 0;
            IsSound = false;
            if (!(_sum > 0))
                return false;
            double x = _x / _sum, y = _y / _sum, xx = _slopeXX / _sum, xy = _slopeXY / _sum, yy = _slopeYY / _sum;

            // How the windowed centroid follows the dot, 1 − V W⁻¹, and the inverse.
            double determinant = window.XX * window.YY - window.XY * window.XY;
            double wxx = window.YY / determinant, wxy = -window.XY / determinant, wyy = window.XX / determinant;
            double a = 1 - (xx * wxx + xy * wxy), b = -(xx * wxy + xy * wyy), c = -(xy * wxx + yy * wxy), d = 1 - (xy * wxy + yy * wyy);
            double gain = a * d - b * c;
            if (!(gain > 0.02))
                return false;
            _inverseXX = d / gain;
            _inverseXY = -b / gain;
            _inverseYX = -c / gain;
            _inverseYY = a / gain;
            dx = _inverseXX * x + _inverseXY * y;
            dy = _inverseYX * x + _inverseYY * y;
            double scale = 1 / (_sum * _sum);
            ErrorCovariance = new Covariance2D(scale * _errorXX, scale * _errorXY, scale * _errorYY).Transform(_inverseXX, _inverseXY, _inverseYX, _inverseYY);
            IsSound = true;
            return true;
        }
    }
}
