using System;
using LaserTracking.Kernels;
#if NET8_0_OR_GREATER
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;
#endif

namespace LaserTracking.Hands.Model
{
    /// <summary>Sums of two rows of floats; a band is a run of them.</summary>
    internal unsafe struct AddBands : IKernelBands
    {
        public const int ValuesPerBand = 8192;

        public float* First;
        public float* Second;
        public float* Sum;
        public int Count;
        public float Low;
        public float High;
        public bool UseVectors;

        public int BandCount => (Count + ValuesPerBand - 1) / ValuesPerBand;

        public void Execute(int band)
        {
            int i = band * ValuesPerBand, end = Count - i < ValuesPerBand ? Count : i + ValuesPerBand;
            float* a = First;
            float* b = Second;
            float* sum = Sum;
            float low = Low, high = High;
#if NET8_0_OR_GREATER
            if (UseVectors)
            {
                Vector256<float> least = Vector256.Create(low), most = Vector256.Create(high);
                for (; i + 8 <= end; i += 8)
                    Avx.Store(sum + i, Avx.Max(least, Avx.Min(most, Avx.Add(Avx.LoadVector256(a + i), Avx.LoadVector256(b + i)))));
            }
#endif
            for (; i < end; i++)
                sum[i] = Math.Max(low, Math.Min(high, a[i] + b[i]));
        }
    }
}
