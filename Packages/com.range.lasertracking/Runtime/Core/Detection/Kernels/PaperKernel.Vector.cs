#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LaserTracking.Detection
{
    /// <summary>Blocks of eight; each returns how far it came, where it began when the processor lacks 256-bit vectors. No fused multiply-add: it rounds otherwise.</summary>
    internal static unsafe partial class PaperKernel
    {
        private const int Block = 8;

        private static int HalveVector(byte* rows, long strideBytes, int width, float* intensity, float* excess)
        {
            if (!Avx2.IsSupported)
                return 0;
            Vector256<uint> pairs = Vector256.Create(0x00FF00FFu), low = Vector256.Create(0xFFFFu);
            Vector256<float> scale = Vector256.Create(0.25f), half = Vector256.Create(0.5f);
            Vector256<float> fromBlue = Vector256.Create(0.114f), fromGreen = Vector256.Create(0.587f), fromRed = Vector256.Create(0.299f);
            byte* second = rows + strideBytes;
            int x = 0;
            for (; x + Block <= width; x += Block)
            {
                // Blue and red, and green and alpha, as pairs of 16 bits: four pixels' sums fit.
                Vector256<uint> a0 = Avx.LoadVector256((uint*)(rows + 8 * x)), a1 = Avx.LoadVector256((uint*)(second + 8 * x));
                Vector256<uint> b0 = Avx.LoadVector256((uint*)(rows + 8 * x) + 8), b1 = Avx.LoadVector256((uint*)(second + 8 * x) + 8);
                Vector256<uint> blueRed = Neighbors((a0 & pairs) + (a1 & pairs), (b0 & pairs) + (b1 & pairs));
                Vector256<uint> greenAlpha = Neighbors(
                    (Avx2.ShiftRightLogical(a0, 8) & pairs) + (Avx2.ShiftRightLogical(a1, 8) & pairs),
                    (Avx2.ShiftRightLogical(b0, 8) & pairs) + (Avx2.ShiftRightLogical(b1, 8) & pairs));
                Vector256<float> blue = Avx.ConvertToVector256Single((blueRed & low).AsInt32()) * scale;
                Vector256<float> red = Avx.ConvertToVector256Single(Avx2.ShiftRightLogical(blueRed, 16).AsInt32()) * scale;
                Vector256<float> green = Avx.ConvertToVector256Single((greenAlpha & low).AsInt32()) * scale;
                Avx.Store(intensity + x, Avx.Add(Avx.Add(Avx.Multiply(fromBlue, blue), Avx.Multiply(fromGreen, green)), Avx.Multiply(fromRed, red)));
                Avx.Store(excess + x, Avx.Max(Avx.Subtract(green, Avx.Multiply(half, Avx.Add(red, blue))), Vector256<float>.Zero));
            }

            return x;
        }

        /// <summary>Sums of neighbouring lanes of sixteen, in order.</summary>
        private static Vector256<uint> Neighbors(Vector256<uint> a, Vector256<uint> b)
        {
            Vector256<uint> even = Avx.Shuffle(a.AsSingle(), b.AsSingle(), 0x88).AsUInt32();
            Vector256<uint> odd = Avx.Shuffle(a.AsSingle(), b.AsSingle(), 0xDD).AsUInt32();
            return Avx2.Permute4x64((even + odd).AsUInt64(), 0xD8).AsUInt32();
        }

        private static int DifferVector(float* intensity, float* background, float* next, int width, float alpha, float* difference)
        {
            if (!Avx.IsSupported)
                return 0;
            Vector256<float> keep = Vector256.Create(alpha), take = Vector256.Create(1 - alpha), sign = Vector256.Create(-0f);
            int x = 0;
            for (; x + Block <= width; x += Block)
            {
                Vector256<float> now = Avx.LoadVector256(intensity + x), before = Avx.LoadVector256(background + x);
                Avx.Store(difference + x, Avx.AndNot(sign, Avx.Subtract(now, before)));
                Avx.Store(next + x, Avx.Add(Avx.Multiply(keep, before), Avx.Multiply(take, now)));
            }

            return x;
        }

        private static int BlurRowVector(float* source, int width, float* target)
        {
            if (!Avx.IsSupported)
                return 1;
            int x = 1;
            for (; x + Block < width; x += Block)
                Avx.Store(target + x, OneTwoOne(Avx.LoadVector256(source + x - 1), Avx.LoadVector256(source + x), Avx.LoadVector256(source + x + 1)));
            return x;
        }

        private static int BlurColumnsVector(float* above, float* middle, float* below, int width, float* target)
        {
            if (!Avx.IsSupported)
                return 0;
            int x = 0;
            for (; x + Block <= width; x += Block)
                Avx.Store(target + x, OneTwoOne(Avx.LoadVector256(above + x), Avx.LoadVector256(middle + x), Avx.LoadVector256(below + x)));
            return x;
        }

        private static Vector256<float> OneTwoOne(Vector256<float> before, Vector256<float> middle, Vector256<float> after) =>
            Avx.Multiply(Avx.Add(Avx.Add(before, Avx.Add(middle, middle)), after), Vector256.Create(0.25f));

        private static int ScoreVector(float* difference, float* excess, float* spike, int width, float gamma, float spikeWeight, float excessWeight, float* score)
        {
            if (!Avx.IsSupported)
                return 0;
            Vector256<float> decay = Vector256.Create(gamma), ofSpike = Vector256.Create(spikeWeight), ofExcess = Vector256.Create(excessWeight);
            int x = 0;
            for (; x + Block <= width; x += Block)
            {
                Vector256<float> m = Avx.Max(Avx.LoadVector256(difference + x), Avx.Multiply(decay, Avx.LoadVector256(spike + x)));
                Avx.Store(spike + x, m);
                Avx.Store(score + x, Avx.Add(Avx.Multiply(ofSpike, m), Avx.Multiply(ofExcess, Avx.LoadVector256(excess + x))));
            }

            return x;
        }

        private static int FindCandidateVector(float* score, float* excess, int start, int count, float minScore, float minExcess, float above)
        {
            if (!Avx.IsSupported)
                return start;
            Vector256<float> leastExcess = Vector256.Create(minExcess), leastScore = Vector256.Create(minScore), beat = Vector256.Create(above);
            int i = start;
            for (; i + Block <= count; i += Block)
            {
                Vector256<float> green = Avx.CompareGreaterThanOrEqual(Avx.LoadVector256(excess + i), leastExcess);
                if (Avx.MoveMask(green) == 0)
                    continue;
                Vector256<float> value = Avx.LoadVector256(score + i);
                if (Avx.MoveMask(Avx.And(green, Avx.And(Avx.CompareGreaterThanOrEqual(value, leastScore), Avx.CompareGreaterThan(value, beat)))) != 0)
                    break;
            }

            return i;
        }
    }
}
#endif
