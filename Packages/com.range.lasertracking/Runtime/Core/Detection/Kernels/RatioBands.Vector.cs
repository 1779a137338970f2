#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LaserTracking.Detection
{
    internal unsafe partial struct RatioBands
    {
        /// <summary>Samples of a block, and bytes that they are taken from.</summary>
        private const int Block = 16, BlockBytes = Block * SampleStep;

        private const int Bins = 256;

        /// <summary>Adds whole blocks; returns the first sample that is left. That is the first one where the processor lacks 256-bit vectors.</summary>
        private static int CountVector(byte* here, byte* past, int first, int end, int* ratios)
        {
            if (!Avx2.IsSupported)
                return first;

            // In turn in two lists, as the commonest ratio comes many times in a row; their last place is for what is not usable.
            int* counts = stackalloc int[2 * (Bins + 1)], places = stackalloc int[Block];
            for (int i = 0; i < 2 * (Bins + 1); i++)
                counts[i] = 0;
            int at = first;
            for (; at + BlockBytes <= end; at += BlockBytes)
            {
                Vector128<byte> now = Samples(here + at), before = Samples(past + at), usable = Usable(now, before);
                Avx.Store(places, Quotients(now, before, usable));
                Avx.Store(places + 8, Quotients(UpperHalf(now), UpperHalf(before), UpperHalf(usable)));
                for (int i = 0; i < Block; i += 2)
                {
                    counts[places[i]]++;
                    counts[Bins + 1 + places[i + 1]]++;
                }
            }

            for (int i = 0; i < Bins; i++)
                ratios[i] += counts[i] + counts[Bins + 1 + i];
            return at;
        }

        /// <summary>Adds whole blocks; returns the first sample that is left.</summary>
        private static int SumUpVector(byte* here, byte* past, int first, int end, int middle, int width, ref int count, ref int sumNow, ref int sumBefore)
        {
            if (!Avx2.IsSupported)
                return first;
            Vector256<short> offWeights = Vector256.Create(64 | -middle << 16).AsInt16(), nearWeights = Vector256.Create(width << 16).AsInt16(), one = Vector256.Create((short)1);
            Vector256<int> counted = default, nows = default, befores = default;
            int at = first;
            for (; at + BlockBytes <= end; at += BlockBytes)
            {
                Vector128<byte> nowBytes = Samples(here + at), beforeBytes = Samples(past + at);
                Vector256<short> now = Avx2.ConvertToVector256Int16(nowBytes), before = Avx2.ConvertToVector256Int16(beforeBytes);
                Vector256<short> usable = Avx2.ConvertToVector256Int16(Usable(nowBytes, beforeBytes).AsSByte());
                Vector256<short> low = Avx2.UnpackLow(now, before), high = Avx2.UnpackHigh(now, before);
                Vector256<short> beyond = Avx2.PackSignedSaturate(Beyond(low, offWeights, nearWeights), Beyond(high, offWeights, nearWeights));
                Vector256<short> within = Avx2.AndNot(beyond, usable);
                counted -= Avx2.MultiplyAddAdjacent(within, one);
                nows += Avx2.MultiplyAddAdjacent(now & within, one);
                befores += Avx2.MultiplyAddAdjacent(before & within, one);
            }

            count += Vector256.Sum(counted);
            sumNow += Vector256.Sum(nows);
            sumBefore += Vector256.Sum(befores);
            return at;
        }

        /// <summary>Every third byte.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector128<byte> Samples(byte* at) =>
            Ssse3.Shuffle(Sse2.LoadVector128(at), Vector128.Create(0, 3, 6, 9, 12, 15, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255))
            | Ssse3.Shuffle(Sse2.LoadVector128(at + 16), Vector128.Create(255, 255, 255, 255, 255, 255, 2, 5, 8, 11, 14, 255, 255, 255, 255, 255))
            | Ssse3.Shuffle(Sse2.LoadVector128(at + 32), Vector128.Create(255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 255, 1, 4, 7, 10, 13));

        private static Vector128<byte> UpperHalf(Vector128<byte> v) => Sse2.ShiftRightLogical128BitLane(v, 8);

        /// <summary>All bits where <see cref="IsUsable"/>.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector128<byte> Usable(Vector128<byte> now, Vector128<byte> before)
        {
            Vector128<byte> darkest = Vector128.Create((byte)DarkestForRatio), brightest = Vector128.Create((byte)BrightestForRatio);
            return Sse2.CompareEqual(Sse2.Max(before, darkest), before) & Sse2.CompareEqual(Sse2.Max(Sse2.Max(now, before), brightest), brightest);
        }

        /// <summary>Of the lower eight, up to 255; 256 where not usable. A rounded quotient of such numbers never reaches the next whole one.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector256<int> Quotients(Vector128<byte> now, Vector128<byte> before, Vector128<byte> usable)
        {
            Vector256<int> divisor = Avx2.ConvertToVector256Int32(before);
            Vector256<int> dividend = Avx2.ShiftLeftLogical(Avx2.ConvertToVector256Int32(now), 6) + Avx2.ShiftRightLogical(divisor, 1);
            Vector256<int> ratio = Avx.ConvertToVector256Int32WithTruncation(Avx.Divide(Avx.ConvertToVector256Single(dividend), Avx.ConvertToVector256Single(divisor)));
            Vector256<int> mask = Avx2.ConvertToVector256Int32(usable.AsSByte());
            return Avx2.BlendVariable(Vector256.Create(Bins), Avx2.Min(ratio, Vector256.Create(Bins - 1)), mask);
        }

        /// <summary>All bits where a pair of now and before lies too far from the middle.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static Vector256<int> Beyond(Vector256<short> pairs, Vector256<short> offWeights, Vector256<short> nearWeights)
        {
            Vector256<int> off = Avx2.Abs(Avx2.MultiplyAddAdjacent(pairs, offWeights)).AsInt32();
            return Avx2.CompareGreaterThan(off, Avx2.MultiplyAddAdjacent(pairs, nearWeights));
        }
    }
}
#endif
