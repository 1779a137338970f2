using System;

namespace LaserTracking.Detection
{
    /// <summary>Measures a grown candidate and what happens around it.</summary>
    internal static unsafe class FeatureMeasurer
    {
        /// <summary>Every second pixel of every second row is looked at.</summary>
        private const int Step = 2;

        /// <summary>Values that speak neither for nor against a dot: for what had no room to say more.</summary>
        private const double NeutralCoherence = 0.83, NeutralOtherRise = 0.13;

        /// <param name="view">The frame.</param>
        /// <param name="candidate">Grown, with its colours measured.</param>
        /// <param name="scale">Working px per pixel of a picture 640 wide.</param>
        /// <param name="contentLevel">Brightest of the projected picture, levels.</param>
        /// <param name="features">One value for each <see cref="DotFeature"/>; those of the surroundings stay as they are.</param>
        public static void MeasureItself(in FrameView view, in Candidate candidate, double scale, int contentLevel, Span<float> features)
        {
            double rise = candidate.PeakRise, unclipped = candidate.UnclippedRise(view), area = candidate.Area / (scale * scale);
            int seed = candidate.SeedY * view.Width + candidate.SeedX;
            DetectionPlane other = candidate.Plane == DetectionPlane.Largest ? DetectionPlane.Smallest : DetectionPlane.Largest;
            Set(features, DotFeature.Rise, candidate.PeakRelativeRise / 255.0);
            Set(features, DotFeature.LogArea, Math.Log(area));
            Set(features, DotFeature.Compactness, candidate.Compactness);
            Set(features, DotFeature.LogElongation, Math.Log(candidate.LongSigma / candidate.ShortSigma));
            Set(features, DotFeature.Activity, candidate.Activity / unclipped);
            Set(features, DotFeature.ActivityAround, candidate.ActivityAround / unclipped);

            // What was darker lately only comes back to its past; how far it rises above that is new, the surer the more of the room it takes.
            double fresh = view.Change(seed, candidate.Plane) / rise;
            Set(features, DotFeature.Freshness, Math.Min(fresh, 1 + (fresh - 1) * (1 - candidate.PeakRelativeRise / 255.0)));
            Set(features, DotFeature.Vividness, candidate.Vividness);
            Set(features, DotFeature.Coherence, Math.Max(Math.Abs(candidate.GreenCoherence), NeutralCoherence * SurroundingsMeasurer.Unsaid(candidate, Math.Max(candidate.RedHeadroom, candidate.GreenHeadroom))));
            Set(features, DotFeature.ContentExcess, (candidate.PeakLevel - contentLevel) / 64.0);
            Set(features, DotFeature.OtherRise, Math.Max(view.RelativeRise(seed, other) / 255.0, NeutralOtherRise * SurroundingsMeasurer.Unsaid(candidate, 255 - view.Envelope(seed, other))));
            Set(features, DotFeature.LogStrength, Math.Log(Math.Max(1, rise * Math.Sqrt(area))));
        }

