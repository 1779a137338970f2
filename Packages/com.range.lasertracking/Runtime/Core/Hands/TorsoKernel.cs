using System;
using LaserTracking.Imaging;

namespace LaserTracking.Hands
{
    /// <summary>The loops over the cells of one surface that find the body in it.</summary>
    internal static unsafe partial class TorsoKernel
    {
        public const int ColumnBins = 160;
        public const int DepthBins = 240;
        public const double BinMm = 50;

        /// <summary>So much nearer than 0, and farther than the gate, a body may lie once its slope is taken off.</summary>
        public const double SlackMm = 1500;

        private const double MinHeightMm = 400;
        private const double OutstandingMm = 100;

        /// <summary>A body shows at least so much of what the largest of its surface shows; an arm a fifteenth.</summary>
        private const double BodyShare = 0.25;

        /// <summary>A camera turned up or down by 35°.</summary>
        private const double MaxSlope = 0.7;

        public static int ColumnOf(double xMm)
        {
            int column = (int)Math.Floor(xMm / BinMm) + ColumnBins / 2;
            return column < 0 ? 0 : column >= ColumnBins ? ColumnBins - 1 : column;
        }

        /// <summary>
        /// How z grows downwards on a standing body: the camera is seldom level. Least squares within the columns of space, so that
        /// several people at several distances do not look like a slope.
        /// </summary>
        public static double Slope(in TorsoBands work)
        {
            double slope = Slope(work, 0, double.MaxValue);
            // Once more without what stands out: an arm held before the chest tilts the body.
            return Slope(work, slope, OutstandingMm);
        }

        /// <summary>The body's distance by column: the median over a shoulder's width, weighted by area.</summary>
        public static void FindBody(in TorsoBands work)
        {
            // In variables: what is written through a pointer could be this very structure.
            int* cells = work.Cells, histogram = work.Histogram;
            float* distances = work.Z, rayX = work.RayX, rayY = work.RayY;
            int width = work.Width, count = work.CellCount, low = ColumnBins, high = -1;
            double slope = work.Slope, binMm = work.DepthBinMm;
            for (int i = 0; i < count; i++)
            {
                int cell = cells[i], row = cell / width;
                float z = distances[cell];
                int column = ColumnOf(rayX[cell - row * width] * z);
                if (column < low || column > high)
                    Widen(histogram, column, ref low, ref high);
                int depth = (int)((z - slope * rayY[row] * z + SlackMm) / binMm);
                histogram[column * DepthBins + Math.Max(0, Math.Min(DepthBins - 1, depth))] += 1 + (int)(z * z / 65536);
            }

            FindMedians(work, low, high);
            long most = 0;
            for (int column = low; column <= high; column++)
                most = Math.Max(most, work.Columns[column].Around);
            FillBesideBodies(work.Columns, low, high, (long)(most * BodyShare));
        }

        /// <summary>Takes in a column, and those up to it, with nothing counted there yet.</summary>
        private static void Widen(int* histogram, int column, ref int low, ref int high)
        {
            int from = high < 0 || column < low ? column : high + 1, end = high < 0 || column > high ? column + 1 : low;
            PixelMemory.Clear((byte*)(histogram + from * DepthBins), (end - from) * DepthBins * sizeof(int));
            low = Math.Min(low, column);
            high = Math.Max(high, column);
        }

        /// <summary>What stands out before its body goes a level on; the rest is torso.</summary>
        public static void MarkForward(in TorsoBands work)
        {
            int* cells = work.Cells;
            float* distances = work.Z, rayX = work.RayX, rayY = work.RayY, befores = work.Before;
            byte* levels = work.Levels;
            TorsoColumn* columns = work.Columns;
            int width = work.Width, count = work.CellCount;
            double slope = work.Slope;
            float forward = work.ForwardMm;
            byte nextLevel = work.NextLevel;
            for (int i = 0; i < count; i++)
            {
                int cell = cells[i], row = cell / width;
                float z = distances[cell];
                double x = rayX[cell - row * width] * z, y = rayY[row] * z;
                TorsoColumn* column = columns + ColumnOf(x);
                float before = (float)(column->BodyMm + slope * y) - z;
                befores[cell] = before;
                if (before > forward)
                {
                    levels[cell] = nextLevel;
                    continue;
                }

                column->Top = Math.Min(column->Top, (float)y);
                column->TorsoWeight += z * z;
                column->TorsoZ += (double)z * z * z;
            }
        }

