#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LaserTracking.Detection
{
    internal static unsafe partial class TileKernel
    {
        /// <summary>Whole pairs of tiles; returns how many tiles are done. 0 where the processor lacks 256-bit vectors.</summary>
        private static int BrightestVector(byte* band, long stride, int rows, int width, ushort* tiles)
        {
            if (!Avx2.IsSupported)
                return 0;
            int tile = 0;
            for (; tile + 2 <= width / Size; tile += 2)
            {
                byte* column = band + tile * Size * sizeof(ushort);
                Vector256<ushort> largest = Vector256<ushort>.Zero;
                for (int y = 0; y < rows; y++)
                {
                    // Memory is asked for the next band meanwhile: so many rows at once no processor foresees.
                    Sse.Prefetch0(column + (y + rows) * stride);
                    largest = Avx2.Max(largest, Avx.LoadVector256((ushort*)(column + y * stride)));
                }

                // The instruction looks for the smallest of eight.
                tiles[tile] = (ushort)~Sse41.MinHorizontal(~largest.GetLower()).ToScalar();
                tiles[tile + 1] = (ushort)~Sse41.MinHorizontal(~largest.GetUpper()).ToScalar();
            }

            return tile;
        }

        /// <summary>Whole tiles; returns how many are done. 0 where the processor lacks 256-bit vectors.</summary>
        private static int GreenestVector(byte* band, long stride, int rows, int width, byte* tiles)
        {
            if (!Avx2.IsSupported)
                return 0;
            int whole = width / Size;
            for (int tile = 0; tile < whole; tile++)
            {
                byte* column = band + tile * Size * sizeof(uint);
                Vector256<byte> largest = Vector256<byte>.Zero;
                for (int y = 0; y < rows; y++)
                {
                    Vector256<byte> pixels = Avx.LoadVector256(column + y * stride);
                    Vector256<byte> shifted = Avx2.ShiftRightLogical(pixels.AsUInt32(), 8).AsByte();

                    // Lowest byte of each pixel: green minus blue, and green minus red.
                    Vector256<byte> overBlue = Avx2.SubtractSaturate(shifted, pixels);
                    Vector256<byte> overRed = Avx2.ShiftRightLogical(Avx2.SubtractSaturate(pixels, shifted).AsUInt32(), 8).AsByte();
                    largest = Avx2.Max(largest, Avx2.Min(overBlue, overRed));
                }

                Vector128<byte> half = Sse2.Max(largest.GetLower(), largest.GetUpper());
                half = Sse2.Max(half, Sse2.ShiftRightLogical128BitLane(half, 8));
                half = Sse2.Max(half, Sse2.ShiftRightLogical128BitLane(half, 4));
                tiles[tile] = half.ToScalar();
            }

            return whole;
        }
    }
}
#endif