        /// <param name="view">The frame.</param>
        /// <param name="c">Grown, with its ring measured.</param>
        /// <param name="noise">Temporal noise, levels.</param>
        /// <param name="radius">What "around" means, working px.</param>
        /// <param name="features">Those of the surroundings are set.</param>
        public static void MeasureAround(in FrameView view, in Candidate c, double noise, int radius, Span<float> features)
        {
            Set(features, DotFeature.RingShare, c.RingShare);
            int size = Math.Max(c.Right - c.Left, c.Bottom - c.Top) + 1;
            int inner = Math.Max(4, size / 2), near = inner + Math.Max(6, size / 2);
            int threshold = Math.Max((int)(c.UnclippedRise(view) / 6), (int)(4 * noise) + 2), half = Math.Max(1, (c.PeakRelativeRise + 1) / 2);
            int least = c.LeastRise(view, noise, out int leastUnclipped);
            int brighter = 0, darker = 0, risen = 0, count = 0, darkerRing = 0, ring = 0;
            long nowRing = 0, beforeRing = 0;
            byte* past = view.Past(c.Plane);
            for (int y = Math.Max(0, c.Top - radius); y <= Math.Min(view.Height - 1, c.Bottom + radius); y += Step)
            {
                int dy = Math.Max(0, Math.Max(c.Top - y, y - c.Bottom));
                for (int x = Math.Max(0, c.Left - radius); x <= Math.Min(view.Width - 1, c.Right + radius); x += Step)
                {
                    int distance = Math.Max(dy, Math.Max(c.Left - x, x - c.Right));
                    if (distance <= inner)
                        continue;
                    int i = y * view.Width + x;
                    int level = FrameView.Level(view.Now[i], c.Plane), before = FrameView.Level(view.Before[i], c.Plane);
                    int change = view.IsBetweenPixels ? view.Change(i, c.Plane) : level - before;
                    count++;
                    if (change > threshold)
                        brighter++;
                    else if (change < -threshold)
                        darker++;
                    if (level > past[i] && view.HasRisen(i, c.Plane, half, least, leastUnclipped))
                        risen++;
                    if (distance > near)
                        continue;
                    ring++;
                    if (change < -threshold)
                        darkerRing++;
                    nowRing += level;
                    beforeRing += before;
                }
            }

            MeasureInside(view, c, half, out double nowInside, out double beforeInside);
            Set(features, DotFeature.BrightenedAround, Share(brighter, count));
            Set(features, DotFeature.DarkenedAround, Share(darker, count));
            Set(features, DotFeature.DarkenedRing, Share(darkerRing, ring));
            Set(features, DotFeature.RisenAround, Share(risen, count));
            Set(features, DotFeature.Asymmetry, Asymmetry(view, c));
            Set(features, DotFeature.ContrastNow, ring == 0 ? 0 : (nowInside - nowRing / (double)ring) / c.PeakRise);
            Set(features, DotFeature.ContrastBefore, ring == 0 ? 0 : (beforeInside - beforeRing / (double)ring) / c.PeakRise);
        }

        private static double Asymmetry(in FrameView view, in Candidate c)
        {
            int margin = Math.Max(2, (Math.Max(c.Right - c.Left, c.Bottom - c.Top) + 1) / 2);
            int acrossX = (int)(2 * c.CenterX + 0.5), acrossY = (int)(2 * c.CenterY + 0.5);
            long different = 0, all = 0;
            for (int y = Math.Max(0, c.Top - margin); y <= Math.Min(view.Height - 1, c.Bottom + margin); y++)
            {
                int mirroredY = acrossY - y;
                if (mirroredY < 0 || mirroredY >= view.Height)
                    continue;
                for (int x = Math.Max(0, c.Left - margin); x <= Math.Min(view.Width - 1, c.Right + margin); x++)
                {
                    int mirroredX = acrossX - x;
                    if (mirroredX < 0 || mirroredX >= view.Width)
                        continue;
                    int rise = view.RelativeRise(y * view.Width + x, c.Plane);
                    different += Math.Abs(rise - view.RelativeRise(mirroredY * view.Width + mirroredX, c.Plane));
                    all += rise;
                }
            }

            return different / (double)Math.Max(1, all);
        }

        private static void MeasureInside(in FrameView view, in Candidate c, int half, out double now, out double before)
        {
            long nowSum = 0, beforeSum = 0;
            int count = 0;
            for (int y = c.Top; y <= c.Bottom; y++)
            {
                for (int x = c.Left; x <= c.Right; x++)
                {
                    int i = y * view.Width + x;
                    if (view.RelativeRise(i, c.Plane) < half)
                        continue;
                    count++;
                    nowSum += FrameView.Level(view.Now[i], c.Plane);
                    beforeSum += FrameView.Level(view.Before[i], c.Plane);
                }
            }

            now = nowSum / (double)Math.Max(1, count);
            before = beforeSum / (double)Math.Max(1, count);
        }

        private static double Share(int part, int of) => of == 0 ? 0 : part / (double)of;

        private static void Set(Span<float> features, DotFeature feature, double value) => features[(int)feature] = (float)value;
    }
}
