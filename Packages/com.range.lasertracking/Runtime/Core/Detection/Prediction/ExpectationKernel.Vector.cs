#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LaserTracking.Detection
{
    internal static unsafe partial class ExpectationKernel
    {
        private const int CacheLinePixels = 16;

        /// <summary>Asks memory for what <see cref="Apart"/> will look at.</summary>
        public static void Announce(uint* pixel, int reach, int width)
        {
            if (!Sse.IsSupported)
                return;
            Sse.Prefetch0(pixel);
            Sse.Prefetch0(pixel - reach * width);
            Sse.Prefetch0(pixel + reach * width);
        }

        /// <summary>Whole blocks of 8 pixels, as in all that follow; returns how many are done. 0 where the processor lacks 256-bit vectors.</summary>
        private static int BrightestVector(uint** rows, int count, long offset, int width, uint* target)
        {
            if (!Avx2.IsSupported)
                return 0;
            int x = 0;
            for (; x + 8 <= width; x += 8)
            {
                Vector256<byte> largest = Avx.LoadVector256((byte*)(rows[0] + offset + x));
                for (int i = 1; i < count; i++)
                    largest = Avx2.Max(largest, Avx.LoadVector256((byte*)(rows[i] + offset + x)));
                Avx.Store((byte*)(target + x), largest);
            }

            return x;
        }

        private static int WidenVector(uint* pad, int width, uint* target)
        {
            if (!Avx2.IsSupported)
                return 0;
            int x = 0;
            for (; x + 8 <= width; x += 8)
            {
                Vector256<byte> left = Avx2.Max(Avx.LoadVector256((byte*)(pad + x)), Avx.LoadVector256((byte*)(pad + x + 1)));
                Vector256<byte> right = Avx2.Max(Avx.LoadVector256((byte*)(pad + x + 3)), Avx.LoadVector256((byte*)(pad + x + 4)));
                Avx.Store((byte*)(target + x), Avx2.Max(Avx2.Max(left, right), Avx.LoadVector256((byte*)(pad + x + 2))));
            }

            return x;
        }

        private static int TransferVector(uint* row, int width, byte* tone, uint* gain, uint* offset)
        {
            if (!Avx2.IsSupported)
                return 0;

            // A table index with its top bit set gives zero: each channel looks into its own tables and is silent in the others'.
            Vector256<byte> low = Vector256.Create((byte)15);
            Vector256<byte> notBlue = Vector256.Create(0x80808000u).AsByte(), notGreen = Vector256.Create(0x80800080u).AsByte(), notRed = Vector256.Create(0x80008080u).AsByte();
            Vector256<byte> blue = Table(tone), blueRise = Table(tone + 16);
            Vector256<byte> green = Table(tone + 32), greenRise = Table(tone + 48);
            Vector256<byte> red = Table(tone + 64), redRise = Table(tone + 80);
            Vector256<ushort> lowByte = Vector256.Create((ushort)255);
            int x = 0;
            for (; x + 8 <= width; x += 8)
            {
                Vector256<byte> levels = Avx.LoadVector256((byte*)(row + x));
                Vector256<byte> inside = levels & low, segment = Avx2.ShiftRightLogical(levels.AsUInt16(), 4).AsByte() & low;
                Vector256<byte> b = segment | notBlue, g = segment | notGreen, r = segment | notRed;
                Vector256<byte> start = Avx2.Shuffle(blue, b) | Avx2.Shuffle(green, g) | Avx2.Shuffle(red, r);
                Vector256<ushort> rise = (Avx2.Shuffle(blueRise, b) | Avx2.Shuffle(greenRise, g) | Avx2.Shuffle(redRise, r)).AsUInt16();
                Vector256<ushort> even = Avx2.ShiftRightLogical(Avx2.MultiplyLow(rise & lowByte, inside.AsUInt16() & lowByte), 4);
                Vector256<ushort> odd = Avx2.ShiftRightLogical(Avx2.MultiplyLow(Avx2.ShiftRightLogical(rise, 8), Avx2.ShiftRightLogical(inside.AsUInt16(), 8)), 4);
                Vector256<ushort> value = Avx2.Add(start, (even | Avx2.ShiftLeftLogical(odd, 8)).AsByte()).AsUInt16();
                Vector256<ushort> gains = Avx.LoadVector256((ushort*)(gain + x)), offsets = Avx.LoadVector256((ushort*)(offset + x));
                even = Adjust(value & lowByte, gains & lowByte, offsets & lowByte);
                odd = Adjust(Avx2.ShiftRightLogical(value, 8), Avx2.ShiftRightLogical(gains, 8), Avx2.ShiftRightLogical(offsets, 8));
                Avx.Store(row + x, (even | Avx2.ShiftLeftLogical(odd, 8)).AsUInt32() & Vector256.Create(0xFFFFFFu));
            }

            return x;
        }

        private static Vector256<byte> Table(byte* values)
        {
            Vector128<byte> table = Vector128.Load(values);
            return Vector256.Create(table, table);
        }

        private static Vector256<ushort> Adjust(Vector256<ushort> value, Vector256<ushort> gain, Vector256<ushort> offset)
        {
            Vector256<short> result = Avx2.ShiftRightLogical(Avx2.MultiplyLow(value, gain), 7).AsInt16() + offset.AsInt16() - Vector256.Create((short)128);
            return Avx2.Min(Avx2.Max(result, Vector256<short>.Zero), Vector256.Create((short)255)).AsUInt16();
        }

        private static int ApartVector(uint value, uint* pixel, int reach, int width)
        {
            Vector128<byte> around = Vector128.Create(pixel[-reach], pixel[reach], pixel[-reach * width], pixel[reach * width]).AsByte();
            Vector128<byte> same = Vector128.Create(value).AsByte(), middle = Vector128.CreateScalarUnsafe(*pixel).AsByte();
            Vector128<byte> apart = Sse2.SubtractSaturate(around, same) | Sse2.SubtractSaturate(same, around);
            Vector128<byte> there = Sse2.SubtractSaturate(middle, same) | Sse2.SubtractSaturate(same, middle);

            // Of the vector with the middle only its first pixel counts, of all pixels the lower three bytes.
            apart = Sse2.Max(apart & Vector128.Create(0xFFFFFFu).AsByte(), there & Vector128.CreateScalar(0xFFFFFFu).AsByte());
            return LevelVectors.Largest(apart);
        }

        /// <summary>Whole blocks of 4; pairs as one number, which is as fast as the processor's own gathering.</summary>
        private static int GatherVector(uint* source, int* indices, int count, uint* target)
        {
            if (!Sse.IsSupported)
                return 0;
            int i = 0;
            var pairs = (ulong*)target;
            for (; i + 4 <= count; i += 4)
            {
                // Memory is asked for the indices of the next row, and for what they mostly name: not far on from here.
                Sse.Prefetch0(indices + i + count);
                Sse.Prefetch0(source + indices[i] + 2 * count);
                ulong a = source[indices[i]], b = source[indices[i + 1]], c = source[indices[i + 2]], d = source[indices[i + 3]];
                pairs[i] = a | a << 32;
                pairs[i + 1] = b | b << 32;
                pairs[i + 2] = c | c << 32;
                pairs[i + 3] = d | d << 32;
            }

            return i;
        }

        private static int ExceedVector(uint* now, uint* expected, int width, byte* reference, byte* column)
        {
            if (!Avx2.IsSupported)
                return 0;
            Vector256<int> order = Vector256.Create(0, 4, 1, 5, 2, 6, 3, 7);
            int x = 0;
            for (; x + 32 <= width; x += 32)
            {
                Sse.Prefetch0(now + x + width);
                Sse.Prefetch0(now + x + width + CacheLinePixels);
                Levels(now + x, expected + x, out Vector256<int> largest0, out Vector256<int> excess0);
                Levels(now + x + 8, expected + x + 8, out Vector256<int> largest1, out Vector256<int> excess1);
                Levels(now + x + 16, expected + x + 16, out Vector256<int> largest2, out Vector256<int> excess2);
                Levels(now + x + 24, expected + x + 24, out Vector256<int> largest3, out Vector256<int> excess3);
                Vector256<byte> largest = Pack(largest0, largest1, largest2, largest3, order), excess = Pack(excess0, excess1, excess2, excess3, order);
                Avx.Store(reference + x, Avx2.Subtract(largest, excess));
                Avx.Store(column + x, Avx2.Max(Avx.LoadVector256(column + x), excess));
            }

            return x;
        }

        private static void Levels(uint* now, uint* expected, out Vector256<int> largest, out Vector256<int> excess)
        {
            Vector256<uint> pixels = Avx.LoadVector256(now);
            largest = LargestChannel(pixels);
            excess = LargestChannel(Avx2.SubtractSaturate(pixels.AsByte(), Avx.LoadVector256((byte*)expected)).AsUInt32());
        }

        private static Vector256<int> LargestChannel(Vector256<uint> p) => (Avx2.Max(
            Avx2.Max(p.AsByte(), Avx2.ShiftRightLogical(p, 8).AsByte()), Avx2.ShiftRightLogical(p, 16).AsByte()).AsUInt32() & Vector256.Create(0xFFu)).AsInt32();

        /// <summary>The two packs leave groups of four pixels in another order.</summary>
        private static Vector256<byte> Pack(Vector256<int> a, Vector256<int> b, Vector256<int> c, Vector256<int> d, Vector256<int> order) =>
            Avx2.PermuteVar8x32(Avx2.PackUnsignedSaturate(Avx2.PackSignedSaturate(a, b), Avx2.PackSignedSaturate(c, d)).AsInt32(), order).AsByte();
    }
}
#endif
