using System.Runtime.CompilerServices;

namespace LaserTracking.Imaging
{
    /// <summary>
    /// 8×8 inverse cosine transform in integers after Loeffler, Ligtenberg, Moschytz (ICASSP 1989): 13-bit constants, 2 more bits
    /// between the passes. The same arithmetic as the Independent JPEG Group's accurate transform, so results agree with it to the bit.
    /// </summary>
    internal static unsafe class JpegInverseDct
    {
        public const int ConstantBits = 13;
        public const int PassBits = 2;

        // cos and sin combinations of the flow graph, times 2^13.
        public const int C0298 = 2446;
        public const int C0390 = 3196;
        public const int C0541 = 4433;
        public const int C0765 = 6270;
        public const int C0899 = 7373;
        public const int C1175 = 9633;
        public const int C1501 = 12299;
        public const int C1847 = 15137;
        public const int C1961 = 16069;
        public const int C2053 = 16819;
        public const int C2562 = 20995;
        public const int C3072 = 25172;

        /// <summary>Coefficients, row by row, to 64 samples 0…255, row by row.</summary>
        public static void Transform(short* coefficients, byte* samples)
        {
#if NET8_0_OR_GREATER
            if (JpegInverseDctVector256.IsSupported)
            {
                JpegInverseDctVector256.Transform(coefficients, samples);
                return;
            }

            if (JpegInverseDctVector128.IsSupported)
            {
                JpegInverseDctVector128.Transform(coefficients, samples);
                return;
            }
#endif
            TransformScalar(coefficients, samples);
        }

        /// <summary>A block that is only its mean.</summary>
        [MethodImpl(JitOptions.OptimizeAtOnce)]
        public static void TransformDcOnly(int dc, byte* samples)
        {
            int value = Clamp((((dc << PassBits) + (1 << (PassBits + 2))) >> (PassBits + 3)) + 128);
            ulong eight = (ulong)(uint)value * 0x0101010101010101;
            ulong* rows = (ulong*)samples;
            for (int y = 0; y < 8; y++)
                rows[y] = eight;
        }

        [MethodImpl(JitOptions.OptimizeAtOnce)]
        public static void TransformScalar(short* coefficients, byte* samples)
        {
            int* workspace = stackalloc int[64];
            for (int x = 0; x < 8; x++)
            {
                short* c = coefficients + x;
                int* w = workspace + x;
                if (c[8] == 0 && c[16] == 0 && c[24] == 0 && c[32] == 0 && c[40] == 0 && c[48] == 0 && c[56] == 0)
                {
                    int flat = c[0] << PassBits;
                    for (int y = 0; y < 64; y += 8)
                        w[y] = flat;
                    continue;
                }

                Pass(c[0], c[8], c[16], c[24], c[32], c[40], c[48], c[56], 1 << (ConstantBits - PassBits - 1),
                    ConstantBits - PassBits, w, 8);
            }

            // The samples' offset of 128 rides along with the rounding.
            int* row = stackalloc int[8];
            const int shift = ConstantBits + PassBits + 3;
            for (int y = 0; y < 8; y++)
            {
                int* w = workspace + y * 8;
                Pass(w[0], w[1], w[2], w[3], w[4], w[5], w[6], w[7], (1 << (shift - 1)) + (128 << shift), shift, row, 1);
                for (int x = 0; x < 8; x++)
                    samples[y * 8 + x] = (byte)Clamp(row[x]);
            }
        }

        private static int Clamp(int value) => value < 0 ? 0 : value > 255 ? 255 : value;

        private static void Pass(
            int i0, int i1, int i2, int i3, int i4, int i5, int i6, int i7, int rounding, int shift, int* result, int step)
        {
            int z1 = (i2 + i6) * C0541;
            int even2 = z1 - i6 * C1847;
            int even3 = z1 + i2 * C0765;
            int even0 = ((i0 + i4) << ConstantBits) + rounding;
            int even1 = ((i0 - i4) << ConstantBits) + rounding;
            int s0 = even0 + even3;
            int s3 = even0 - even3;
            int s1 = even1 + even2;
            int s2 = even1 - even2;

            int z3 = i7 + i3;
            int z4 = i5 + i1;
            int z5 = (z3 + z4) * C1175;
            z3 = z5 - z3 * C1961;
            z4 = z5 - z4 * C0390;
            z1 = (i7 + i1) * -C0899;
            int z2 = (i5 + i3) * -C2562;
            int odd0 = i7 * C0298 + z1 + z3;
            int odd1 = i5 * C2053 + z2 + z4;
            int odd2 = i3 * C3072 + z2 + z3;
            int odd3 = i1 * C1501 + z1 + z4;

            result[0] = (s0 + odd3) >> shift;
            result[step * 7] = (s0 - odd3) >> shift;
            result[step] = (s1 + odd2) >> shift;
            result[step * 6] = (s1 - odd2) >> shift;
            result[step * 2] = (s2 + odd1) >> shift;
            result[step * 5] = (s2 - odd1) >> shift;
            result[step * 3] = (s3 + odd0) >> shift;
            result[step * 4] = (s3 - odd0) >> shift;
        }
    }
}
