#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
#endif

namespace LaserTracking.Detection
{
    /// <summary>
    /// Numbers that the cells of the screen's grid have for blue, green and red, between the middles of the cells, as levels. Scalar and
    /// vector form agree to the bit.
    /// </summary>
    internal static unsafe class CellBlend
    {
        /// <summary>From a cell's numbers to those of the one below.</summary>
        private const int Down = 3 * ScreenGrid.Columns;

        /// <summary>Numbers of all cells, and one more: vectors of four read it.</summary>
        public const int Length = 3 * ScreenGrid.CellCount + 1;

        /// <summary>Where a pixel of a row or column of so many lies, counted in middles of cells; a little before the last one at most.</summary>
        public static double Place(int pixel, int pixels, int cells)
        {
            double place = (pixel + 0.5) * cells / pixels - 0.5;
            return place < 0 ? 0 : place > cells - 1.001 ? cells - 1.001 : place;
        }

        public static int Level(double value) => value < 0 ? 0 : value > 255 ? 255 : (int)(value + 0.5);

        /// <summary>Blue, green, red, 0 of factor × blend + start for some rows of one column of a picture.</summary>
        /// <param name="cells">Numbers of all cells.</param>
        /// <param name="column">Place among the columns of cells.</param>
        /// <param name="rows">Places of the picture's rows among the rows of cells.</param>
        /// <param name="count">How many of them.</param>
        /// <param name="factor">On the blend.</param>
        /// <param name="start">Added to that.</param>
        /// <param name="target">Pixel of the first row.</param>
        /// <param name="width">Pixels from one row to the next.</param>
        /// <param name="useVectors">False: the scalar form.</param>
        public static void Column(double* cells, double column, double* rows, int count, double factor, double start, uint* target, int width, bool useVectors)
        {
            int left = (int)column;
            double right = column - left;
            cells += 3 * left;
#if NET8_0_OR_GREATER
            if (useVectors && Avx2.IsSupported)
            {
                ColumnVector(cells, right, rows, count, factor, start, target, width);
                return;
            }
#endif
            for (int y = 0; y < count; y++, target += width)
            {
                int top = (int)rows[y];
                double* cell = cells + top * Down;
                uint levels = 0;
                for (int channel = 0; channel < 3; channel++, cell++)
                {
                    double upper = cell[0] + right * (cell[3] - cell[0]), lower = cell[Down] + right * (cell[Down + 3] - cell[Down]);
                    levels |= (uint)Level((upper + (rows[y] - top) * (lower - upper)) * factor + start) << 8 * channel;
                }

                *target = levels;
            }
        }

#if NET8_0_OR_GREATER
        private static void ColumnVector(double* cells, double right, double* rows, int count, double factor, double start, uint* target, int width)
        {
            int above = -1;
            Vector256<double> upper = default, fall = default, factors = Vector256.Create(factor), starts = Vector256.Create(start);
            Vector256<double> most = Vector256.Create(255.0), half = Vector256.Create(0.5);
            for (int y = 0; y < count; y++, target += width)
            {
                int top = (int)rows[y];
                if (top != above)
                {
                    above = top;
                    upper = Between(cells + top * Down, right);
                    fall = Between(cells + (top + 1) * Down, right) - upper;
                }

                Vector256<double> value = (upper + Vector256.Create(rows[y] - top) * fall) * factors + starts;
                Vector128<int> levels = Avx.ConvertToVector128Int32WithTruncation(Avx.Min(Avx.Max(value, Vector256<double>.Zero), most) + half);
                *target = Sse2.PackUnsignedSaturate(Sse2.PackSignedSaturate(levels, levels), Vector128<short>.Zero).AsUInt32().ToScalar() & 0xFFFFFF;
            }
        }

        /// <summary>Of blue, green, red; and a fourth number that means nothing.</summary>
        private static Vector256<double> Between(double* cell, double right)
        {
            Vector256<double> left = Avx.LoadVector256(cell);
            return left + Vector256.Create(right) * (Avx.LoadVector256(cell + 3) - left);
        }
#endif
    }
}
