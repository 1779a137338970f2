using System;
using LaserTracking.Geometry;

namespace LaserTracking.Health
{
    /// <summary>
    /// Small squares of two pictures compared by normalised correlation (light levels do not matter), where they lie and displaced.
    /// </summary>
    internal static unsafe class CellMatch
    {
        /// <summary>Side of a cell, bins.</summary>
        public const int Size = 16;

        /// <summary>Largest difference to the expected displacement that is looked for, bins.</summary>
        public const int Reach = 20;

        private const double StillFit = 0.95, LeastFit = 0.8;

        /// <summary>What a fit loses by the square of its distance, bins: along a straight edge all fit alike, and the nearest is taken.</summary>
        private const double FarLoss = 0.0003;

        /// <summary>Mean squared difference from which two pictures of a cell can be told apart in a camera's noise.</summary>
        private const double LeastDifference = 12;

        /// <summary>Variance of a cell's levels and its structure tensor (sums of squared slopes).</summary>
        public static double Variance(BinPicture picture, int x0, int y0, out double xx, out double xy, out double yy)
        {
            long sum = 0, squares = 0, sxx = 0, sxy = 0, syy = 0;
            int width = picture.Width;
            fixed (byte* levels = picture.Levels)
            {
                for (int y = 0; y < Size; y++)
                {
                    byte* p = levels + (y0 + y) * width + x0;
                    for (int x = 0; x < Size; x++)
                    {
                        int value = p[x];
                        sum += value;
                        squares += value * value;
                        if (y == 0 || x == 0 || y == Size - 1 || x == Size - 1)
                            continue;
                        int gx = p[x + 1] - p[x - 1], gy = p[x + width] - p[x - width];
                        sxx += gx * gx;
                        sxy += gx * gy;
                        syy += gy * gy;
                    }
                }
            }

            (xx, xy, yy) = (sxx, sxy, syy);
            return (squares - (double)sum * sum / (Size * Size)) / (Size * Size);
        }

        /// <summary>Correlation, -1…1, of a square of one picture with another's displaced by whole bins; nought where either is flat or leaves the picture.</summary>
        private static double Correlation(byte[] then, byte[] now, int width, int height, int x0, int y0, int size, int dx, int dy) =>
            Correlation(then, now, width, height, x0, y0, size, dx, dy, out _);

        private static double Correlation(byte[] then, byte[] now, int width, int height, int x0, int y0, int size, int dx, int dy, out double gain)
        {
            gain = 0;
            if (x0 + dx < 0 || y0 + dy < 0 || x0 + dx + size > width || y0 + dy + size > height)
                return 0;
            int a = 0, b = 0, aa = 0, bb = 0, ab = 0;
            fixed (byte* thenRows = then, nowRows = now)
            {
                for (int y = 0; y < size; y++)
                {
                    byte* p = thenRows + (y0 + y) * width + x0, q = nowRows + (y0 + dy + y) * width + x0 + dx;
                    for (int x = 0; x < size; x++)
                    {
                        int u = p[x], v = q[x];
                        a += u;
                        b += v;
                        aa += u * u;
                        bb += v * v;
                        ab += u * v;
                    }
                }
            }

            double n = size * size, spread = aa - a * (double)a / n, variances = spread * (bb - b * (double)b / n);
            gain = Math.Sqrt(variances) / Math.Max(1, spread);
            return variances > n * n ? (ab - a * (double)b / n) / Math.Sqrt(variances) : 0;
        }

        /// <summary>Correlation of a cell with itself then, undisplaced, and how much stronger its contrast is now.</summary>
        public static double Correlation(BinPicture then, BinPicture now, int x0, int y0, out double gain) =>
            Correlation(then.Levels, now.Levels, now.Width, now.Height, x0, y0, Size, 0, 0, out gain);

