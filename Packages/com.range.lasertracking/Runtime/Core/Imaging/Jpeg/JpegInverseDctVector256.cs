#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LaserTracking.Imaging
{
    /// <summary>The arithmetic of <see cref="JpegInverseDct"/> on eight columns, then eight rows, at once.</summary>
    internal static unsafe class JpegInverseDctVector256
    {
        public static bool IsSupported => Avx2.IsSupported;

        [MethodImpl(JitOptions.OptimizeAtOnce)]
        public static void Transform(short* coefficients, byte* samples)
        {
            Vector256<int> r0 = Avx2.ConvertToVector256Int32(coefficients);
            Vector256<int> r1 = Avx2.ConvertToVector256Int32(coefficients + 8);
            Vector256<int> r2 = Avx2.ConvertToVector256Int32(coefficients + 16);
            Vector256<int> r3 = Avx2.ConvertToVector256Int32(coefficients + 24);
            Vector256<int> r4 = Avx2.ConvertToVector256Int32(coefficients + 32);
            Vector256<int> r5 = Avx2.ConvertToVector256Int32(coefficients + 40);
            Vector256<int> r6 = Avx2.ConvertToVector256Int32(coefficients + 48);
            Vector256<int> r7 = Avx2.ConvertToVector256Int32(coefficients + 56);

            const int columnShift = JpegInverseDct.ConstantBits - JpegInverseDct.PassBits;
            Pass(ref r0, ref r1, ref r2, ref r3, ref r4, ref r5, ref r6, ref r7, 1 << (columnShift - 1), columnShift);
            Transpose(ref r0, ref r1, ref r2, ref r3, ref r4, ref r5, ref r6, ref r7);
            const int rowShift = JpegInverseDct.ConstantBits + JpegInverseDct.PassBits + 3;
            Pass(ref r0, ref r1, ref r2, ref r3, ref r4, ref r5, ref r6, ref r7, (1 << (rowShift - 1)) + (128 << rowShift), rowShift);

            // Now r0 is the left column. Packing with saturation clamps; each 128-bit half holds four columns of four rows,
            // which a byte shuffle turns into four rows of four columns.
            Vector256<byte> order = Vector256.Create(
                (byte)0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15, 0, 4, 8, 12, 1, 5, 9, 13, 2, 6, 10, 14, 3, 7, 11, 15);
            Vector256<byte> left = Avx2.Shuffle(
                Avx2.PackUnsignedSaturate(Avx2.PackSignedSaturate(r0, r1), Avx2.PackSignedSaturate(r2, r3)), order);
            Vector256<byte> right = Avx2.Shuffle(
                Avx2.PackUnsignedSaturate(Avx2.PackSignedSaturate(r4, r5), Avx2.PackSignedSaturate(r6, r7)), order);
            Vector256<byte> rows0145 = Avx2.UnpackLow(left.AsInt32(), right.AsInt32()).AsByte();
            Vector256<byte> rows2367 = Avx2.UnpackHigh(left.AsInt32(), right.AsInt32()).AsByte();
            Avx.Store(samples, Avx2.Permute2x128(rows0145, rows2367, 0x20));
            Avx.Store(samples + 32, Avx2.Permute2x128(rows0145, rows2367, 0x31));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Pass(
            ref Vector256<int> r0, ref Vector256<int> r1, ref Vector256<int> r2, ref Vector256<int> r3,
            ref Vector256<int> r4, ref Vector256<int> r5, ref Vector256<int> r6, ref Vector256<int> r7, int rounding, int shift)
        {
            Vector256<int> z1 = (r2 + r6) * Vector256.Create(JpegInverseDct.C0541);
            Vector256<int> even2 = z1 - r6 * Vector256.Create(JpegInverseDct.C1847);
            Vector256<int> even3 = z1 + r2 * Vector256.Create(JpegInverseDct.C0765);
            Vector256<int> round = Vector256.Create(rounding);
            Vector256<int> even0 = Vector256.ShiftLeft(r0 + r4, JpegInverseDct.ConstantBits) + round;
            Vector256<int> even1 = Vector256.ShiftLeft(r0 - r4, JpegInverseDct.ConstantBits) + round;
            Vector256<int> s0 = even0 + even3;
            Vector256<int> s3 = even0 - even3;
            Vector256<int> s1 = even1 + even2;
            Vector256<int> s2 = even1 - even2;

            Vector256<int> z3 = r7 + r3;
            Vector256<int> z4 = r5 + r1;
            Vector256<int> z5 = (z3 + z4) * Vector256.Create(JpegInverseDct.C1175);
            z3 = z5 - z3 * Vector256.Create(JpegInverseDct.C1961);
            z4 = z5 - z4 * Vector256.Create(JpegInverseDct.C0390);
            z1 = (r7 + r1) * Vector256.Create(-JpegInverseDct.C0899);
            Vector256<int> z2 = (r5 + r3) * Vector256.Create(-JpegInverseDct.C2562);
            Vector256<int> odd0 = r7 * Vector256.Create(JpegInverseDct.C0298) + z1 + z3;
            Vector256<int> odd1 = r5 * Vector256.Create(JpegInverseDct.C2053) + z2 + z4;
            Vector256<int> odd2 = r3 * Vector256.Create(JpegInverseDct.C3072) + z2 + z3;
            Vector256<int> odd3 = r1 * Vector256.Create(JpegInverseDct.C1501) + z1 + z4;

            r0 = Vector256.ShiftRightArithmetic(s0 + odd3, shift);
            r7 = Vector256.ShiftRightArithmetic(s0 - odd3, shift);
            r1 = Vector256.ShiftRightArithmetic(s1 + odd2, shift);
            r6 = Vector256.ShiftRightArithmetic(s1 - odd2, shift);
            r2 = Vector256.ShiftRightArithmetic(s2 + odd1, shift);
            r5 = Vector256.ShiftRightArithmetic(s2 - odd1, shift);
            r3 = Vector256.ShiftRightArithmetic(s3 + odd0, shift);
            r4 = Vector256.ShiftRightArithmetic(s3 - odd0, shift);
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Transpose(
            ref Vector256<int> r0, ref Vector256<int> r1, ref Vector256<int> r2, ref Vector256<int> r3,
            ref Vector256<int> r4, ref Vector256<int> r5, ref Vector256<int> r6, ref Vector256<int> r7)
        {
            Vector256<long> a0 = Avx2.UnpackLow(r0, r1).AsInt64();
            Vector256<long> a1 = Avx2.UnpackHigh(r0, r1).AsInt64();
            Vector256<long> a2 = Avx2.UnpackLow(r2, r3).AsInt64();
            Vector256<long> a3 = Avx2.UnpackHigh(r2, r3).AsInt64();
            Vector256<long> a4 = Avx2.UnpackLow(r4, r5).AsInt64();
            Vector256<long> a5 = Avx2.UnpackHigh(r4, r5).AsInt64();
            Vector256<long> a6 = Avx2.UnpackLow(r6, r7).AsInt64();
            Vector256<long> a7 = Avx2.UnpackHigh(r6, r7).AsInt64();

            Vector256<int> b0 = Avx2.UnpackLow(a0, a2).AsInt32();
            Vector256<int> b1 = Avx2.UnpackHigh(a0, a2).AsInt32();
            Vector256<int> b2 = Avx2.UnpackLow(a1, a3).AsInt32();
            Vector256<int> b3 = Avx2.UnpackHigh(a1, a3).AsInt32();
            Vector256<int> b4 = Avx2.UnpackLow(a4, a6).AsInt32();
            Vector256<int> b5 = Avx2.UnpackHigh(a4, a6).AsInt32();
            Vector256<int> b6 = Avx2.UnpackLow(a5, a7).AsInt32();
            Vector256<int> b7 = Avx2.UnpackHigh(a5, a7).AsInt32();

            r0 = Avx2.Permute2x128(b0, b4, 0x20);
            r1 = Avx2.Permute2x128(b1, b5, 0x20);
            r2 = Avx2.Permute2x128(b2, b6, 0x20);
            r3 = Avx2.Permute2x128(b3, b7, 0x20);
            r4 = Avx2.Permute2x128(b0, b4, 0x31);
            r5 = Avx2.Permute2x128(b1, b5, 0x31);
            r6 = Avx2.Permute2x128(b2, b6, 0x31);
            r7 = Avx2.Permute2x128(b3, b7, 0x31);
        }
    }
}
#endif
