using System;
using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>
    /// A small square of light values, infrared counts or colour levels, and the measuring of a spot in it: the same measure for both
    /// pictures. Room is fixed; not thread-safe.
    /// </summary>
    internal sealed class SpotWindow
    {
        public const int MaxRadius = 40;
        private const int MaxSide = 2 * MaxRadius + 1;
        private const double SoftThreshold = 0.2;
        private const int CoreReach = 4;

        /// <summary>What no amount of light removes: pixel response, speckle. Standard deviation, px.</summary>
        private const double FloorPx = 0.05;

        private readonly int[] _border = new int[4 * MaxSide];
        private readonly int[] _borderIndex = new int[4 * MaxSide];
        private readonly int[] _stack = new int[MaxSide * MaxSide];
        private readonly bool[] _isInside = new bool[MaxSide * MaxSide];

        /// <summary>Row by row, <see cref="Width"/> a row.</summary>
        public int[] Light { get; } = new int[MaxSide * MaxSide];

        public int Left { get; private set; }

        public int Top { get; private set; }

        public int Width { get; private set; }

        public int Height { get; private set; }

        /// <summary>Lays the window around a pixel; false when nothing of it lies in the picture.</summary>
        public bool Place(int x, int y, int radius, int imageWidth, int imageHeight)
        {
            radius = Math.Min(radius, MaxRadius);
            Left = Math.Max(0, x - radius);
            Top = Math.Max(0, y - radius);
            Width = Math.Min(imageWidth, x + radius + 1) - Left;
            Height = Math.Min(imageHeight, y + radius + 1) - Top;
            return Width > 0 && Height > 0;
        }

        /// <summary>Median and spread (from the quartiles) of one channel of the window's outermost pixels (B G R A, laid out like the window).</summary>
        public int Background(uint[] pixels, int channel, out double sigma)
        {
            int count = BorderCount();
            for (int i = 0; i < count; i++)
                _border[i] = (int)(pixels[_borderIndex[i]] >> (8 * channel) & 255);
            return Median(count, out sigma);
        }

        /// <summary>The same of the light.</summary>
        private int Background(out double sigma)
        {
            int count = BorderCount();
            for (int i = 0; i < count; i++)
                _border[i] = Light[_borderIndex[i]];
            return Median(count, out sigma);
        }

        private int BorderCount()
        {
            int count = 0;
            for (int y = 0; y < Height; y++)
            {
                int step = y == 0 || y == Height - 1 ? 1 : Math.Max(1, Width - 1);
                for (int x = 0; x < Width; x += step)
                    _borderIndex[count++] = y * Width + x;
            }

            return count;
        }

        private int Median(int count, out double sigma)
        {
            Array.Sort(_border, 0, count);
            sigma = (_border[3 * count / 4] - _border[count / 4]) / 1.349;
            return _border[count / 2];
        }

        /// <summary>The brightest pixel within a distance of a point (both in the picture's pixels), as an index into the window.</summary>
        public int Brightest(Vector2D around, double reach)
        {
            int best = -1;
            int x0 = Math.Max(0, (int)(around.X - reach) - Left), x1 = Math.Min(Width - 1, (int)(around.X + reach) + 1 - Left);
            int y0 = Math.Max(0, (int)(around.Y - reach) - Top), y1 = Math.Min(Height - 1, (int)(around.Y + reach) + 1 - Top);
            for (int y = y0; y <= y1; y++)
            {
                for (int x = x0; x <= x1; x++)
                {
                    double dx = Left + x - around.X, dy = Top + y - around.Y;
                    int i = y * Width + x;
                    if (dx * dx + dy * dy <= reach * reach && (best < 0 || Light[i] > Light[best]))
                        best = i;
                }
            }

            return best;
        }

        /// <summary>Measures the spot that has this pixel as its brightest.</summary>
        public Spot Measure(int peak)
        {
            var spot = new Spot { Background = Background(out double sigma), Sigma = sigma };
            spot.Rise = Light[peak] - spot.Background;
            if (spot.Rise <= 0)
            {
                spot.PositionPx = new Vector2D(Left + peak % Width, Top + peak / Width);
                return spot;
            }

            Grow(peak, ref spot);
            Core(peak, ref spot);
            Moments(ref spot);
            spot.RingShare = RingShare(spot);
            return spot;
        }

        private void Grow(int peak, ref Spot spot)
        {
            Array.Clear(_isInside, 0, Width * Height);
            int half = spot.Background + (spot.Rise + 1) / 2, count = 0;
            spot.Left = spot.Right = peak % Width;
            spot.Top = spot.Bottom = peak / Width;
            double sumX = 0, sumY = 0, sumXX = 0, sumYY = 0, sumXY = 0;
            _stack[count++] = peak;
            _isInside[peak] = true;
            while (count > 0)
            {
                int i = _stack[--count], x = i % Width, y = i / Width;
                spot.Area++;
                sumX += x;
                sumY += y;
                sumXX += x * x;
                sumYY += y * y;
                sumXY += x * y;
                spot.Left = Math.Min(spot.Left, x);
                spot.Right = Math.Max(spot.Right, x);
                spot.Top = Math.Min(spot.Top, y);
                spot.Bottom = Math.Max(spot.Bottom, y);
                spot.IsCut |= x == 0 || y == 0 || x == Width - 1 || y == Height - 1;
                count = x > 0 ? Push(i - 1, half, count) : count;
                count = x < Width - 1 ? Push(i + 1, half, count) : count;
                count = y > 0 ? Push(i - Width, half, count) : count;
                count = y < Height - 1 ? Push(i + Width, half, count) : count;
            }

            // A pixel's own extent is a twelfth along each axis: a single pixel is round.
            double n = spot.Area, xx = sumXX / n - sumX / n * (sumX / n) + 1 / 12.0, yy = sumYY / n - sumY / n * (sumY / n) + 1 / 12.0;
            double xy = sumXY / n - sumX / n * (sumY / n), mean = (xx + yy) / 2, spread = Math.Sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
            spot.Elongation = Math.Sqrt((mean + spread) / Math.Max(1 / 12.0, mean - spread));
        }

        /// <summary>Against the square of pixels four away: slow texture, as bright there as here, is no light of the spot's.</summary>
        private void Core(int peak, ref Spot spot)
        {
            int px = peak % Width, py = peak / Width, near = 0, around = 0, count = 0;
            for (int y = Math.Max(0, py - CoreReach); y <= Math.Min(Height - 1, py + CoreReach); y++)
            {
                for (int x = Math.Max(0, px - CoreReach); x <= Math.Min(Width - 1, px + CoreReach); x++)
                {
                    int light = Light[y * Width + x] - spot.Background, distance = Math.Max(Math.Abs(x - px), Math.Abs(y - py));
                    if (distance <= 1)
                    {
                        near += light;
                        spot.Foot += light >= SoftThreshold * spot.Rise ? 1 : 0;
                    }
                    else if (distance == CoreReach)
                    {
                        around += light;
                        count++;
                    }
                }
            }

            spot.CoreLight = near - (count > 0 ? 9 * around / count : 0);
        }

        private int Push(int i, int half, int count)
        {
            if (_isInside[i] || Light[i] < half)
                return count;
            _isInside[i] = true;
            _stack[count] = i;
            return count + 1;
        }

        /// <summary>Only near the area: another spot in the window must not pull.</summary>
        private void Moments(ref Spot spot)
        {
            int reach = 2 + Math.Max(spot.Right - spot.Left, spot.Bottom - spot.Top) / 2;
            double threshold = spot.Background + SoftThreshold * spot.Rise, sum = 0, sumX = 0, sumY = 0, sumXX = 0, sumYY = 0;
            for (int y = Math.Max(0, spot.Top - reach); y <= Math.Min(Height - 1, spot.Bottom + reach); y++)
            {
                for (int x = Math.Max(0, spot.Left - reach); x <= Math.Min(Width - 1, spot.Right + reach); x++)
                {
                    double weight = Light[y * Width + x] - threshold;
                    if (weight <= 0)
                        continue;
                    sum += weight;
                    sumX += weight * x;
                    sumY += weight * y;
                    sumXX += weight * x * x;
                    sumYY += weight * y * y;
                }
            }

            double cx = sumX / sum, cy = sumY / sum;
            spot.PositionPx = new Vector2D(Left + cx, Top + cy);

            // Noise enters by the pixels' leverage, as for every centroid; half as much again for what the model leaves out.
            double leverage = 2.25 * spot.Sigma * spot.Sigma * spot.Area / (sum * sum);
            spot.CovariancePx = new Covariance2D(
                FloorPx * FloorPx + leverage * Math.Max(0, sumXX / sum - cx * cx), 0, FloorPx * FloorPx + leverage * Math.Max(0, sumYY / sum - cy * cy));
        }

        private double RingShare(in Spot spot)
        {
            int inner = 1 + Math.Max(spot.Right - spot.Left, spot.Bottom - spot.Top) / 4, outer = inner + 3;
            int half = spot.Background + (spot.Rise + 1) / 2, count = 0, bright = 0;
            for (int y = Math.Max(0, spot.Top - outer); y <= Math.Min(Height - 1, spot.Bottom + outer); y++)
            {
                for (int x = Math.Max(0, spot.Left - outer); x <= Math.Min(Width - 1, spot.Right + outer); x++)
                {
                    if (x >= spot.Left - inner && x <= spot.Right + inner && y >= spot.Top - inner && y <= spot.Bottom + inner)
                        continue;
                    count++;
                    if (Light[y * Width + x] >= half)
                        bright++;
                }
            }

            return count > 0 ? bright / (double)count : 1;
        }
    }
}
