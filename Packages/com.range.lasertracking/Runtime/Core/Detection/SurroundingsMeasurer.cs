using System;
using System.Linq;
using System.Runtime.CompilerServices;

namespace LaserTracking.Detection
{
    /// <summary>Looks at what happens around a candidate: whether it is alone, whether its neighbourhood is at rest, what colour rose.</summary>
    internal static unsafe partial class SurroundingsMeasurer
    {
        /// <summary>One through the room above each level, eight levels granted.</summary>
        private static readonly double[] ThroughRoom = Enumerable.Range(0, 256).Select(level => 1.0 / (255 - level + 8)).ToArray();

        /// <summary>Vividness between that of grey things and that of lasers.</summary>
        private const double NeutralVividness = 1.1;

        /// <summary>Mean levels of room from which a channel tells what it rose by.</summary>
        private const double AmpleHeadroom = 16;

        /// <summary>Share of eight pixels all around at this distance that rose at least half as far. What lies outside the picture has not.</summary>
        public static double SpokeShare(in FrameView view, in Candidate candidate, int distance)
        {
            int threshold = Math.Max(1, (candidate.PeakRelativeRise + 1) / 2);
            int risen = 0;
            for (int dy = -1; dy <= 1; dy++)
            {
                for (int dx = -1; dx <= 1; dx++)
                {
                    int reach = dx != 0 && dy != 0 ? distance * 7 / 10 + 1 : distance;
                    int x = candidate.SeedX + dx * reach, y = candidate.SeedY + dy * reach;
                    if ((dx != 0 || dy != 0) && x >= 0 && y >= 0 && x < view.Width && y < view.Height
                        && view.RelativeRise(y * view.Width + x, candidate.Plane) >= threshold)
                        risen++;
                }
            }

            return risen / 8.0;
        }

        /// <summary>Share of the ring around the box in which the rise is at least half the candidate's own.</summary>
        public static void Ring(in FrameView view, ref Candidate candidate, double noise)
        {
            int* histogram = stackalloc int[256];
            for (int i = 0; i < 256; i++)
                histogram[i] = 0;
            int size = Math.Max(candidate.Right - candidate.Left, candidate.Bottom - candidate.Top) + 1;
            int inner = Math.Max(3, size / 2), outer = inner + Math.Max(6, size / 2);
            int threshold = Math.Max(1, (candidate.PeakRelativeRise + 1) / 2);
            int least = candidate.LeastRise(view, noise, out int leastUnclipped);
            int risen = 0, count = 0;
            int x0 = Math.Max(0, candidate.Left - outer), x1 = Math.Min(view.Width - 1, candidate.Right + outer);
            int y0 = Math.Max(0, candidate.Top - outer), y1 = Math.Min(view.Height - 1, candidate.Bottom + outer);
            for (int y = y0; y <= y1; y++)
            {
                bool isRowInside = y >= candidate.Top - inner && y <= candidate.Bottom + inner;
                for (int x = x0; x <= x1; x++)
                {
                    if (isRowInside && x >= candidate.Left - inner && x <= candidate.Right + inner)
                    {
                        x = Math.Min(x1, candidate.Right + inner);
                        continue;
                    }

                    count++;
                    int i = y * view.Width + x;
                    histogram[view.RelativeRise(i, candidate.Plane)]++;
                    if (view.HasRisen(i, candidate.Plane, threshold, least, leastUnclipped))
                        risen++;
                }
            }

            if (count == 0)
                return;
            candidate.RingShare = (double)risen / count;
            int level = 255;
            for (int above = 0; level > 0; level--)
            {
                above += histogram[level];
                if (10 * above > count)
                    break;
            }

            // What noise alone lifts a tenth of the ring by is not the candidate's doing.
            double perLevel = candidate.PeakRelativeRise / (double)candidate.PeakRise;
            candidate.RingLevel = Math.Max(0, level - 1.5 * noise * perLevel) / candidate.PeakRelativeRise;
        }

        /// <summary>Share of a ring three pixels wide, two beside the box, that is as far above the projected picture as the light itself.</summary>
        public static double ExcessRingShare(in FrameView view, in Candidate candidate)
        {
            int threshold = BlobMeasurer.ExcessThreshold(view, candidate);
            int bright = 0, count = 0;
            int x0 = Math.Max(0, candidate.Left - 5), x1 = Math.Min(view.Width - 1, candidate.Right + 5);
            int y0 = Math.Max(0, candidate.Top - 5), y1 = Math.Min(view.Height - 1, candidate.Bottom + 5);
            for (int y = y0; y <= y1; y++)
            {
                for (int x = x0; x <= x1; x++)
                {
                    if (x > candidate.Left - 3 && x < candidate.Right + 3 && y > candidate.Top - 3 && y < candidate.Bottom + 3)
                        continue;
                    count++;
                    if (FrameView.Level(view.Now[y * view.Width + x], candidate.Plane) >= threshold)
                        bright++;
                }
            }

            return count == 0 ? 0 : (double)bright / count;
        }

