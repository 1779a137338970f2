#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics.X86;
#endif

namespace LaserTracking.Detection
{
    /// <summary>
    /// From rendered pictures to what the camera should see at most: maximum over pictures, dilation, tone curve with local gain and
    /// offset, mapping into the camera's picture, and what exceeds it. Pixels are blue, green, red, (any) bytes. Scalar form here,
    /// vectors in the other part; equal to the bit.
    /// </summary>
    internal static unsafe partial class ExpectationKernel
    {
        /// <summary>Pixels by which bright places are widened to each side.</summary>
        public const int Reach = 2;

        /// <summary>Tone tables: start and rise of 16 segments of 16 levels for blue, green, red, in this order.</summary>
        public const int ToneBytes = 3 * 2 * 16;

        /// <summary>The largest of each byte over some rows, one or more, from the offset on.</summary>
        public static void Brightest(uint** rows, int count, long offset, int width, uint* target, bool useVectors)
        {
            int x = 0;
#if NET8_0_OR_GREATER
            if (useVectors)
                x = BrightestVector(rows, count, offset, width, target);
#endif
            for (; x < width; x++)
            {
                uint largest = rows[0][offset + x];
                for (int i = 1; i < count; i++)
                    largest = Max(rows[i][offset + x], largest);
                target[x] = largest;
            }
        }

        /// <summary>The maximum over 5 pixels in a row. The pad is the row with <see cref="Reach"/> pixels of zero before and after.</summary>
        public static void Widen(uint* pad, int width, uint* target, bool useVectors)
        {
            int x = 0;
#if NET8_0_OR_GREATER
            if (useVectors)
                x = WidenVector(pad, width, target);
#endif
            for (; x < width; x++)
                target[x] = Max(Max(Max(pad[x], pad[x + 1]), Max(pad[x + 2], pad[x + 3])), pad[x + 4]);
        }

        /// <summary>In place: the tone curve, then gain (128 = 1) and offset (128 = 0) of each byte. The curve must not fall.</summary>
        public static void Transfer(uint* row, int width, byte* tone, uint* gain, uint* offset, bool useVectors)
        {
            int x = 0;
#if NET8_0_OR_GREATER
            if (useVectors)
                x = TransferVector(row, width, tone, gain, offset);
#endif
            for (; x < width; x++)
            {
                uint result = 0;
                for (int channel = 0; channel < 3; channel++)
                {
                    int shift = 8 * channel, level = (int)(row[x] >> shift & 255);
                    byte* start = tone + 32 * channel;
                    int value = start[level >> 4] + (start[16 + (level >> 4)] * (level & 15) >> 4);
                    value = (value * (int)(gain[x] >> shift & 255) >> 7) + (int)(offset[x] >> shift & 255) - 128;
                    result |= (uint)(value < 0 ? 0 : value > 255 ? 255 : value) << shift;
                }

                row[x] = result;
            }
        }

        /// <summary>Twice in a row each pixel that the indices name.</summary>
        public static void Gather(uint* source, int* indices, int count, uint* target, bool useVectors)
        {
            int i = 0;
#if NET8_0_OR_GREATER
            if (useVectors)
                i = GatherVector(source, indices, count, target);
#endif
            for (; i < count; i++)
                target[2 * i] = target[2 * i + 1] = source[indices[i]];
        }

        /// <summary>
        /// The most by which a channel exceeds the expected, taken from the pixel's largest channel, is the reference: rising above it
        /// is exceeding the expected. The largest excess by column is raised, never cleared here.
        /// </summary>
        public static void Exceed(uint* now, uint* expected, int width, byte* reference, byte* column, bool useVectors)
        {
            int x = 0;
#if NET8_0_OR_GREATER
            if (useVectors)
                x = ExceedVector(now, expected, width, reference, column);
#endif
            for (; x < width; x++)
            {
                int largest = 0, excess = 0;
                for (int shift = 0; shift < 24; shift += 8)
                {
                    int level = (int)(now[x] >> shift & 255), above = level - (int)(expected[x] >> shift & 255);
                    largest = level > largest ? level : largest;
                    excess = above > excess ? above : excess;
                }

                reference[x] = (byte)(largest - excess);
                column[x] = (byte)(excess > column[x] ? excess : column[x]);
            }
        }

        /// <summary>The most by which a channel of a pixel, or of one of its four neighbours this far off, differs from a value.</summary>
        public static int Apart(uint value, uint* pixel, int reach, int width, bool useVectors)
        {
#if NET8_0_OR_GREATER
            if (useVectors && Sse41.IsSupported)
                return ApartVector(value, pixel, reach, width);
#endif
            return Larger(Larger(Difference(value, *pixel), Larger(Difference(value, pixel[-reach]), Difference(value, pixel[reach]))),
                Larger(Difference(value, pixel[-reach * width]), Difference(value, pixel[reach * width])));
        }

        /// <summary>The largest of the three channels' differences.</summary>
        private static int Difference(uint a, uint b)
        {
            int blue = (int)(a & 255) - (int)(b & 255), green = (int)(a >> 8 & 255) - (int)(b >> 8 & 255), red = (int)(a >> 16 & 255) - (int)(b >> 16 & 255);
            return Larger(blue < 0 ? -blue : blue, Larger(green < 0 ? -green : green, red < 0 ? -red : red));
        }

        private static int Larger(int a, int b) => a > b ? a : b;

        private static uint Max(uint a, uint b)
        {
            uint blue = (a & 0xFFu) > (b & 0xFFu) ? a & 0xFFu : b & 0xFFu;
            uint green = (a & 0xFF00u) > (b & 0xFF00u) ? a & 0xFF00u : b & 0xFF00u;
            uint red = (a & 0xFF0000u) > (b & 0xFF0000u) ? a & 0xFF0000u : b & 0xFF0000u;
            uint alpha = (a & 0xFF000000u) > (b & 0xFF000000u) ? a & 0xFF000000u : b & 0xFF000000u;
            return blue | green | red | alpha;
        }
    }
}
