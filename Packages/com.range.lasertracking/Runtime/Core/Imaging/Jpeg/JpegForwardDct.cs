namespace LaserTracking.Imaging
{
    /// <summary>8×8 forward cosine transform in integers; the counterpart of <see cref="JpegInverseDct"/> with the same constants.</summary>
    internal static unsafe class JpegForwardDct
    {
        /// <summary>64 samples less 128, row by row, to coefficients times 8, in place.</summary>
        public static void Transform(int* block)
        {
            const int shift = JpegInverseDct.ConstantBits - JpegInverseDct.PassBits;
            for (int y = 0; y < 8; y++)
            {
                int* row = block + y * 8;
                Pass(row, 1, shift);
                row[0] <<= JpegInverseDct.PassBits;
                row[4] <<= JpegInverseDct.PassBits;
            }

            const int half = 1 << (JpegInverseDct.PassBits - 1);
            for (int x = 0; x < 8; x++)
            {
                int* column = block + x;
                Pass(column, 8, JpegInverseDct.ConstantBits + JpegInverseDct.PassBits);
                column[0] = (column[0] + half) >> JpegInverseDct.PassBits;
                column[32] = (column[32] + half) >> JpegInverseDct.PassBits;
            }
        }

        private static void Pass(int* d, int step, int shift)
        {
            int round = 1 << (shift - 1);
            int s0 = d[0] + d[7 * step];
            int s7 = d[0] - d[7 * step];
            int s1 = d[step] + d[6 * step];
            int s6 = d[step] - d[6 * step];
            int s2 = d[2 * step] + d[5 * step];
            int s5 = d[2 * step] - d[5 * step];
            int s3 = d[3 * step] + d[4 * step];
            int s4 = d[3 * step] - d[4 * step];

            int e0 = s0 + s3;
            int e3 = s0 - s3;
            int e1 = s1 + s2;
            int e2 = s1 - s2;
            d[0] = e0 + e1;
            d[4 * step] = e0 - e1;
            int z1 = (e2 + e3) * JpegInverseDct.C0541 + round;
            d[2 * step] = (z1 + e3 * JpegInverseDct.C0765) >> shift;
            d[6 * step] = (z1 - e2 * JpegInverseDct.C1847) >> shift;

            int z5 = (s4 + s6 + s5 + s7) * JpegInverseDct.C1175 + round;
            int z3 = z5 - (s4 + s6) * JpegInverseDct.C1961;
            int z4 = z5 - (s5 + s7) * JpegInverseDct.C0390;
            z1 = (s4 + s7) * -JpegInverseDct.C0899;
            int z2 = (s5 + s6) * -JpegInverseDct.C2562;
            d[7 * step] = (s4 * JpegInverseDct.C0298 + z1 + z3) >> shift;
            d[5 * step] = (s5 * JpegInverseDct.C2053 + z2 + z4) >> shift;
            d[3 * step] = (s6 * JpegInverseDct.C3072 + z2 + z3) >> shift;
            d[step] = (s7 * JpegInverseDct.C1501 + z1 + z4) >> shift;
        }
    }
}
