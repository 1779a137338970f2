#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LaserTracking.Detection
{
    /// <summary>Levels of 32 pixels at a time as bytes, with 256-bit vectors: what vector forms of several kernels begin with.</summary>
    internal static class LevelVectors
    {
        /// <summary><see cref="FrameView.Level"/> of four times eight pixels.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Vector256<byte> Of(Vector256<uint> a, Vector256<uint> b, Vector256<uint> c, Vector256<uint> d, DetectionPlane plane) =>
            plane == DetectionPlane.Smallest ? Pack(Smallest(a), Smallest(b), Smallest(c), Smallest(d)) : Pack(Largest(a), Largest(b), Largest(c), Largest(d));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Vector256<uint> Smallest(Vector256<uint> p) => Avx2.Min(
            Avx2.Min(p.AsByte(), Avx2.ShiftRightLogical(p, 8).AsByte()), Avx2.ShiftRightLogical(p, 16).AsByte()).AsUInt32() & Vector256.Create(0xFFu);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Vector256<uint> Largest(Vector256<uint> p) => Avx2.Max(
            Avx2.Max(p.AsByte(), Avx2.ShiftRightLogical(p, 8).AsByte()), Avx2.ShiftRightLogical(p, 16).AsByte()).AsUInt32() & Vector256.Create(0xFFu);

        /// <summary>Numbers up to 255 to bytes, in order.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static Vector256<byte> Pack(Vector256<uint> a, Vector256<uint> b, Vector256<uint> c, Vector256<uint> d)
        {
            // The two packs leave groups of four pixels in the order a0 b0 c0 d0 a1 b1 c1 d1.
            Vector256<short> ab = Avx2.PackSignedSaturate(a.AsInt32(), b.AsInt32()), cd = Avx2.PackSignedSaturate(c.AsInt32(), d.AsInt32());
            return Avx2.PermuteVar8x32(Avx2.PackUnsignedSaturate(ab, cd).AsInt32(), Vector256.Create(0, 4, 1, 5, 2, 6, 3, 7)).AsByte();
        }

        /// <summary>The largest of sixteen.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public static byte Largest(Vector128<byte> v)
        {
            // The instruction looks for the smallest of eight: of each pair the larger one, turned round.
            Vector128<byte> pairs = Sse2.Max(v, Sse2.ShiftRightLogical(v.AsUInt16(), 8).AsByte());
            return (byte)~Sse41.MinHorizontal((~pairs & Vector128.Create((ushort)0xFF).AsByte()).AsUInt16()).ToScalar();
        }
    }
}
#endif