        /// <summary>Pixels in the box and three around it that were as bright in the frame before, through the area: 1 for a dot that rests.</summary>
        public static double ExcessBefore(in FrameView view, in Candidate candidate)
        {
            int threshold = BlobMeasurer.ExcessThreshold(view, candidate), bright = 0;
            for (int y = Math.Max(0, candidate.Top - 3); y <= Math.Min(view.Height - 1, candidate.Bottom + 3); y++)
            {
                for (int x = Math.Max(0, candidate.Left - 3); x <= Math.Min(view.Width - 1, candidate.Right + 3); x++)
                {
                    if (FrameView.Level(view.Before[y * view.Width + x], candidate.Plane) >= threshold)
                        bright++;
                }
            }

            return bright / (double)candidate.Area;
        }

        /// <summary>The brightest pixel of the box.</summary>
        public static int PeakLevel(in FrameView view, in Candidate candidate)
        {
            int peak = 0;
            for (int y = candidate.Top; y <= candidate.Bottom; y++)
            {
                uint* row = view.Now + y * view.Width;
                for (int x = candidate.Left; x <= candidate.Right; x++)
                    peak = Math.Max(peak, FrameView.Level(row[x], DetectionPlane.Largest));
            }

            return peak;
        }

        /// <summary>
        /// Each channel's rise since the last frame through its own headroom there, summed over the box and 60 % more: the rim tells
        /// the colour where the core is white, and a saturated background lowers no channel's say.
        /// </summary>
        /// <param name="view">The frame.</param>
        /// <param name="candidate">Grown.</param>
        /// <param name="grown">Share of its rise that came in this frame, above 0: how vivid it is shows in that.</param>
        public static void ColorRise(in FrameView view, ref Candidate candidate, double grown = 1)
        {
            int marginX = 1 + (candidate.Right - candidate.Left + 1) * 3 / 10, marginY = 1 + (candidate.Bottom - candidate.Top + 1) * 3 / 10;
            int x0 = Math.Max(0, candidate.Left - marginX), x1 = Math.Min(view.Width - 1, candidate.Right + marginX);
            int y0 = Math.Max(0, candidate.Top - marginY), y1 = Math.Min(view.Height - 1, candidate.Bottom + marginY);
            double* rises = stackalloc double[4];
            int* levels = stackalloc int[4];
            for (int i = 0; i < 4; i++)
                rises[i] = levels[i] = 0;
            fixed (double* throughRoom = ThroughRoom)
            {
                for (int y = y0; y <= y1; y++)
                    AddRises(view.Now + y * view.Width + x0, view.Before + y * view.Width + x0, x1 - x0 + 1, throughRoom, rises, levels);
            }

            double blue = rises[0], green = rises[1], red = rises[2], either = rises[3];
            int pixels = (x1 - x0 + 1) * (y1 - y0 + 1);
            candidate.RedHeadroom = (255 * pixels - levels[2]) / (double)pixels;
            candidate.GreenHeadroom = (255 * pixels - levels[1]) / (double)pixels;
            candidate.RedRise = red;
            candidate.GreenRise = green;
            candidate.BlueRise = blue;
            candidate.GreenCoherence = either > 0 ? (green - red) / either : 0;
            double unit = 255 / ((double)candidate.Area * candidate.PeakRelativeRise);
            candidate.Freshness = Math.Max(blue, Math.Max(red, green)) * unit;
            candidate.Vividness = Math.Max(red * unit / grown + NeutralVividness * Unsaid(candidate, candidate.RedHeadroom),
                green * unit / grown + NeutralVividness * Unsaid(candidate, candidate.GreenHeadroom));
        }

