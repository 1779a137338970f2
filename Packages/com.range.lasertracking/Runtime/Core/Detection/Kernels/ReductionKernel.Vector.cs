#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LaserTracking.Detection
{
    internal static unsafe partial class ReductionKernel
    {
        /// <summary>Whole blocks of 8 result pixels; returns how many are done. 0 where the processor lacks 256-bit vectors.</summary>
        private static int HalveBgraVector(uint* row0, uint* row1, int width, uint* target)
        {
            if (!Avx2.IsSupported)
                return 0;
            int half = width / 2;
            int x = 0;

            // Memory is asked for the next two rows meanwhile: no processor foresees what follows a row's end.
            long ahead = 2 * (row1 - row0);
            for (; x + 8 <= half; x += 8)
            {
                Sse.Prefetch0(row0 + 2 * x + ahead);
                Sse.Prefetch0(row1 + 2 * x + ahead);
                Vector256<byte> a = Avx2.Max(Avx.LoadVector256((byte*)(row0 + 2 * x)), Avx.LoadVector256((byte*)(row1 + 2 * x)));
                Vector256<byte> b = Avx2.Max(Avx.LoadVector256((byte*)(row0 + 2 * x + 8)), Avx.LoadVector256((byte*)(row1 + 2 * x + 8)));
                Vector256<byte> even = Avx.Shuffle(a.AsSingle(), b.AsSingle(), 0x88).AsByte();
                Vector256<byte> odd = Avx.Shuffle(a.AsSingle(), b.AsSingle(), 0xDD).AsByte();
                Avx.Store((byte*)(target + x), Avx2.Permute4x64(Avx2.Max(even, odd).AsUInt64(), 0xD8).AsByte());
            }

            return x;
        }

        /// <summary>Whole blocks of 8 result pixels; returns how many are done.</summary>
        private static int HalveYuy2Vector(byte* row0, byte* row1, int width, uint* target)
        {
            if (!Avx2.IsSupported)
                return 0;
            int half = width / 2;
            int x = 0;
            for (; x + 8 <= half; x += 8)
                Avx.Store((byte*)(target + x), Avx2.Max(PairsToBgra(row0 + 4 * x), PairsToBgra(row1 + 4 * x)));
            return x;
        }

        /// <summary>Eight groups Y0 U Y1 V to eight pixels of the larger luma: 32-bit lanes, chroma as pairs of 16 bits.</summary>
        private static Vector256<byte> PairsToBgra(byte* source)
        {
            Vector256<ushort> groups = Avx.LoadVector256(source).AsUInt16();
            Vector256<int> first = (groups & Vector256.Create((ushort)0xFF)).AsInt32();
            Vector256<int> luma = Avx2.Max(first.AsInt16(), Avx2.ShiftRightLogical(first, 16).AsInt16()).AsInt32() & Vector256.Create(0xFF);
            Vector256<short> chroma = Avx2.ShiftRightLogical(groups, 8).AsInt16() - Vector256.Create((short)128);
            Vector256<int> blue = Channel(luma, chroma, 113, 0);
            Vector256<int> green = Channel(luma, chroma, -22, -46);
            Vector256<int> red = Channel(luma, chroma, 0, 90);
            return (blue | Avx2.ShiftLeftLogical(green, 8) | Avx2.ShiftLeftLogical(red, 16) | Vector256.Create(unchecked((int)0xFF000000))).AsByte();
        }

        private static Vector256<int> Channel(Vector256<int> luma, Vector256<short> chroma, short u, short v)
        {
            Vector256<short> weights = Vector256.Create((int)(ushort)u | v << 16).AsInt16();
            Vector256<int> offset = Avx2.ShiftRightArithmetic(Avx2.MultiplyAddAdjacent(chroma, weights) + Vector256.Create(32), 6);
            return Avx2.Min(Avx2.Max(luma + offset, Vector256<int>.Zero), Vector256.Create(255));
        }

        /// <summary>Whole blocks of 16 result pixels; returns how many are done.</summary>
        private static int HalveNv12Vector(byte* row0, byte* row1, byte* chroma, int width, uint* target)
        {
            if (!Avx2.IsSupported)
                return 0;
            int half = width / 2;
            int x = 0;
            Vector256<short> lowByte = Vector256.Create((short)0xFF);
            Vector256<short> center = Vector256.Create((short)128);
            Vector256<short> rounding = Vector256.Create((short)32);
            Vector256<short> blueU = Vector256.Create((short)113);
            Vector256<short> greenU = Vector256.Create((short)-22);
            Vector256<short> greenV = Vector256.Create((short)-46);
            Vector256<short> redV = Vector256.Create((short)90);
            Vector256<byte> opaque = Vector256.Create((byte)255);
            long ahead = row1 - row0;
            for (; x + 16 <= half; x += 16)
            {
                Sse.Prefetch0(row0 + 2 * (x + ahead));
                Sse.Prefetch0(row1 + 2 * (x + ahead));
                Sse.Prefetch0(chroma + 2 * x + ahead);
                Vector256<byte> rows = Avx2.Max(Avx.LoadVector256(row0 + 2 * x), Avx.LoadVector256(row1 + 2 * x));
                Vector256<short> luma = Avx2.Max(rows, Avx2.ShiftRightLogical(rows.AsInt16(), 8).AsByte()).AsInt16() & lowByte;
                Vector256<short> uv = Avx.LoadVector256(chroma + 2 * x).AsInt16();
                Vector256<short> u = (uv & lowByte) - center;
                Vector256<short> v = Avx2.ShiftRightLogical(uv, 8) - center;
                Vector256<short> blue = luma + Avx2.ShiftRightArithmetic(Avx2.MultiplyLow(u, blueU) + rounding, 6);
                Vector256<short> green = luma + Avx2.ShiftRightArithmetic(Avx2.MultiplyLow(u, greenU) + Avx2.MultiplyLow(v, greenV) + rounding, 6);
                Vector256<short> red = luma + Avx2.ShiftRightArithmetic(Avx2.MultiplyLow(v, redV) + rounding, 6);

                // Saturating packs work in each 128-bit half, and so do the unpacks: blocks of 8 pixels keep their places.
                Vector256<byte> blueRed = Avx2.PackUnsignedSaturate(blue, red);
                Vector256<byte> greenOnly = Avx2.PackUnsignedSaturate(green, green);
                Vector256<byte> blueGreen = Avx2.UnpackLow(blueRed, greenOnly);
                Vector256<byte> redAlpha = Avx2.UnpackHigh(blueRed, opaque);
                Vector256<byte> first = Avx2.UnpackLow(blueGreen.AsInt16(), redAlpha.AsInt16()).AsByte();
                Vector256<byte> second = Avx2.UnpackHigh(blueGreen.AsInt16(), redAlpha.AsInt16()).AsByte();
                Avx.Store((byte*)(target + x), Avx2.Permute2x128(first, second, 0x20));
                Avx.Store((byte*)(target + x + 8), Avx2.Permute2x128(first, second, 0x31));
            }

            return x;
        }
    }
}
#endif
