using System;
using LaserTracking.Geometry;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Measures a dot on the full-resolution frame: centroid of the light above its background with a soft threshold of a fifth of
    /// the peak, which survives saturation; its covariance from noise through amplitude; the streak from the light's second moments.
    /// </summary>
    internal sealed unsafe class DotLocator
    {
        private const int MaxSide = 160;
        private const double SoftThreshold = 0.2;

        /// <summary>What no amount of light removes: pixel response, speckle, compression. Standard deviation, px.</summary>
        private const double FloorPx = 0.05;

        private readonly uint[] _row = new uint[MaxSide];
        private readonly int[] _light = new int[MaxSide * MaxSide];
        private readonly int[] _histogram = new int[2048];

        /// <summary>Fills position, covariance, peak, area and streak of the dot.</summary>
        public void Locate(Image image, in FrameView view, int factor, in Candidate candidate, double noise, ref Dot dot)
        {
            int margin = 3 + (Math.Max(candidate.Right - candidate.Left, candidate.Bottom - candidate.Top) + 1) / 2;
            int left = candidate.Left + view.ShiftX, right = candidate.Right + view.ShiftX;
            int top = candidate.Top + view.ShiftY, bottom = candidate.Bottom + view.ShiftY;
            int x0 = Math.Max(0, (left - margin) * factor), x1 = Math.Min(image.Width, (right + 1 + margin) * factor);
            int y0 = Math.Max(0, (top - margin) * factor), y1 = Math.Min(image.Height, (bottom + 1 + margin) * factor);
            x1 = Math.Min(x1, x0 + MaxSide);
            y1 = Math.Min(y1, y0 + MaxSide);
            int width = x1 - x0, height = y1 - y0;
            int peakLevel = 0;
            fixed (uint* row = _row)
            {
                for (int y = 0; y < height; y++)
                {
                    PixelRow.ToBgra(image, y0 + y, x0, x1, row);
                    int row0 = Math.Max(0, Math.Min(view.Height - 1, (y0 + y) / factor - view.ShiftY)) * view.Width;
                    for (int x = 0; x < width; x++)
                    {
                        uint pixel = row[x];
                        peakLevel = Math.Max(peakLevel, FrameView.Level(pixel, DetectionPlane.Largest));
                        int light = FrameView.Level(pixel, candidate.Plane);
                        if (candidate.IsAboveContent)
                            light = Math.Max(0, light - candidate.ContentLevel);
                        else if (candidate.IsAboveExpected || candidate.IsOnset)
                            light -= FrameView.Level(view.Before[row0 + Math.Max(0, Math.Min(view.Width - 1, (x0 + x) / factor - view.ShiftX))], candidate.Plane);
                        _light[y * width + x] = candidate.IsAboveExpected ? Math.Max(0, light) : light;
                    }
                }
            }

            int background = BorderMedian(width, height);
            int peak = 0;
            int coreLeft = left * factor - x0, coreRight = (right + 1) * factor - x0;
            int coreTop = top * factor - y0, coreBottom = (bottom + 1) * factor - y0;
            for (int y = Math.Max(0, coreTop); y < Math.Min(height, coreBottom); y++)
            {
                for (int x = Math.Max(0, coreLeft); x < Math.Min(width, coreRight); x++)
                    peak = Math.Max(peak, _light[y * width + x] - background);
            }

            dot.Peak = peakLevel;
            Moments(width, height, background, peak, x0, y0, noise, view, candidate, factor, ref dot);
        }

        private void Moments(int width, int height, int background, int peak, int x0, int y0, double noise, in FrameView view, in Candidate candidate, int factor, ref Dot dot)
        {
            double threshold = SoftThreshold * peak, sum = 0, sumX = 0, sumY = 0, sumXX = 0, sumYY = 0, sumXY = 0;
            int area = 0;
            for (int y = 0; y < height; y++)
            {
                for (int x = 0; x < width; x++)
                {
                    int light = _light[y * width + x] - background;
                    if (2 * light >= peak)
                        area++;
                    double weight = light - threshold;
                    if (weight <= 0)
                        continue;
                    sum += weight;
                    sumX += weight * x;
                    sumY += weight * y;
                    sumXX += weight * x * x;
                    sumYY += weight * y * y;
                    sumXY += weight * x * y;
                }
            }

            dot.AreaPx = area;
            if (sum <= 0)
            {
                dot.PositionPx = new Vector2D((candidate.CenterX + view.ShiftX + 0.5) * factor - 0.5, (candidate.CenterY + view.ShiftY + 0.5) * factor - 0.5);
                dot.CovariancePx = Covariance2D.Isotropic(factor);
                return;
            }

            double cx = sumX / sum, cy = sumY / sum;
            double xx = sumXX / sum - cx * cx, yy = sumYY / sum - cy * cy, xy = sumXY / sum - cx * cy;
            dot.PositionPx = new Vector2D(x0 + cx, y0 + cy);

            // Noise enters by the pixels' leverage; half as much again for what the model leaves out.
            double perPixel = noise * 1.5;
            double leverage = perPixel * perPixel * area / (sum * sum);
            dot.CovariancePx = new Covariance2D(FloorPx * FloorPx + leverage * xx, leverage * xy, FloorPx * FloorPx + leverage * yy);
            double mean = (xx + yy) / 2, spread = Math.Sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
            double shortVariance = Math.Max(0, mean - spread), longVariance = mean + spread;
            if (longVariance > 4 * shortVariance && longVariance - shortVariance > 2)
            {
                // A moving dot smears over a line of uniform light: length² / 12 is what it adds to the variance.
                double length = Math.Sqrt(12 * (longVariance - shortVariance));
                double angle = 0.5 * Math.Atan2(2 * xy, xx - yy);
                dot.StreakPx = new Vector2D(length * Math.Cos(angle), length * Math.Sin(angle));
            }
        }

        /// <summary>Median of the window's outermost pixels: what is left of the background there.</summary>
        private int BorderMedian(int width, int height)
        {
            Array.Clear(_histogram, 0, _histogram.Length);
            int count = 0;
            for (int y = 0; y < height; y++)
            {
                int step = y == 0 || y == height - 1 ? 1 : Math.Max(1, width - 1);
                for (int x = 0; x < width; x += step)
                {
                    _histogram[_light[y * width + x] + 1024]++;
                    count++;
                }
            }

            int bin = 0;
            for (int below = 0; bin < _histogram.Length - 1; bin++)
            {
                below += _histogram[bin];
                if (2 * below >= count)
                    break;
            }

            return bin - 1024;
        }
    }
}
