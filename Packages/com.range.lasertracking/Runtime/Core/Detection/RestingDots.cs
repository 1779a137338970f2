using System;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Finds the dots of the last frame that rest again, before anything new is looked for. Where the picture behind one has changed its rise above its
    /// pixels' past says nothing, but it still stands out from what lies around it. That is made its past, so that it is grown and
    /// measured like any other dot.
    /// </summary>
    internal sealed unsafe class RestingDots
    {
        /// <summary>Microseconds for which a dot is looked for where its surroundings leave no room to see it; no longer than it had been on.</summary>
        private const long MaxHiddenUs = 1_000_000;

        /// <summary>Working px by which a resting dot may have moved, or been misplaced by what passed behind it.</summary>
        private const int MaxStep = 3;

        /// <summary>Share of the surroundings above which the dot has to stand.</summary>
        private const double RingQuantile = 0.9;

        private readonly int[] _histogram = new int[256];
        private readonly BlobMeasurer _blobs;
        private readonly DotMemory _memory;

        /// <param name="blobs">Grows what is found.</param>
        /// <param name="memory">The dots of the last frame.</param>
        public RestingDots(BlobMeasurer blobs, DotMemory memory)
        {
            _blobs = blobs;
            _memory = memory;
        }

        /// <summary>The next dot that still rests; dots that cannot be seen but may be there are kept in memory.</summary>
        /// <param name="view">The frame. Where a dot is looked for its past becomes what is around it.</param>
        /// <param name="noise">Temporal noise, levels.</param>
        /// <param name="timeUs">Of the frame, microseconds.</param>
        /// <param name="index">Where to begin to look: 0 in the first call; where it was left afterwards.</param>
        /// <param name="candidate">Grown and measured.</param>
        /// <param name="known">The dot that it is.</param>
        public bool TryFind(in FrameView view, double noise, long timeUs, ref int index, out Candidate candidate, out RememberedDot known)
        {
            while (_memory.TryNextLost(ref index, out known))
            {
                if (!known.IsResting || !known.IsConclusive)
                    continue;
                if (!known.IsHidden && IsAsBefore(view, known, noise))
                {
                    if (Stands(view, known, noise, out candidate))
                        return true;
                    continue;
                }

                RememberedDot place = known.Within(MaxStep);
                if (HasGoneOut(view, place, noise, out bool isSameAround))
                    continue;
                Fill(view, view.OldSmallest, place, RingLevel(view, view.Now, place, DetectionPlane.Smallest, RingQuantile));
                Fill(view, view.OldLargest, place, RingLevel(view, view.Now, place, DetectionPlane.Largest, RingQuantile));
                if (Stands(view, place, noise, out candidate) && IsNear(candidate, known))
                    return true;
                if ((known.IsHidden || !isSameAround) && timeUs - known.LastTimeUs < Math.Min(MaxHiddenUs, known.LastTimeUs - known.FirstTimeUs))
                    _memory.AddHidden(known);
            }

            candidate = default;
            return false;
        }

        /// <summary>Its surroundings are as their past says: a light that does not rise above that is out, whatever else stands there.</summary>
        private static bool IsAsBefore(in FrameView view, in RememberedDot dot, double noise)
        {
            double tolerance = 4 * noise + 4;
            int changed = 0, count = 0;
            for (int n = 0; n < RingLength(dot); n++)
            {
                int i = RingPixel(view, dot, n);
                if (i < 0)
                    continue;
                count++;
                if (Math.Abs(view.Rise(i, dot.Plane)) > tolerance)
                    changed++;
            }

            return changed <= (1 - RingQuantile) * count;
        }

        /// <summary>While nothing changed around it, it came down by half of what it had risen.</summary>
        private bool HasGoneOut(in FrameView view, in RememberedDot dot, double noise, out bool isSameAround)
        {
            isSameAround = IsSame(view, dot, RingQuantile, noise) && IsSame(view, dot, 0.5, noise) && IsSame(view, dot, 1 - RingQuantile, noise);
            return isSameAround && PeakLevel(view, view.Before, dot) - PeakLevel(view, view.Now, dot) > dot.PeakRise / 2;
        }

        private bool IsSame(in FrameView view, in RememberedDot dot, double quantile, double noise) =>
            Math.Abs(RingLevel(view, view.Now, dot, dot.Plane, quantile) - RingLevel(view, view.Before, dot, dot.Plane, quantile)) <= 4 * noise + 2;

        /// <summary>Its light rises above its past half as far as before at least, in one piece of its size.</summary>
        private bool Stands(in FrameView view, in RememberedDot dot, double noise, out Candidate candidate)
        {
            candidate = new Candidate { Plane = dot.Plane, SeedX = -1, MayBeContent = dot.MayBeContent };
            for (int y = Math.Max(0, dot.Top + 1); y <= Math.Min(view.Height - 1, dot.Bottom - 1); y++)
            {
                for (int x = Math.Max(0, dot.Left + 1); x <= Math.Min(view.Width - 1, dot.Right - 1); x++)
                {
                    int rise = view.RelativeRise(y * view.Width + x, dot.Plane);
                    if (rise <= candidate.PeakRelativeRise || _memory.IsLit(x, y))
                        continue;
                    candidate.PeakRelativeRise = rise;
                    candidate.SeedX = x;
                    candidate.SeedY = y;
                }
            }

            if (2 * candidate.PeakRelativeRise < dot.PeakRelativeRise || candidate.SeedX < 0)
                return false;
            candidate.PeakRise = view.Rise(candidate.SeedY * view.Width + candidate.SeedX, dot.Plane);
            _blobs.Begin();
            _blobs.Grow(view, ref candidate);
            if (!dot.GoesOnAs(candidate))
                return false;
            candidate.LogOdds = dot.LogOdds;
            candidate.IsConclusive = true;
            SurroundingsMeasurer.ColorRise(view, ref candidate);
            SurroundingsMeasurer.Ring(view, ref candidate, noise);
            return true;
        }

        /// <summary>No farther from where it was than a resting dot goes.</summary>
        private static bool IsNear(in Candidate candidate, in RememberedDot dot) =>
            Math.Abs(candidate.CenterX - 0.5 * (dot.Left + dot.Right)) <= MaxStep && Math.Abs(candidate.CenterY - 0.5 * (dot.Top + dot.Bottom)) <= MaxStep;

        private static void Fill(in FrameView view, byte* past, in RememberedDot dot, int level)
        {
            int left = Math.Max(0, dot.Left), right = Math.Min(view.Width - 1, dot.Right);
            for (int y = Math.Max(0, dot.Top); y <= Math.Min(view.Height - 1, dot.Bottom); y++)
                new Span<byte>(past + y * view.Width + left, right - left + 1).Fill((byte)level);
        }

        /// <summary>What this share of the box's border does not exceed.</summary>
        private int RingLevel(in FrameView view, uint* picture, in RememberedDot dot, DetectionPlane plane, double quantile)
        {
            Array.Clear(_histogram, 0, _histogram.Length);
            int count = 0;
            for (int n = 0; n < RingLength(dot); n++)
            {
                int i = RingPixel(view, dot, n);
                if (i < 0)
                    continue;
                _histogram[FrameView.Level(picture[i], plane)]++;
                count++;
            }

            int level = 0;
            for (int below = _histogram[0]; below < quantile * count && level < 255; below += _histogram[level])
                level++;
            return level;
        }

        /// <summary>Pixels of the box's border, those beyond the picture's edge included.</summary>
        private static int RingLength(in RememberedDot dot) => 2 * (dot.Right - dot.Left + dot.Bottom - dot.Top);

        /// <summary>The index of one of them, clockwise from the upper left; -1 beyond the picture's edge.</summary>
        private static int RingPixel(in FrameView view, in RememberedDot dot, int n)
        {
            int across = dot.Right - dot.Left, down = dot.Bottom - dot.Top, half = across + down;
            int along = n % half, dx = Math.Min(along, across), dy = along - dx;
            int x = n < half ? dot.Left + dx : dot.Right - dx, y = n < half ? dot.Top + dy : dot.Bottom - dy;
            return x < 0 || y < 0 || x >= view.Width || y >= view.Height ? -1 : y * view.Width + x;
        }

        private static int PeakLevel(in FrameView view, uint* picture, in RememberedDot dot)
        {
            int peak = 0;
            for (int y = Math.Max(0, dot.Top); y <= Math.Min(view.Height - 1, dot.Bottom); y++)
            {
                for (int x = Math.Max(0, dot.Left); x <= Math.Min(view.Width - 1, dot.Right); x++)
                    peak = Math.Max(peak, FrameView.Level(picture[y * view.Width + x], dot.Plane));
            }

            return peak;
        }
    }
}