        /// <summary>Adds up one row's pixels, in their order.</summary>
        /// <param name="now">The row's first pixel.</param>
        /// <param name="before">The same in the last frame.</param>
        /// <param name="count">Pixels.</param>
        /// <param name="throughRoom">By level.</param>
        /// <param name="rises">Of blue, of green, of red, and green's difference from red's.</param>
        /// <param name="levels">Of blue, green and red in the last frame.</param>
        internal static void AddRises(uint* now, uint* before, int count, double* throughRoom, double* rises, int* levels)
        {
            int i = 0;
#if NET8_0_OR_GREATER
            i = AddRisesVector(now, before, count, throughRoom, rises, levels);
#endif
            double blue = rises[0], green = rises[1], red = rises[2], either = rises[3];
            for (; i < count; i++)
            {
                int blueBefore = (int)(before[i] & 255), greenBefore = (int)(before[i] >> 8 & 255), redBefore = (int)(before[i] >> 16 & 255);
                double greenShare = Share(throughRoom, (int)(now[i] >> 8 & 255), greenBefore), redShare = Share(throughRoom, (int)(now[i] >> 16 & 255), redBefore);
                blue += Share(throughRoom, (int)(now[i] & 255), blueBefore);
                green += greenShare;
                red += redShare;
                either += Math.Abs(greenShare - redShare);
                levels[0] += blueBefore;
                levels[1] += greenBefore;
                levels[2] += redBefore;
            }

            rises[0] = blue;
            rises[1] = green;
            rises[2] = red;
            rises[3] = either;
        }

        /// <summary>
        /// The larger of red's and green's change through blue's, levels, in the box and beyond that of its border; 1 where one of them
        /// had not room enough to rise as far. Lasers are red, green or infrared; what compression makes of a dark or coloured wall is often blue.
        /// </summary>
        public static double RiseAgainstBlue(in FrameView view, in Candidate candidate)
        {
            int x0 = Math.Max(0, candidate.Left - 3), x1 = Math.Min(view.Width - 1, candidate.Right + 3);
            int y0 = Math.Max(0, candidate.Top - 3), y1 = Math.Min(view.Height - 1, candidate.Bottom + 3);
            double red = 0, green = 0, blue = 0;
            int inside = (candidate.Right - candidate.Left + 1) * (candidate.Bottom - candidate.Top + 1), border = (x1 - x0 + 1) * (y1 - y0 + 1) - inside;
            for (int y = y0; y <= y1; y++)
            {
                for (int x = x0; x <= x1; x++)
                {
                    bool isInside = x >= candidate.Left && x <= candidate.Right && y >= candidate.Top && y <= candidate.Bottom;
                    double weight = isInside ? 1.0 / inside : -1.0 / border;
                    uint now = view.Now[y * view.Width + x], before = view.Before[y * view.Width + x];
                    red += weight * ((int)(now >> 16 & 255) - (int)(before >> 16 & 255));
                    green += weight * ((int)(now >> 8 & 255) - (int)(before >> 8 & 255));
                    blue += weight * ((int)(now & 255) - (int)(before & 255));
                }
            }

            return blue <= 0 || Math.Min(candidate.RedHeadroom, candidate.GreenHeadroom) < 2 * blue ? 1 : Math.Max(red, green) / blue;
        }

        /// <summary>
        /// By how much the luma has changed through how much the candidate's plane has, in its box; 1 where that has not. A red laser's is
        /// a quarter or more; compressed pictures carry colour in blocks, and what moves past their seams takes another's without becoming brighter.
        /// </summary>
        public static double LumaShare(in FrameView view, in Candidate candidate)
        {
            int luma = 0, level = 0;
            for (int y = candidate.Top; y <= candidate.Bottom; y++)
            {
                for (int x = candidate.Left; x <= candidate.Right; x++)
                {
                    uint now = view.Now[y * view.Width + x], before = view.Before[y * view.Width + x];
                    luma += FrameView.Luma(now) - FrameView.Luma(before);
                    level += FrameView.Level(now, candidate.Plane) - FrameView.Level(before, candidate.Plane);
                }
            }

            return level <= 0 ? 1 : luma / (double)level;
        }

        /// <summary>
        /// How much of what a channel or plane would have told is missing for want of room, 0…1: there a value counts that speaks neither
        /// for nor against. Only beside light that takes half of the room that is left elsewhere: less is what noise does, too.
        /// </summary>
        public static double Unsaid(in Candidate candidate, double headroom) =>
            Math.Max(0, 1 - headroom / AmpleHeadroom) * Math.Min(1, candidate.PeakRelativeRise / 127.5);

        /// <summary>By the room that the darker of the two left: what leaves full brightness falls no further than what reaches it rises.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static double Share(double* throughRoom, int now, int before) => (now - before) * throughRoom[now < before ? now : before];
    }
}
