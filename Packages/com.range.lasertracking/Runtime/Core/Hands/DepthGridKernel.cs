namespace LaserTracking.Hands
{
    /// <summary>The inner loops over a depth picture.</summary>
    internal static unsafe partial class DepthGridKernel
    {
        /// <summary>
        /// One row of cells out of four pixels each: the mean of those that lie on the nearest surface. Taking the nearest and not
        /// the mean of all keeps an arm's edge from being pulled towards what is behind it.
        /// </summary>
        public static void Row(ushort* top, ushort* bottom, int cells, int stepPx, int first, int second, float near, float far,
            float surfaceStep, float* z, bool* lost)
        {
            int lowest = (int)near, highest = (int)far, band = (int)surfaceStep;
            if (lowest < 1)
                lowest = 1;
            int cell = 0;
#if NET8_0_OR_GREATER
            cell = RowVector(top, bottom, cells, stepPx, first, second, lowest, highest, band, z, lost);
#endif
            for (; cell < cells; cell++)
            {
                int left = cell * stepPx + first, right = cell * stepPx + second;
                int a = top[left], b = top[right], c = bottom[left], d = bottom[right];
                lost[cell] = (a | b | c | d) == 0;
                a = a < lowest ? int.MaxValue : a;
                b = b < lowest ? int.MaxValue : b;
                c = c < lowest ? int.MaxValue : c;
                d = d < lowest ? int.MaxValue : d;
                int ab = a < b ? a : b, cd = c < d ? c : d;
                int nearest = ab < cd ? ab : cd;
                if (nearest > highest)
                {
                    z[cell] = 0;
                    continue;
                }

                int limit = nearest + band, sum = 0, count = 0;
                if (a <= limit) { sum += a; count++; }
                if (b <= limit) { sum += b; count++; }
                if (c <= limit) { sum += c; count++; }
                if (d <= limit) { sum += d; count++; }
                z[cell] = sum / (float)count;
            }
        }

        /// <summary>
        /// Fills holes of one line of cells (stride apart) that are shorter than reach/z cells and lie between two cells at nearly
        /// one distance. What was measured to be elsewhere is never filled, only what is lost.
        /// </summary>
        public static void Bridge(float* z, bool* lost, int count, int stride, float reach, float surfaceStep)
        {
            int last = -1;
            bool onlyLost = true;
            for (int i = 0; i < count; i++)
            {
                float here = z[i * stride];
                if (here == 0)
                {
                    onlyLost &= lost[i * stride];
                    continue;
                }

                int gap = i - last - 1;
                if (gap > 0 && last >= 0 && onlyLost)
                {
                    float before = z[last * stride];
                    float difference = here - before;
                    if (difference < surfaceStep && -difference < surfaceStep && gap * here <= reach)
                    {
                        for (int k = last + 1; k < i; k++)
                        {
                            z[k * stride] = before + difference * (k - last) / (i - last);
                            lost[k * stride] = false;
                        }
                    }
                }

                last = i;
                onlyLost = true;
            }
        }
    }
}
