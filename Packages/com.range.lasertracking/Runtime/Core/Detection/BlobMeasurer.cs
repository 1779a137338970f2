using System;

namespace LaserTracking.Detection
{
    /// <summary>Grows a candidate from its brightest pixel and measures its shape. Pixels once taken belong to no later candidate of the plane.</summary>
    internal sealed unsafe class BlobMeasurer
    {
        /// <summary>Of each pixel: minus the stamp of the plane's turn in which it was taken, or the candidate that looked at it last.</summary>
        private int[] _marks = Array.Empty<int>();
        private int[] _stack = Array.Empty<int>();
        private int _stamp;
        private int _serial;

        /// <summary>Makes room for a picture of this many pixels.</summary>
        public void Resize(int pixels, int maxArea)
        {
            _marks = new int[pixels];
            _serial = 0;
            _stack = new int[maxArea + 1];
            _stamp = 0;
        }

        /// <summary>Forgets which pixels are taken.</summary>
        public void Begin()
        {
            if (_stamp > int.MaxValue - 2 || _serial > int.MaxValue - 1_000_000)
            {
                Array.Clear(_marks, 0, _marks.Length);
                _stamp = _serial = 0;
            }

            _stamp++;
        }

        public bool IsTaken(int index) => _marks[index] == -_stamp;

        /// <summary>Fills area, box and moments. Growing stops when the area does not fit any more: Area is then the limit + 1.</summary>
        public void Grow(in FrameView view, ref Candidate candidate)
        {
            bool isByLevel = candidate.IsAboveContent;
            int width = view.Width, height = view.Height;
            int threshold = isByLevel
                ? ExcessThreshold(view, candidate)
                : Math.Max(1, (candidate.PeakRelativeRise + 1) / 2);
            int maxArea = _stack.Length - 1;
            int seed = candidate.SeedY * width + candidate.SeedX;
            int count = 0;
            uint* now = view.Now;
            byte* past = view.Past(candidate.Plane);
            int* reciprocal = view.Reciprocal;

            // Every pixel is looked at once a candidate, also those that turn out too low.
            int serial = ++_serial, taken = -_stamp, seedX = candidate.SeedX, seedY = candidate.SeedY;
            int left = seedX, right = seedX, top = seedY, bottom = seedY;
            long sumX = 0, sumY = 0, sumXX = 0, sumYY = 0, sumXY = 0;
            DetectionPlane plane = candidate.Plane;
            fixed (int* marks = _marks, stack = _stack)
            {
                stack[count++] = seed;
                marks[seed] = taken;
                for (int next = 0; next < count && count <= maxArea; next++)
                {
                    int i = stack[next];
                    int y = i / width, x = i - y * width;
                    int dx = x - seedX, dy = y - seedY;
                    sumX += dx;
                    sumY += dy;
                    sumXX += dx * dx;
                    sumYY += dy * dy;
                    sumXY += dx * dy;
                    left = Math.Min(left, x);
                    right = Math.Max(right, x);
                    top = Math.Min(top, y);
                    bottom = Math.Max(bottom, y);
                    int y0 = y > 0 ? y - 1 : 0, y1 = y < height - 1 ? y + 1 : y, x0 = x > 0 ? x - 1 : 0, x1 = x < width - 1 ? x + 1 : x;
                    for (int ny = y0; ny <= y1; ny++)
                    {
                        for (int n = ny * width + x0; n <= ny * width + x1; n++)
                        {
                            int mark = marks[n];
                            if (mark == serial || mark == taken || count > maxArea)
                                continue;
                            marks[n] = serial;
                            int value = isByLevel ? FrameView.Level(now[n], plane) : FrameView.RelativeRise(now[n], plane, past[n], reciprocal);
                            if (value < threshold)
                                continue;
                            marks[n] = taken;
                            stack[count++] = n;
                        }
                    }
                }
            }

            candidate.Area = count;
            candidate.Left = left;
            candidate.Right = right;
            candidate.Top = top;
            candidate.Bottom = bottom;
            double meanX = (double)sumX / count, meanY = (double)sumY / count;
            candidate.CenterX = candidate.SeedX + meanX;
            candidate.CenterY = candidate.SeedY + meanY;
            Shape(ref candidate, (double)sumXX / count - meanX * meanX, (double)sumYY / count - meanY * meanY, (double)sumXY / count - meanX * meanY);
        }

        /// <summary>The level half-way from the projected picture's brightest to the seed.</summary>
        public static int ExcessThreshold(in FrameView view, in Candidate candidate) =>
            (FrameView.Level(view.Now[candidate.SeedY * view.Width + candidate.SeedX], candidate.Plane) + candidate.ContentLevel + 1) / 2;

        private static void Shape(ref Candidate candidate, double xx, double yy, double xy)
        {
            // A pixel is a square, not a point: its own variance keeps one-pixel lines from being infinitely thin.
            xx += 1.0 / 12;
            yy += 1.0 / 12;
            double mean = (xx + yy) / 2, spread = Math.Sqrt((xx - yy) * (xx - yy) / 4 + xy * xy);
            candidate.LongSigma = Math.Sqrt(mean + spread);
            candidate.ShortSigma = Math.Sqrt(Math.Max(1.0 / 12, mean - spread));
            candidate.Compactness = Math.Min(1, candidate.Area / (4 * Math.PI * candidate.LongSigma * candidate.ShortSigma));
        }
    }
}
