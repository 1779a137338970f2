#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LaserTracking.Detection
{
    internal static unsafe partial class RiseKernel
    {
        /// <summary>Whole pairs of rows; returns how many rows are done. 0 where the processor lacks 256-bit vectors.</summary>
        private static int TileVector(uint* now, byte* past, int stride, DetectionPlane plane, int* reciprocal, int height, byte* rises, byte* peaks)
        {
            if (!Avx2.IsSupported)
                return 0;
            int y = 0;
            for (; y + 2 <= height; y += 2, now += 2 * stride, past += 2 * stride, rises += 2 * TileGrid.Size)
            {
                Vector256<byte> level = LevelVectors.Of(
                    Avx.LoadVector256(now), Avx.LoadVector256(now + 8), Avx.LoadVector256(now + stride), Avx.LoadVector256(now + stride + 8), plane);
                Vector256<byte> envelope = Vector256.Create(Sse2.LoadVector128(past), Sse2.LoadVector128(past + stride));
                Vector256<byte> rise = Avx2.SubtractSaturate(level, envelope);
                if (!Avx.TestZ(rise, rise))
                    rise = Scale(rise, Avx2.Xor(envelope, Vector256<byte>.AllBitsSet), reciprocal);
                Avx.Store(rises, rise);
                peaks[y] = LevelVectors.Largest(rise.GetLower());
                peaks[y + 1] = LevelVectors.Largest(rise.GetUpper());
            }

            return y;
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector256<byte> Scale(Vector256<byte> rise, Vector256<byte> headroom, int* reciprocal)
        {
            Vector128<byte> r0 = rise.GetLower(), r1 = rise.GetUpper(), h0 = headroom.GetLower(), h1 = headroom.GetUpper();
            return LevelVectors.Pack(
                Scale(r0, h0, reciprocal),
                Scale(Sse2.ShiftRightLogical128BitLane(r0, 8), Sse2.ShiftRightLogical128BitLane(h0, 8), reciprocal),
                Scale(r1, h1, reciprocal),
                Scale(Sse2.ShiftRightLogical128BitLane(r1, 8), Sse2.ShiftRightLogical128BitLane(h1, 8), reciprocal));
        }

        /// <summary>The lower eight.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector256<uint> Scale(Vector128<byte> rise, Vector128<byte> headroom, int* reciprocal)
        {
            Vector256<int> factor = Avx2.GatherVector256(reciprocal, Avx2.ConvertToVector256Int32(headroom), sizeof(int));
            return Avx2.ShiftRightLogical(Avx2.MultiplyLow(Avx2.ConvertToVector256Int32(rise), factor), 8).AsUInt32();
        }
    }
}
#endif
