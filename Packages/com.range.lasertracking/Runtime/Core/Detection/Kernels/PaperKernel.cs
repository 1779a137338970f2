using System;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Rows of the published algorithm's float pictures. Scalar and vector form do the same operations in the same order, so that
    /// they agree to the bit.
    /// </summary>
    internal static unsafe partial class PaperKernel
    {
        /// <summary>Area average of B G R A rows: intensity (luma, BT.601) and green excess of each reduced pixel.</summary>
        /// <param name="rows">The source rows that one reduced row covers, one after the other.</param>
        /// <param name="rowCount">How many.</param>
        /// <param name="strideBytes">From one to the next.</param>
        /// <param name="edges">Left border of each reduced pixel in source pixels; one more for the right border of the last.</param>
        /// <param name="width">Reduced pixels.</param>
        /// <param name="intensity">Result.</param>
        /// <param name="excess">Result.</param>
        /// <param name="useVectors">Explicit vector instructions where there are some.</param>
        public static void Reduce(byte* rows, int rowCount, long strideBytes, int* edges, int width, float* intensity, float* excess, bool useVectors)
        {
            int done = 0;
#if NET8_0_OR_GREATER
            if (useVectors && rowCount == 2 && edges[width] == 2 * width)
                done = HalveVector(rows, strideBytes, width, intensity, excess);
#endif
            for (int x = done; x < width; x++)
            {
                uint b = 0, g = 0, r = 0;
                int left = edges[x], right = Math.Max(left + 1, edges[x + 1]);
                for (int y = 0; y < rowCount; y++)
                {
                    uint* source = (uint*)(rows + y * strideBytes);
                    for (int sx = left; sx < right; sx++)
                    {
                        uint pixel = source[sx];
                        b += pixel & 255;
                        g += pixel >> 8 & 255;
                        r += pixel >> 16 & 255;
                    }
                }

                float scale = 1f / (rowCount * (right - left));
                float blue = b * scale, green = g * scale, red = r * scale;
                intensity[x] = 0.114f * blue + 0.587f * green + 0.299f * red;
                excess[x] = Math.Max(0, green - 0.5f * (red + blue));
            }
        }

        /// <summary>|I − B| into difference and αB + (1-α)I into the next background, which may be the same memory.</summary>
        public static void Differ(float* intensity, float* background, float* next, int width, float alpha, float* difference, bool useVectors)
        {
            int done = 0;
#if NET8_0_OR_GREATER
            if (useVectors)
                done = DifferVector(intensity, background, next, width, alpha, difference);
#endif
            for (int x = done; x < width; x++)
            {
                float before = background[x];
                difference[x] = Math.Abs(intensity[x] - before);
                next[x] = alpha * before + (1 - alpha) * intensity[x];
            }
        }

        /// <summary>(1 2 1) / 4 along a row, edges repeated. Source and target are different rows.</summary>
        public static void BlurRow(float* source, int width, float* target, bool useVectors)
        {
            target[0] = (source[0] + 2 * source[0] + source[width > 1 ? 1 : 0]) * 0.25f;
            int done = 1;
#if NET8_0_OR_GREATER
            if (useVectors)
                done = BlurRowVector(source, width, target);
#endif
            for (int x = done; x < width; x++)
                target[x] = (source[x - 1] + 2 * source[x] + source[x + 1 < width ? x + 1 : x]) * 0.25f;
        }

        /// <summary>(1 2 1) / 4 across three rows.</summary>
        public static void BlurColumns(float* above, float* middle, float* below, int width, float* target, bool useVectors)
        {
            int done = 0;
#if NET8_0_OR_GREATER
            if (useVectors)
                done = BlurColumnsVector(above, middle, below, width, target);
#endif
            for (int x = done; x < width; x++)
                target[x] = (above[x] + 2 * middle[x] + below[x]) * 0.25f;
        }

        /// <summary>Spike map M ← max(difference, γM) and score S = wₘ M + wₑ E.</summary>
        public static void Score(float* difference, float* excess, float* spike, int width, float gamma, float spikeWeight, float excessWeight, float* score, bool useVectors)
        {
            int done = 0;
#if NET8_0_OR_GREATER
            if (useVectors)
                done = ScoreVector(difference, excess, spike, width, gamma, spikeWeight, excessWeight, score);
#endif
            for (int x = done; x < width; x++)
            {
                spike[x] = Math.Max(difference[x], gamma * spike[x]);
                score[x] = spikeWeight * spike[x] + excessWeight * excess[x];
            }
        }

        /// <summary>The first pixel from a place on that reaches both limits and exceeds a score, or count when there is none.</summary>
        public static int FindCandidate(float* score, float* excess, int start, int count, float minScore, float minExcess, float above, bool useVectors)
        {
            int i = start;
#if NET8_0_OR_GREATER
            if (useVectors)
                i = FindCandidateVector(score, excess, start, count, minScore, minExcess, above);
#endif
            while (i < count && (score[i] < minScore || excess[i] < minExcess || score[i] <= above))
                i++;
            return i;
        }
    }
}