        /// <summary>Where a cell has gone, bins; false when nothing like it is to be seen near the place where it is expected.</summary>
        public static bool TryFind(BinPicture then, BinPicture now, int x0, int y0, Vector2D expected, out Vector2D shift)
        {
            int dx = (int)Math.Round(expected.X), dy = (int)Math.Round(expected.Y);
            double best = At(then, now, x0, y0, dx, dy);
            if (!(best >= StillFit && IsPeak(then, now, x0, y0, dx, dy, best)))
            {
                double coarse = -1;
                int atX = dx, atY = dy, half = Reach / 2, fromX = dx, fromY = dy;
                for (int y = dy / 2 - half; y <= dy / 2 + half; y++)
                for (int x = dx / 2 - half; x <= dx / 2 + half; x++)
                {
                    double fit = Correlation(then.Half, now.Half, now.Width / 2, now.Height / 2, x0 / 2, y0 / 2, Size / 2, x, y);
                    fit -= FarLoss * ((2 * x - fromX) * (2 * x - fromX) + (2 * y - fromY) * (2 * y - fromY));
                    if (fit > coarse)
                        (coarse, atX, atY) = (fit, 2 * x, 2 * y);
                }

                double least = -1;
                for (int y = atY - 2; y <= atY + 2; y++)
                for (int x = atX - 2; x <= atX + 2; x++)
                {
                    double fit = At(then, now, x0, y0, x, y), value = fit - FarLoss * ((x - fromX) * (x - fromX) + (y - fromY) * (y - fromY));
                    if (value > least)
                        (least, best, dx, dy) = (value, fit, x, y);
                }
            }

            shift = new Vector2D(dx + Fraction(At(then, now, x0, y0, dx - 1, dy), best, At(then, now, x0, y0, dx + 1, dy)),
                dy + Fraction(At(then, now, x0, y0, dx, dy - 1), best, At(then, now, x0, y0, dx, dy + 1)));
            return best >= LeastFit;
        }

        /// <summary>
        /// Whether a cell stayed (-1) or went by a displacement (1), or neither or cannot be told (0): its squared difference to what
        /// either would show, light aside, as a share of the difference between the two.
        /// </summary>
        public static int Verdict(BinPicture then, BinPicture now, int x0, int y0, Vector2D shift)
        {
            int width = now.Width, right = width / Size * Size, bottom = now.Height / Size * Size, wholeX = (int)Math.Floor(-shift.X), wholeY = (int)Math.Floor(-shift.Y);
            int fx = (int)(256 * (-shift.X - wholeX)), fy = (int)(256 * (-shift.Y - wholeY)), count = 0;
            double a = 0, aa = 0, b = 0, bb = 0, s = 0, ss = 0;
            fixed (byte* thenRows = then.Levels, nowRows = now.Levels)
            {
                for (int y = y0; y < y0 + Size; y += 2)
                {
                    int fromY = y + wholeY;
                    if (fromY < 0 || fromY + 1 >= bottom)
                        continue;
                    byte* upper = thenRows + fromY * width, lower = upper + width;
                    for (int x = x0; x < x0 + Size; x++)
                    {
                        int fromX = x + wholeX;
                        if (fromX < 0 || fromX + 1 >= right)
                            continue;
                        int moved = ((upper[fromX] * (256 - fx) + upper[fromX + 1] * fx) * (256 - fy) + (lower[fromX] * (256 - fx) + lower[fromX + 1] * fx) * fy) >> 12;
                        int seen = nowRows[y * width + x] << 4, stayed = thenRows[y * width + x] << 4, ofStay = seen - stayed, ofMove = seen - moved, between = stayed - moved;
                        a += ofStay;
                        aa += (double)ofStay * ofStay;
                        b += ofMove;
                        bb += (double)ofMove * ofMove;
                        s += between;
                        ss += (double)between * between;
                        count++;
                    }
                }
            }

            if (count < Size * Size / 8)
                return 0;
            double stay = (aa - a * a / count) / 256, move = (bb - b * b / count) / 256, difference = (ss - s * s / count) / 256;
            if (difference < LeastDifference * count || Math.Min(stay, move) > 0.4 * difference)
                return 0;
            return stay - move > 0.5 * difference ? 1 : move - stay > 0.5 * difference ? -1 : 0;
        }

        private static double At(BinPicture then, BinPicture now, int x0, int y0, int dx, int dy) =>
            Correlation(then.Levels, now.Levels, now.Width, now.Height, x0, y0, Size, dx, dy);

        private static bool IsPeak(BinPicture then, BinPicture now, int x0, int y0, int dx, int dy, double best) =>
            best >= At(then, now, x0, y0, dx - 1, dy) && best >= At(then, now, x0, y0, dx + 1, dy)
            && best >= At(then, now, x0, y0, dx, dy - 1) && best >= At(then, now, x0, y0, dx, dy + 1);

        private static double Fraction(double before, double best, double after)
        {
            double bend = before - 2 * best + after;
            return bend < -1e-6 && before > 0 && after > 0 ? Math.Max(-0.5, Math.Min(0.5, 0.5 * (before - after) / bend)) : 0;
        }
    }
}
