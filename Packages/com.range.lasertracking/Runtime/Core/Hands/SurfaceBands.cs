using System;
using System.Runtime.CompilerServices;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Hands
{
    /// <summary>
    /// The next connected surface of a depth grid among the cells of one level, and what is known of it at a glance. One band: cells
    /// follow from one another.
    /// </summary>
    internal unsafe struct SurfaceBands : IKernelBands
    {
        public int Width;
        public int Height;

        /// <summary>Neighbours on one surface differ by no more.</summary>
        public float StepMm;
        public byte Level;

        /// <summary>Cells from which a surface may grow; null: all, in order.</summary>
        public int* Seeds;
        public int SeedCount;
        public float* Z;
        public float* RayX;

        /// <summary>How far a cell stands out before its body.</summary>
        public float* Before;

        /// <summary>At which level a cell waits to be gathered; 0 once it is.</summary>
        public byte* Levels;

        /// <summary>Gathered cells, the nearest steps first.</summary>
        public int* Cells;

        /// <summary>Seeds looked at so far.</summary>
        public int Next;

        /// <summary>Cells in the list so far; the new surface's are the last <see cref="Count"/>.</summary>
        public int Used;

        /// <summary>0: no surface is left.</summary>
        public int Count;

        /// <summary>Sum of z², and of x z².</summary>
        public double Area;
        public double SumX;
        public float NearestMm;
        public float ReachMm;

        public void Execute(int band)
        {
            Count = 0;
            int* seeds = Seeds;
            byte* levels = Levels;
            byte level = Level;
            int next = Next, count = SeedCount;
            while (Count == 0 && next < count)
            {
                if (seeds == null)
                    next += PixelMemory.Find(levels + next, count - next, level);
                if (next == count)
                    break;
                int seed = seeds == null ? next : seeds[next];
                next++;
                if (levels[seed] == level)
                    Grow(seed);
            }

            Next = next;
        }

        private void Grow(int seed)
        {
            int first = Used, next = Used, used = Used, width = Width, height = Height;
            int* cells = Cells;
            float* z = Z, rayX = RayX, before = Before;
            byte* levels = Levels;
            byte level = Level;
            float step = StepMm;
            double area = 0, sumX = 0;
            float nearest = float.MaxValue, reach = 0;
            cells[used++] = seed;
            levels[seed] = 0;
            while (next < used)
            {
                int cell = cells[next++], y = cell / width, x = cell - y * width;
                float here = z[cell];
                area += (double)here * here;
                sumX += (double)here * here * here * rayX[x];
                nearest = Math.Min(nearest, here);
                reach = Math.Max(reach, before[cell]);
                if (x > 0 && IsPart(levels, z, cell - 1, level, here, step))
                    cells[used++] = cell - 1;
                if (x + 1 < width && IsPart(levels, z, cell + 1, level, here, step))
                    cells[used++] = cell + 1;
                if (y > 0 && IsPart(levels, z, cell - width, level, here, step))
                    cells[used++] = cell - width;
                if (y + 1 < height && IsPart(levels, z, cell + width, level, here, step))
                    cells[used++] = cell + width;
            }

            Used = used;
            Count = used - first;
            Area = area;
            SumX = sumX;
            NearestMm = nearest;
            ReachMm = reach;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static bool IsPart(byte* levels, float* z, int cell, byte level, float here, float step)
        {
            if (levels[cell] != level || Math.Abs(z[cell] - here) > step)
                return false;
            levels[cell] = 0;
            return true;
        }
    }
}
