using System;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    /// <summary>
    /// The neighbourhood of a dot on the full-resolution frame as light above its background. Channels count as much as they rose,
    /// or luma alone where chroma is coarse; the frame before is subtracted as far as it explains the window's border.
    /// </summary>
    internal sealed unsafe class DotWindow
    {
        private const int MaxSide = 192;

        /// <summary>Width of the border that tells background and noise, px.</summary>
        private const int Border = 2;

        /// <summary>A pixel counts as clipped from this channel value on: no noise and no speckle shows in it.</summary>
        private const int ClippedLevel = 252;

        /// <summary>Deviation of the whole border through the peak, above which the background counts as moving.</summary>
        private const double MaxRestlessness = 0.1;

        /// <summary>Noise through the frame's temporal noise, above which the past does not explain the border.</summary>
        private const double MaxTexture = 3;

        private readonly uint[] _row = new uint[MaxSide];
        private readonly float[] _past = new float[MaxSide * MaxSide];

        private double _restlessness;
        private uint _usualPast;
        private float _usualEnvelope;
        private int _boxLeft, _boxTop, _boxWidth, _boxHeight;

        public float[] Light { get; } = new float[MaxSide * MaxSide];

        /// <summary>The channel that counts most has no room left here.</summary>
        public bool[] Clipped { get; } = new bool[MaxSide * MaxSide];

        public int Left { get; private set; }

        public int Top { get; private set; }

        public int Width { get; private set; }

        public int Height { get; private set; }

        /// <summary>Standard deviation of the light at the border: noise, and texture that is not explained.</summary>
        public double Noise { get; private set; }

        /// <summary>Largest light inside the candidate's box.</summary>
        public double Peak { get; private set; }

        /// <summary>Clipped pixels inside the candidate's box.</summary>
        public int ClippedCount { get; private set; }

        /// <summary>Brightest channel value in the window, 0…255.</summary>
        public int PeakLevel { get; private set; }

        /// <summary>Cuts the window out and subtracts the background.</summary>
        public void Fill(Image image, in FrameView view, int factor, in Candidate candidate, double noise)
        {
            Place(image, view, factor, candidate);
            Channels(image, view, candidate, out float blue, out float green, out float red);
            MeetUsualPast(view, factor, candidate.Plane);
            Gather(image, view, factor, candidate, blue, green, red, false);
            SubtractBackground();

            // The past is known at half size only: fine texture shows in the difference unless both are compared at that size. That costs
            // sharpness, so not for dots that clip.
            double fullNoise = Noise;
            FindPeak();
            if (factor > 1 && fullNoise > MaxTexture * noise && ClippedCount == 0)
            {
                Gather(image, view, factor, candidate, blue, green, red, true);
                SubtractBackground();
                Noise *= factor;
                if (Noise > fullNoise)
                {
                    Gather(image, view, factor, candidate, blue, green, red, false);
                    SubtractBackground();
                }
            }

            FindPeak();
            if (candidate.ExceedsContent && _restlessness > MaxRestlessness * Peak)
                KeepAboveContent(image, candidate, noise);
        }

        private void Gather(Image image, in FrameView view, int factor, in Candidate candidate, float blue, float green, float red, bool isReduced)
        {
            PeakLevel = 0;
            bool hasLuma = image.Format != PixelFormat.Bgra32 && !isReduced;
            float total = Math.Max(blue, Math.Max(green, red));
            fixed (uint* row = _row)
            {
                for (int y = 0; y < Height; y++)
                {
                    PixelRow.ToBgra(image, Top + y, Left, Left + Width, row);
                    int reducedRow = Math.Max(0, Math.Min(view.Height - 1, (Top + y) / factor - view.ShiftY)) * view.Width;
                    for (int x = 0; x < Width; x++)
                    {
                        uint pixel = row[x];
                        int i = y * Width + x, reduced = reducedRow + Math.Max(0, Math.Min(view.Width - 1, (Left + x) / factor - view.ShiftX));
                        PeakLevel = Math.Max(PeakLevel, FrameView.Level(pixel, DetectionPlane.Largest));
                        Clipped[i] = IsClipped(pixel, blue, green, red, total);
                        Light[i] = hasLuma ? PixelRow.Luma(image, Top + y, Left + x) : Weigh(isReduced ? view.Now[reduced] : pixel, blue, green, red);
                        if (candidate.IsOnset || candidate.IsAboveExpected)
                            _past[i] = Weigh(Unclipped(isReduced ? view.Now[reduced] : pixel, view.Before[reduced]), blue, green, red);
                        else
                            _past[i] = Clipped[i] ? _usualEnvelope : view.Envelope(reduced, candidate.Plane);
                    }
                }
            }
        }

        /// <summary>Where things move behind the dot nothing tells its background: what the projected picture cannot reach is light.</summary>
        private void KeepAboveContent(Image image, in Candidate candidate, double noise)
        {
            fixed (uint* row = _row)
            {
                for (int y = 0; y < Height; y++)
                {
                    PixelRow.ToBgra(image, Top + y, Left, Left + Width, row);
                    for (int x = 0; x < Width; x++)
                        Light[y * Width + x] = Math.Max(0, FrameView.Level(row[x], candidate.Plane) - candidate.ContentLevel);
                }
            }

            Noise = noise;
            FindPeak();
        }

        public bool IsInBorder(int x, int y) => x < Border || y < Border || x >= Width - Border || y >= Height - Border;

        private static float Weigh(uint pixel, float blue, float green, float red) =>
            blue * (pixel & 255) + green * (pixel >> 8 & 255) + red * (pixel >> 16 & 255);

        /// <summary>Where the sensor clips, the background does not show any more: channel by channel its mean takes its place.</summary>
        private uint Unclipped(uint now, uint past)
        {
            uint mask = ((now & 255) >= ClippedLevel ? 0xFFu : 0) | ((now >> 8 & 255) >= ClippedLevel ? 0xFF00u : 0) | ((now >> 16 & 255) >= ClippedLevel ? 0xFF0000u : 0);
            return (past & ~mask) | (_usualPast & mask);
        }

        /// <summary>Means of the past over the window's border.</summary>
        private void MeetUsualPast(in FrameView view, int factor, DetectionPlane plane)
        {
            long blue = 0, green = 0, red = 0, envelope = 0, count = 0;
            for (int y = 0; y < Height; y++)
            {
                int row = Math.Max(0, Math.Min(view.Height - 1, (Top + y) / factor - view.ShiftY)) * view.Width;
                for (int x = 0; x < Width; x++)
                {
                    if (!IsInBorder(x, y))
                        continue;
                    int i = row + Math.Max(0, Math.Min(view.Width - 1, (Left + x) / factor - view.ShiftX));
                    uint past = view.Before[i];
                    blue += past & 255;
                    green += past >> 8 & 255;
                    red += past >> 16 & 255;
                    envelope += view.Envelope(i, plane);
                    count++;
                }
            }

            count = Math.Max(1, count);
            _usualPast = (uint)(blue / count) | (uint)(green / count) << 8 | (uint)(red / count) << 16;
            _usualEnvelope = envelope / (float)count;
        }

        private static bool IsClipped(uint pixel, float blue, float green, float red, float total) =>
            (blue < total || (pixel & 255) >= ClippedLevel) && (green < total || (pixel >> 8 & 255) >= ClippedLevel) && (red < total || (pixel >> 16 & 255) >= ClippedLevel);

        private void Place(Image image, in FrameView view, int factor, in Candidate candidate)
        {
            _boxLeft = (candidate.Left + view.ShiftX) * factor;
            _boxTop = (candidate.Top + view.ShiftY) * factor;
            _boxWidth = (candidate.Right - candidate.Left + 1) * factor;
            _boxHeight = (candidate.Bottom - candidate.Top + 1) * factor;
            int margin = 4 * factor + Math.Max(_boxWidth, _boxHeight) / 2;
            int marginX = Math.Max(0, Math.Min(margin, (MaxSide - _boxWidth) / 2)), marginY = Math.Max(0, Math.Min(margin, (MaxSide - _boxHeight) / 2));
            Left = Math.Max(0, Math.Min(image.Width - 1, _boxLeft - marginX));
            Top = Math.Max(0, Math.Min(image.Height - 1, _boxTop - marginY));
            Width = Math.Min(MaxSide, Math.Max(Left + 1, Math.Min(image.Width, _boxLeft + _boxWidth + marginX)) - Left);
            Height = Math.Min(MaxSide, Math.Max(Top + 1, Math.Min(image.Height, _boxTop + _boxHeight + marginY)) - Top);
        }

        /// <summary>How far each channel rose in the candidate's box through the largest of them: the weights that serve noise best.</summary>
        private void Channels(Image image, in FrameView view, in Candidate candidate, out float blue, out float green, out float red)
        {
            if (image.Format != PixelFormat.Bgra32)
            {
                blue = 0.114f;
                green = 0.587f;
                red = 0.299f;
                return;
            }

            long sumBlue = 0, sumGreen = 0, sumRed = 0;
            for (int y = candidate.Top; y <= candidate.Bottom; y++)
            {
                for (int x = candidate.Left; x <= candidate.Right; x++)
                {
                    int i = y * view.Width + x;
                    uint now = view.Now[i];

                    // Of a dot that goes on nobody knows the wall's colour: its own height counts.
                    uint before = candidate.IsOnset || candidate.IsAboveExpected ? view.Before[i] : 0;
                    sumBlue += (int)(now & 255) - (int)(before & 255);
                    sumGreen += (int)(now >> 8 & 255) - (int)(before >> 8 & 255);
                    sumRed += (int)(now >> 16 & 255) - (int)(before >> 16 & 255);
                }
            }

            float largest = Math.Max(1, Math.Max(sumBlue, Math.Max(sumGreen, sumRed)));
            blue = Math.Max(0, sumBlue / largest);
            green = Math.Max(0, sumGreen / largest);
            red = Math.Max(0, sumRed / largest);
        }

        /// <summary>
        /// Light = level − a − b · past, the line fitted over the border (least squares, then again without what lies three deviations
        /// off). On an even wall b comes out near zero and the past's noise stays out; on a textured one near one.
        /// </summary>
        private void SubtractBackground()
        {
            double offset = 0, slope = 0, limit = double.PositiveInfinity;
            Noise = 1;
            for (int round = 0; round < 3; round++)
            {
                double n = 0, sumP = 0, sumL = 0, sumPP = 0, sumPL = 0, sumLL = 0;
                for (int y = 0; y < Height; y++)
                {
                    for (int x = 0; x < Width; x++)
                    {
                        if (!IsInBorder(x, y))
                            continue;
                        double past = _past[y * Width + x], light = Light[y * Width + x];
                        if (Math.Abs(light - offset - slope * past) > limit)
                            continue;
                        n++;
                        sumP += past;
                        sumL += light;
                        sumPP += past * past;
                        sumPL += past * light;
                        sumLL += light * light;
                    }
                }

                if (n < 8)
                    break;
                double varianceP = sumPP / n - sumP / n * sumP / n, covariance = sumPL / n - sumP / n * sumL / n;
                slope = varianceP > 0.01 ? Math.Max(0, Math.Min(1.2, covariance / varianceP)) : 0;
                offset = (sumL - slope * sumP) / n;
                double variance = sumLL / n - sumL / n * sumL / n - 2 * slope * covariance + slope * slope * varianceP;

                // A level's rounding is the least.
                Noise = Math.Sqrt(Math.Max(1.0 / 12, variance));
                limit = 3 * Noise;
            }

            double sum = 0;
            int count = 0;
            for (int i = 0; i < Width * Height; i++)
            {
                Light[i] -= (float)(offset + slope * _past[i]);
                if (!IsInBorder(i % Width, i / Width))
                    continue;
                sum += Light[i] * Light[i];
                count++;
            }

            _restlessness = Math.Sqrt(sum / Math.Max(1, count));
        }

        private void FindPeak()
        {
            float peak = 0;
            ClippedCount = 0;
            for (int y = Math.Max(0, _boxTop - Top); y < Math.Min(Height, _boxTop + _boxHeight - Top); y++)
            {
                for (int x = Math.Max(0, _boxLeft - Left); x < Math.Min(Width, _boxLeft + _boxWidth - Left); x++)
                {
                    peak = Math.Max(peak, Light[y * Width + x]);
                    if (Clipped[y * Width + x])
                        ClippedCount++;
                }
            }

            Peak = peak;
        }
    }
}
