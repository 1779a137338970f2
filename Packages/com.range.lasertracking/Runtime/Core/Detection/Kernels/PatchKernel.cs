using System;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    /// <summary>The inner loops over the patches by which <see cref="GlobalChangeMeter"/> sees the whole picture move. One patch a call.</summary>
    internal static unsafe partial class PatchKernel
    {
        /// <summary>Side of what is compared, largest displacement looked for, side of what is read; working px.</summary>
        public const int Size = 32, Search = 5, Reach = Search + 1, Window = Size + 2 * Reach;

        internal const int Shifts = 2 * Search + 1, Slopes = Size + Shifts - 1;

        /// <summary>
        /// The patch in working size: green or luma, straight from the raw picture; the mean of two where one stands for two. Patches
        /// end a twelfth of the free width before the border: no pixel beyond an odd width is read.
        /// </summary>
        public static void Read(PictureView source, int left, int top, int factor, byte* patch)
        {
            int bytes = source.Format == PixelFormat.Bgra32 ? 4 : source.Format == PixelFormat.Yuy2 ? 2 : 1;
            long first = (long)left * factor * bytes + (source.Format == PixelFormat.Bgra32 ? 1 : 0);
#if NET8_0_OR_GREATER
            Announce(source, first, top, factor, Window * factor * bytes);
#endif
            for (int y = 0; y < Window; y++)
            {
                int line = (top + y) * factor;
                byte* row = source.Row(line < source.Height ? line : source.Height - 1) + first, to = patch + y * Window;
                int x = 0;
#if NET8_0_OR_GREATER
                x = ReadRowVector(row, bytes, factor, to);
#endif
                if (factor == 1)
                {
                    for (; x < Window; x++)
                        to[x] = row[x * bytes];
                }
                else
                {
                    for (; x < Window; x++)
                        to[x] = (byte)(row[2 * x * bytes] + row[(2 * x + 1) * bytes] + 1 >> 1);
                }
            }
        }

        /// <summary>Sums along the middle of each column and of each row of a patch.</summary>
        public static void SumUp(byte* patch, int* columns, int* rows)
        {
#if NET8_0_OR_GREATER
            if (SumUpVector(patch, columns, rows))
                return;
#endif
            for (int x = 0; x < Window; x++)
                columns[x] = 0;
            for (int y = 0; y < Window; y++)
            {
                byte* row = patch + y * Window;
                int sum = 0;
                for (int x = Reach; x < Reach + Size; x++)
                    sum += row[x];
                rows[y] = sum;
                if (y < Reach || y >= Reach + Size)
                    continue;
                for (int x = 0; x < Window; x++)
                    columns[x] += row[x];
            }
        }

        /// <summary>Displacement of the sums' slopes against the remembered ones, with fractions; NaN: nothing to hold on to.</summary>
        public static double Match(int* sums, float* reference, double gain, double noise)
        {
            double* slopes = stackalloc double[Slopes + 1], expected = stackalloc double[Size], differences = stackalloc double[Shifts + 1];
            for (int i = 0; i < Slopes; i++)
                slopes[i] = Slope(sums, Reach - Search + i);
            slopes[Slopes] = 0;
            for (int i = 0; i < Size; i++)
                expected[i] = reference[i] * gain;
            Compare(slopes, expected, differences);
            double best = double.PositiveInfinity, before = 0, after = 0, last = 0, sum = 0;
            int bestShift = 0;
            for (int shift = -Search; shift <= Search; shift++)
            {
                double difference = differences[Search + shift];
                sum += difference;
                if (difference < best)
                {
                    best = difference;
                    bestShift = shift;
                    before = last;
                    after = difference;
                }
                else if (shift == bestShift + 1)
                {
                    after = difference;
                }

                last = difference;
            }

            // Slopes must stand out of the noise; a clear minimum stands well below the average.
            double average = sum / Shifts;
            if (average < Size * (6 + 10 * noise) || best > 0.45 * average || bestShift == -Search || bestShift == Search)
                return double.NaN;
            double denominator = 2 * ((before > after ? before : after) - best);
            return bestShift + (denominator > 0 ? (before - after) / denominator : 0);
        }

        /// <summary>Sum of absolute differences for each displacement; one slope more, and room for one sum more, may be used.</summary>
        internal static void Compare(double* slopes, double* expected, double* differences)
        {
#if NET8_0_OR_GREATER
            if (CompareVector(slopes, expected, differences))
                return;
#endif
            for (int shift = 0; shift < Shifts; shift++)
            {
                double difference = 0;
                for (int i = 0; i < Size; i++)
                    difference += Math.Abs(slopes[shift + i] - expected[i]);
                differences[shift] = difference;
            }
        }

        /// <summary>Reach leaves a place on either side of the outermost displacement.</summary>
        public static int Slope(int* sums, int at) => sums[at + 1] - sums[at - 1];
    }
}