        private static double Slope(in TorsoBands work, double slope, double limitMm)
        {
            bool isFirst = limitMm == double.MaxValue;
            for (int i = 0; i < ColumnBins; i++)
            {
                TorsoColumn* column = work.Columns + i;
                if (!isFirst)
                    column->Line = (column->Z - slope * column->Y) / column->Weight;
                column->Weight = column->Y = column->Z = 0;
            }

            double yy = 0, yz = 0;
            int* cells = work.Cells;
            float* distances = work.Z, rayX = work.RayX, rayY = work.RayY;
            TorsoColumn* columns = work.Columns;
            int width = work.Width, count = work.CellCount;
            for (int i = 0; i < count; i++)
            {
                int cell = cells[i], row = cell / width;
                double z = distances[cell], w = z * z, y = rayY[row] * z;
                TorsoColumn* column = columns + ColumnOf(rayX[cell - row * width] * z);
                if (!isFirst && column->Line + slope * y - z > limitMm)
                    continue;
                column->Weight += w;
                column->Y += w * y;
                column->Z += w * z;
                yy += w * y * y;
                yz += w * y * z;
            }

            double total = 0;
            for (int i = 0; i < ColumnBins; i++)
            {
                TorsoColumn* column = work.Columns + i;
                if (!(column->Weight > 0))
                    continue;
                total += column->Weight;
                yy -= column->Y * column->Y / column->Weight;
                yz -= column->Y * column->Z / column->Weight;
            }

            // Of a surface that is not high there is no telling.
            bool isHigh = yy > total * MinHeightMm * MinHeightMm / 12;
            return isHigh ? Math.Max(-MaxSlope, Math.Min(MaxSlope, yz / yy)) : 0;
        }

        /// <summary>A window as wide as shoulders slides over the columns; what it holds by depth is kept up to date, not counted anew.</summary>
        private static void FindMedians(in TorsoBands work, int low, int high)
        {
            int* window = work.Window;
            long total = 0;
            for (int d = 0; d < DepthBins; d++)
                window[d] = 0;
            for (int column = low - work.Reach; column <= high; column++)
            {
                int coming = column + work.Reach, going = column - work.Reach - 1;
                if (coming >= low && coming <= high)
                    total += Add(window, work.Histogram + coming * DepthBins, 1);
                if (going >= low)
                    total += Add(window, work.Histogram + going * DepthBins, -1);
                if (column < low)
                    continue;
                work.Columns[column].Around = total;
                work.Columns[column].BodyMm = (float)((Median(window, total) + 0.5) * work.DepthBinMm - SlackMm);
            }
        }

        private static long Add(int* window, int* column, int sign)
        {
            int sum = 0, d = 0;
#if NET8_0_OR_GREATER
            d = AddVector(window, column, sign, ref sum);
#endif
            for (; d < DepthBins; d++)
            {
                window[d] += sign * column[d];
                sum += column[d];
            }

            return sign * sum;
        }

        private static int Median(int* window, long total)
        {
            long sum = 0;
            int median = 0;
            while (median < DepthBins - 1 && (sum += window[median]) * 2 < total)
                median++;
            return median;
        }

        /// <summary>Where an arm reaches out beside the body, it would be its own torso: there counts the nearest column that has one.</summary>
        private static void FillBesideBodies(TorsoColumn* columns, int low, int high, long needed)
        {
            for (int column = low; column <= high; column++)
            {
                if (columns[column].Around >= needed)
                    continue;
                int step = 1;
                while (!IsBody(columns, column - step, low, high, needed) && !IsBody(columns, column + step, low, high, needed))
                    step++;
                columns[column].BodyMm = columns[IsBody(columns, column - step, low, high, needed) ? column - step : column + step].BodyMm;
            }
        }

        private static bool IsBody(TorsoColumn* columns, int column, int low, int high, long needed) =>
            column >= low && column <= high && columns[column].Around >= needed;
    }
}
