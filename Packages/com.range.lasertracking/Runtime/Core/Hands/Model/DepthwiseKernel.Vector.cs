#if NET8_0_OR_GREATER
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace LaserTracking.Hands.Model
{
    internal static unsafe partial class DepthwiseKernel
    {
        /// <summary>The channels done, a multiple of eight.</summary>
        [MethodImpl(JitOptions.OptimizeAtOnce)]
        private static int RowVector(float** rows, int window, int widthOfWindow, int stride, int channels, float* weights, float* bias, float* output,
            int width, float low, float high)
        {
            int done = channels & ~7;
            int x = 0;
            for (; x + 4 <= width; x += 4)
            {
                int c = 0;
                for (; c + 16 <= channels; c += 16)
                    FourBySixteen(rows, window, widthOfWindow, x * stride * channels + c, stride * channels, channels, weights + c, bias + c, output + x * channels + c, low, high);
                for (; c < done; c += 8)
                    FourByEight(rows, window, widthOfWindow, x * stride * channels + c, stride * channels, channels, weights + c, bias + c, output + x * channels + c, low, high);
            }

            for (; x < width; x++)
            {
                int c = 0;
                for (; c + 32 <= channels; c += 32)
                    OneByThirtyTwo(rows, window, widthOfWindow, x * stride * channels + c, channels, weights + c, bias + c, output + x * channels + c, low, high);
                for (; c < done; c += 8)
                    OneByEight(rows, window, widthOfWindow, x * stride * channels + c, channels, weights + c, bias + c, output + x * channels + c, low, high);
            }

            return done;
        }

        /// <summary>Four pixels share each weight.</summary>
        [MethodImpl(JitOptions.OptimizeAtOnce)]
        private static void FourBySixteen(float** rows, int window, int widthOfWindow, int offset, int step, int channels, float* weights, float* bias,
            float* output, float low, float high)
        {
            Vector256<float> a0 = Avx.LoadVector256(bias), a1 = Avx.LoadVector256(bias + 8);
            Vector256<float> b0 = a0, b1 = a1, c0 = a0, c1 = a1, d0 = a0, d1 = a1;
            for (int y = 0; y < window; y++)
            {
                float* a = rows[y] + offset;
                float* b = a + step;
                float* c = b + step;
                float* d = c + step;
                for (int k = 0; k < widthOfWindow; k++)
                {
                    Vector256<float> w0 = Avx.LoadVector256(weights), w1 = Avx.LoadVector256(weights + 8);
                    a0 = Fma.MultiplyAdd(w0, Avx.LoadVector256(a), a0);
                    a1 = Fma.MultiplyAdd(w1, Avx.LoadVector256(a + 8), a1);
                    b0 = Fma.MultiplyAdd(w0, Avx.LoadVector256(b), b0);
                    b1 = Fma.MultiplyAdd(w1, Avx.LoadVector256(b + 8), b1);
                    c0 = Fma.MultiplyAdd(w0, Avx.LoadVector256(c), c0);
                    c1 = Fma.MultiplyAdd(w1, Avx.LoadVector256(c + 8), c1);
                    d0 = Fma.MultiplyAdd(w0, Avx.LoadVector256(d), d0);
                    d1 = Fma.MultiplyAdd(w1, Avx.LoadVector256(d + 8), d1);
                    a += channels;
                    b += channels;
                    c += channels;
                    d += channels;
                    weights += channels;
                }
            }

            Vector256<float> least = Vector256.Create(low), most = Vector256.Create(high);
            Store(output, a0, least, most);
            Store(output + 8, a1, least, most);
            Store(output + channels, b0, least, most);
            Store(output + channels + 8, b1, least, most);
            Store(output + 2 * channels, c0, least, most);
            Store(output + 2 * channels + 8, c1, least, most);
            Store(output + 3 * channels, d0, least, most);
            Store(output + 3 * channels + 8, d1, least, most);
        }

        [MethodImpl(JitOptions.OptimizeAtOnce)]
        private static void FourByEight(float** rows, int window, int widthOfWindow, int offset, int step, int channels, float* weights, float* bias,
            float* output, float low, float high)
        {
            Vector256<float> a = Avx.LoadVector256(bias), b = a, c = a, d = a;
            for (int y = 0; y < window; y++)
            {
                float* source = rows[y] + offset;
                for (int k = 0; k < widthOfWindow; k++)
                {
                    Vector256<float> w = Avx.LoadVector256(weights);
                    a = Fma.MultiplyAdd(w, Avx.LoadVector256(source), a);
                    b = Fma.MultiplyAdd(w, Avx.LoadVector256(source + step), b);
                    c = Fma.MultiplyAdd(w, Avx.LoadVector256(source + 2 * step), c);
                    d = Fma.MultiplyAdd(w, Avx.LoadVector256(source + 3 * step), d);
                    source += channels;
                    weights += channels;
                }
            }

            Vector256<float> least = Vector256.Create(low), most = Vector256.Create(high);
            Store(output, a, least, most);
            Store(output + channels, b, least, most);
            Store(output + 2 * channels, c, least, most);
            Store(output + 3 * channels, d, least, most);
        }

        [MethodImpl(JitOptions.OptimizeAtOnce)]
        private static void OneByThirtyTwo(float** rows, int window, int widthOfWindow, int offset, int channels, float* weights, float* bias,
            float* output, float low, float high)
        {
            Vector256<float> a = Avx.LoadVector256(bias), b = Avx.LoadVector256(bias + 8);
            Vector256<float> c = Avx.LoadVector256(bias + 16), d = Avx.LoadVector256(bias + 24);
            for (int y = 0; y < window; y++)
            {
                float* source = rows[y] + offset;
                for (int k = 0; k < widthOfWindow; k++)
                {
                    a = Fma.MultiplyAdd(Avx.LoadVector256(weights), Avx.LoadVector256(source), a);
                    b = Fma.MultiplyAdd(Avx.LoadVector256(weights + 8), Avx.LoadVector256(source + 8), b);
                    c = Fma.MultiplyAdd(Avx.LoadVector256(weights + 16), Avx.LoadVector256(source + 16), c);
                    d = Fma.MultiplyAdd(Avx.LoadVector256(weights + 24), Avx.LoadVector256(source + 24), d);
                    source += channels;
                    weights += channels;
                }
            }

            Vector256<float> least = Vector256.Create(low), most = Vector256.Create(high);
            Store(output, a, least, most);
            Store(output + 8, b, least, most);
            Store(output + 16, c, least, most);
            Store(output + 24, d, least, most);
        }

        [MethodImpl(JitOptions.OptimizeAtOnce)]
        private static void OneByEight(float** rows, int window, int widthOfWindow, int offset, int channels, float* weights, float* bias, float* output,
            float low, float high)
        {
            Vector256<float> sum = Avx.LoadVector256(bias);
            for (int y = 0; y < window; y++)
            {
                float* source = rows[y] + offset;
                for (int k = 0; k < widthOfWindow; k++)
                {
                    sum = Fma.MultiplyAdd(Avx.LoadVector256(weights), Avx.LoadVector256(source), sum);
                    source += channels;
                    weights += channels;
                }
            }

            Store(output, sum, Vector256.Create(low), Vector256.Create(high));
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static void Store(float* output, Vector256<float> value, Vector256<float> least, Vector256<float> most) =>
            Avx.Store(output, Avx.Max(least, Avx.Min(most, value)));
    }
}
#endif
