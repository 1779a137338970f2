#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LaserTracking.Detection
{
    internal static unsafe partial class EnvelopeKernel
    {
        /// <summary>Whole blocks of 32 pixels; returns how many are done. 0 where the processor lacks 256-bit vectors.</summary>
        private static int RowVector(
            uint* pixels, int width, byte decay, byte* oldMin, byte* newMin, byte* oldMax, byte* newMax, byte* columnMin, byte* columnMax)
        {
            if (!Avx2.IsSupported)
                return 0;
            Vector256<byte> step = Vector256.Create(decay);
            int x = 0;
            for (; x + 32 <= width; x += 32)
            {
                Vector256<uint> a = Avx.LoadVector256(pixels + x);
                Vector256<uint> b = Avx.LoadVector256(pixels + x + 8);
                Vector256<uint> c = Avx.LoadVector256(pixels + x + 16);
                Vector256<uint> d = Avx.LoadVector256(pixels + x + 24);
                Vector256<byte> smallest = LevelVectors.Of(a, b, c, d, DetectionPlane.Smallest);
                Vector256<byte> largest = LevelVectors.Of(a, b, c, d, DetectionPlane.Largest);
                Block(smallest, step, oldMin + x, newMin + x, columnMin + x);
                Block(largest, step, oldMax + x, newMax + x, columnMax + x);
            }

            return x;
        }

        private static void Block(Vector256<byte> level, Vector256<byte> decay, byte* old, byte* next, byte* column)
        {
            Vector256<byte> envelope = Avx.LoadVector256(old);
            Vector256<byte> headroom = Avx2.ShiftRightLogical(Avx2.Xor(envelope, Vector256<byte>.AllBitsSet).AsUInt16(), HeadroomShift).AsByte()
                & Vector256.Create((byte)(0xFF >> HeadroomShift));
            Vector256<byte> onset = Avx2.SubtractSaturate(Avx2.SubtractSaturate(level, envelope), headroom);
            Avx.Store(next, Avx2.Max(level, Avx2.SubtractSaturate(envelope, decay)));
            Avx.Store(column, Avx2.Max(Avx.LoadVector256(column), onset));
        }
    }
}
#endif
