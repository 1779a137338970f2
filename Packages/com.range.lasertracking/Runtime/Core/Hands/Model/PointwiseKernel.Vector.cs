#if NET8_0_OR_GREATER
using System;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LaserTracking.Hands.Model
{
    internal static unsafe partial class PointwiseKernel
    {
        // Six rows by sixteen outputs are twelve sums, which with two weights and one value fill the sixteen registers of AVX2.
        private static void MultiplyVector(float* input, int rows, int depth, float* packed, float* bias, int outputs, float* output, float low, float high)
        {
            float* tile = stackalloc float[6 * Block];
            for (int first = 0; first < outputs; first += Block)
            {
                float* weights = packed + (long)first * depth;
                int count = Math.Min(Block, outputs - first);
                bool isWhole = count == Block;
                for (int row = 0; row < rows;)
                {
                    float* from = input + (long)row * depth;
                    float* to = output + (long)row * outputs + first;
                    float* target = isWhole ? to : tile;
                    int stride = isWhole ? outputs : Block;
                    int height = rows - row >= 6 ? 6 : rows - row >= 4 ? 4 : 1;
                    if (count <= 8 && height == 6)
                        SixByEight(from, depth, weights, bias + first, target, stride, low, high);
                    else if (height == 6)
                        SixRows(from, depth, weights, bias + first, target, stride, low, high);
                    else if (height == 4)
                        FourRows(from, depth, weights, bias + first, target, stride, low, high);
                    else
                        OneRow(from, depth, weights, bias + first, target, low, high);
                    for (int i = 0; i < height && !isWhole; i++)
                        Buffer.MemoryCopy(tile + i * Block, to + (long)i * outputs, count * sizeof(float), count * sizeof(float));
                    row += height;
                }
            }
        }

        [MethodImpl(JitOptions.OptimizeAtOnce)]
        private static void SixRows(float* input, int depth, float* weights, float* bias, float* output, int stride, float low, float high)
        {
            Vector256<float> a0 = Avx.LoadVector256(bias), a1 = Avx.LoadVector256(bias + 8);
            Vector256<float> b0 = a0, b1 = a1, c0 = a0, c1 = a1, d0 = a0, d1 = a1, e0 = a0, e1 = a1, f0 = a0, f1 = a1;
            float* a = input;
            float* b = a + depth;
            float* c = b + depth;
            float* d = c + depth;
            float* e = d + depth;
            float* f = e + depth;
            for (int k = 0; k < depth; k++, weights += Block)
            {
                Vector256<float> w0 = Avx.LoadVector256(weights), w1 = Avx.LoadVector256(weights + 8);
                Vector256<float> value = Avx.BroadcastScalarToVector256(a + k);
                a0 = Fma.MultiplyAdd(value, w0, a0);
                a1 = Fma.MultiplyAdd(value, w1, a1);
                value = Avx.BroadcastScalarToVector256(b + k);
                b0 = Fma.MultiplyAdd(value, w0, b0);
                b1 = Fma.MultiplyAdd(value, w1, b1);
                value = Avx.BroadcastScalarToVector256(c + k);
                c0 = Fma.MultiplyAdd(value, w0, c0);
                c1 = Fma.MultiplyAdd(value, w1, c1);
                value = Avx.BroadcastScalarToVector256(d + k);
                d0 = Fma.MultiplyAdd(value, w0, d0);
                d1 = Fma.MultiplyAdd(value, w1, d1);
                value = Avx.BroadcastScalarToVector256(e + k);
                e0 = Fma.MultiplyAdd(value, w0, e0);
                e1 = Fma.MultiplyAdd(value, w1, e1);
                value = Avx.BroadcastScalarToVector256(f + k);
                f0 = Fma.MultiplyAdd(value, w0, f0);
                f1 = Fma.MultiplyAdd(value, w1, f1);
            }

            Vector256<float> least = Vector256.Create(low), most = Vector256.Create(high);
            Store(output, a0, a1, least, most);
            Store(output + stride, b0, b1, least, most);
            Store(output + 2L * stride, c0, c1, least, most);
            Store(output + 3L * stride, d0, d1, least, most);
            Store(output + 4L * stride, e0, e1, least, most);
            Store(output + 5L * stride, f0, f1, least, most);
        }

        [MethodImpl(JitOptions.OptimizeAtOnce)]
        private static void SixByEight(float* input, int depth, float* weights, float* bias, float* output, int stride, float low, float high)
        {
            Vector256<float> a = Avx.LoadVector256(bias), b = a, c = a, d = a, e = a, f = a;
            float* second = input + depth;
            float* third = second + depth;
            float* fourth = third + depth;
            float* fifth = fourth + depth;
            float* sixth = fifth + depth;
            for (int k = 0; k < depth; k++, weights += Block)
            {
                Vector256<float> w = Avx.LoadVector256(weights);
                a = Fma.MultiplyAdd(Avx.BroadcastScalarToVector256(input + k), w, a);
                b = Fma.MultiplyAdd(Avx.BroadcastScalarToVector256(second + k), w, b);
                c = Fma.MultiplyAdd(Avx.BroadcastScalarToVector256(third + k), w, c);
                d = Fma.MultiplyAdd(Avx.BroadcastScalarToVector256(fourth + k), w, d);
                e = Fma.MultiplyAdd(Avx.BroadcastScalarToVector256(fifth + k), w, e);
                f = Fma.MultiplyAdd(Avx.BroadcastScalarToVector256(sixth + k), w, f);
            }

            Vector256<float> least = Vector256.Create(low), most = Vector256.Create(high);
            Avx.Store(output, Avx.Max(least, Avx.Min(most, a)));
            Avx.Store(output + stride, Avx.Max(least, Avx.Min(most, b)));
            Avx.Store(output + 2L * stride, Avx.Max(least, Avx.Min(most, c)));
            Avx.Store(output + 3L * stride, Avx.Max(least, Avx.Min(most, d)));
            Avx.Store(output + 4L * stride, Avx.Max(least, Avx.Min(most, e)));
            Avx.Store(output + 5L * stride, Avx.Max(least, Avx.Min(most, f)));
        }

        [MethodImpl(JitOptions.OptimizeAtOnce)]
        private static void FourRows(float* input, int depth, float* weights, float* bias, float* output, int stride, float low, float high)
        {
            Vector256<float> a0 = Avx.LoadVector256(bias), a1 = Avx.LoadVector256(bias + 8);
            Vector256<float> b0 = a0, b1 = a1, c0 = a0, c1 = a1, d0 = a0, d1 = a1;
            float* b = input + depth;
            float* c = b + depth;
            float* d = c + depth;
            for (int k = 0; k < depth; k++, weights += Block)
            {
                Vector256<float> w0 = Avx.LoadVector256(weights), w1 = Avx.LoadVector256(weights + 8);
                Vector256<float> value = Avx.BroadcastScalarToVector256(input + k);
                a0 = Fma.MultiplyAdd(value, w0, a0);
                a1 = Fma.MultiplyAdd(value, w1, a1);
                value = Avx.BroadcastScalarToVector256(b + k);
                b0 = Fma.MultiplyAdd(value, w0, b0);
                b1 = Fma.MultiplyAdd(value, w1, b1);
                value = Avx.BroadcastScalarToVector256(c + k);
                c0 = Fma.MultiplyAdd(value, w0, c0);
                c1 = Fma.MultiplyAdd(value, w1, c1);
                value = Avx.BroadcastScalarToVector256(d + k);
                d0 = Fma.MultiplyAdd(value, w0, d0);
                d1 = Fma.MultiplyAdd(value, w1, d1);
            }

            Vector256<float> least = Vector256.Create(low), most = Vector256.Create(high);
            Store(output, a0, a1, least, most);
            Store(output + stride, b0, b1, least, most);
            Store(output + 2L * stride, c0, c1, least, most);
            Store(output + 3L * stride, d0, d1, least, most);
        }

        [MethodImpl(JitOptions.OptimizeAtOnce)]
        private static void OneRow(float* input, int depth, float* weights, float* bias, float* output, float low, float high)
        {
            Vector256<float> s0 = Avx.LoadVector256(bias), s1 = Avx.LoadVector256(bias + 8);
            for (int k = 0; k < depth; k++, weights += Block)
            {
                Vector256<float> value = Avx.BroadcastScalarToVector256(input + k);
                s0 = Fma.MultiplyAdd(value, Avx.LoadVector256(weights), s0);
                s1 = Fma.MultiplyAdd(value, Avx.LoadVector256(weights + 8), s1);
            }

            Store(output, s0, s1, Vector256.Create(low), Vector256.Create(high));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Store(float* output, Vector256<float> first, Vector256<float> second, Vector256<float> least, Vector256<float> most)
        {
            Avx.Store(output, Avx.Max(least, Avx.Min(most, first)));
            Avx.Store(output + 8, Avx.Max(least, Avx.Min(most, second)));
        }
    }
}
#endif
