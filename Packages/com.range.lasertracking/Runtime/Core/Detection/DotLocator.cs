using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Measures a dot on the full-resolution frame. A centroid with a soft threshold of a fifth of the peak gives place and shape;
    /// where noise or speckle would hurt it, a centroid under a window of that shape, iterated to its fixed point, replaces it. The
    /// window's width follows from noise and speckle, the covariance from passing every pixel's noise through the estimate.
    /// </summary>
    internal sealed class DotLocator
    {
        private const double SoftThreshold = 0.2;

        /// <summary>Variance of a Gaussian through its variance above a fifth of its height: ∫(e^-u − t)du / ∫(e^-u − t)u du, t = 0.2.</summary>
        private const double ShapeGain = 2.18;

        /// <summary>What no amount of light removes: unequal pixels, compression. Standard deviation, px.</summary>
        private const double FloorPx = 0.03;

        /// <summary>Speckle of an ordinary laser as cameras encode it, and the number of pixels that this expectation is worth.</summary>
        private const double UsualSpeckle = 0.12, UsualSpeckleWeight = 4;

        /// <summary>The window must promise this much less error: real dots are lopsided, and the centre of all their light is what others call the dot's place.</summary>
        private const double MinGain = 0.7;

        private const int MaxSteps = 8;

        /// <summary>Farthest that light may lie from the middle of the pixels that rose, working px and share of their box.</summary>
        private const double MaxAwayPx = 1.5;
        private const double MaxAwayShare = 0.25;

        private readonly DotWindow _window = new DotWindow();
        private double _threshold, _sum, _x, _y, _xx, _xy, _yy;

        /// <summary>Fills position, covariance, peak, area and streak of the dot.</summary>
        public void Locate(Image image, in FrameView view, int factor, in Candidate candidate, double noise, ref Dot dot)
        {
            _window.Fill(image, view, factor, candidate, noise);
            dot.Peak = _window.PeakLevel;
            dot.AreaPx = SoftCentroid();
            var center = new Vector2D((candidate.CenterX + view.ShiftX + 0.5) * factor - 0.5, (candidate.CenterY + view.ShiftY + 0.5) * factor - 0.5);
            if (_sum <= 0)
            {
                dot.PositionPx = center;
                dot.CovariancePx = Covariance2D.Isotropic(factor);
                return;
            }

            var shape = new Covariance2D(ShapeGain * _xx + 0.05, ShapeGain * _xy, ShapeGain * _yy + 0.05);
            dot.ShapePx = new Covariance2D(_xx, _xy, _yy);
            Vector2D streak = DotStreak.From(dot.ShapePx, out bool isDistinct);
            if (isDistinct)
                dot.StreakPx = streak;
            Refine(shape, ref dot);
            KeepNear(center, factor * Math.Max(MaxAwayPx, MaxAwayShare * Math.Max(candidate.Right - candidate.Left + 1, candidate.Bottom - candidate.Top + 1)), ref dot);
        }

        /// <summary>On over-exposed backgrounds little of a dot is left to weigh: where that little leads away from what was found, the middle of the find holds.</summary>
        private static void KeepNear(Vector2D center, double maxAway, ref Dot dot)
        {
            double away = (dot.PositionPx - center).Length;
            if (away <= maxAway)
                return;
            dot.PositionPx = center;
            double variance = 0.25 * away * away;
            dot.CovariancePx = new Covariance2D(dot.CovariancePx.XX + variance, dot.CovariancePx.XY, dot.CovariancePx.YY + variance);
        }

        /// <summary>Centroid and moments of the light above the soft threshold, in window pixels. Gives the area at half of the peak.</summary>
        private int SoftCentroid()
        {
            _threshold = Math.Max(SoftThreshold * _window.Peak, Math.Min(0.5 * _window.Peak, 3 * _window.Noise));
            int area = 0;
            _sum = _x = _y = _xx = _xy = _yy = 0;
            for (int y = 0; y < _window.Height; y++)
            {
                for (int x = 0; x < _window.Width; x++)
                {
                    double light = _window.Light[y * _window.Width + x];
                    if (2 * light >= _window.Peak)
                        area++;
                    double weight = light - _threshold;
                    if (weight <= 0)
                        continue;
                    _sum += weight;
                    _x += weight * x;
                    _y += weight * y;
                    _xx += weight * x * x;
                    _xy += weight * x * y;
                    _yy += weight * y * y;
                }
            }

            if (_sum <= 0)
                return area;
            _x /= _sum;
            _y /= _sum;
            _xx = _xx / _sum - _x * _x;
            _xy = _xy / _sum - _x * _y;
            _yy = _yy / _sum - _y * _y;
            return area;
        }

        /// <summary>
        /// Iterates x ← x + (1 − V W⁻¹)⁻¹ (windowed centroid − x), V being the light's covariance under the window's slope: Newton's step for any
        /// symmetric profile. For a Gaussian and W equal to its shape this reaches the bound (SExtractor's windowed positions).
        /// </summary>
        private void Refine(in Covariance2D shape, ref Dot dot)
        {
            double noise = _window.Noise, height = Math.Max(noise, _window.Peak);
            double speckle = Speckle(shape);

            // Widest for which noise and speckle together cost least: u²(u − 2) = (speckle · height / noise)², window = (u − 1) shape.
            double ratio = speckle * height / noise, right = ratio * ratio, u = 2 + Math.Cbrt(right);
            for (int i = 0; i < 12; i++)
                u -= (u * u * (u - 2) - right) / (3 * u * u - 4 * u);
            double scale = Math.Min(8, u - 1);
            var window = new Covariance2D(scale * shape.XX, scale * shape.XY, scale * shape.YY);
            double x = _x, y = _y, reach = 0.5 + 0.5 * Math.Sqrt(Math.Max(shape.XX, shape.YY));
            var pass = new WindowedSums();
            for (int step = 0; step < MaxSteps; step++)
            {
                pass.Collect(_window, window, x, y, speckle);
                if (!pass.TryStep(window, out double dx, out double dy))
                    break;
                x += dx;
                y += dy;
                if (dx * dx + dy * dy < 1e-6)
                    break;
            }

            Covariance2D soft = SoftError(speckle);
            bool isSound = pass.IsSound && pass.ErrorCovariance.Sigma < MinGain * soft.Sigma && (x - _x) * (x - _x) + (y - _y) * (y - _y) <= reach * reach;
            dot.PositionPx = isSound ? new Vector2D(_window.Left + x, _window.Top + y) : new Vector2D(_window.Left + _x, _window.Top + _y);
            Covariance2D error = isSound ? pass.ErrorCovariance : soft;
            dot.CovariancePx = new Covariance2D(FloorPx * FloorPx + error.XX, error.XY, FloorPx * FloorPx + error.YY);
        }

        /// <summary>The soft centroid's covariance: each pixel's noise times its distance from the centre, through the light.</summary>
        private Covariance2D SoftError(double speckle)
        {
            double xx = 0, xy = 0, yy = 0, noise2 = _window.Noise * _window.Noise, scale = 1 / (_sum * _sum);
            for (int y = 0; y < _window.Height; y++)
            {
                for (int x = 0; x < _window.Width; x++)
                {
                    int i = y * _window.Width + x;
                    double light = _window.Light[i];
                    if (light < _threshold)
                        continue;
                    double variance = scale * (_window.Clipped[i] ? 0 : noise2 + speckle * speckle * light * light);
                    xx += variance * (x - _x) * (x - _x);
                    xy += variance * (x - _x) * (y - _y);
                    yy += variance * (y - _y) * (y - _y);
                }
            }

            return new Covariance2D(xx, xy, yy);
        }

        /// <summary>Standard deviation of the light about a Gaussian of this shape, through the light: grains, and what is no Gaussian.</summary>
        private double Speckle(in Covariance2D shape)
        {
            double determinant = shape.XX * shape.YY - shape.XY * shape.XY;
            double a = shape.YY / determinant, b = -2 * shape.XY / determinant, c = shape.XX / determinant;
            double sumModel = 0, sumLight = 0;
            for (int pass = 0; ; pass++)
            {
                double height = pass == 0 ? 1 : sumLight / sumModel, excess = UsualSpeckleWeight * UsualSpeckle * UsualSpeckle, count = UsualSpeckleWeight;
                for (int y = 0; y < _window.Height; y++)
                {
                    for (int x = 0; x < _window.Width; x++)
                    {
                        double dx = x - _x, dy = y - _y, distance = a * dx * dx + b * dx * dy + c * dy * dy;
                        if (distance > 3 || _window.Clipped[y * _window.Width + x])
                            continue;
                        double near = 1 - distance / 9, model = near * near * near * near, light = _window.Light[y * _window.Width + x];
                        if (pass == 0)
                        {
                            sumModel += model * model;
                            sumLight += model * light;
                            continue;
                        }

                        double off = light - height * model;
                        excess += (off * off - _window.Noise * _window.Noise) / (height * height * model * model);
                        count++;
                    }
                }

                if (sumModel <= 0 || sumLight <= 0)
                    return UsualSpeckle;
                if (pass == 1)
                    return Math.Sqrt(Math.Max(0, Math.Min(1, excess / count)));
            }
        }
    }
}
