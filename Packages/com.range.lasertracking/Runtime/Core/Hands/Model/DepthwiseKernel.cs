using System;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// One row of a depthwise convolution: out[x][c] = clamp(bias[c] + Σ in[y][x·stride + kx][c]·weight[y][kx][c]). The rows of the
    /// input already have their padding to both sides; a row outside of the picture is a row of zeros.
    /// </summary>
    internal static unsafe partial class DepthwiseKernel
    {
        /// <param name="rows">One pointer for each row of the window.</param>
        /// <param name="window">Its height (rows) and its width.</param>
        /// <param name="widthOfWindow">Pixels.</param>
        /// <param name="stride">Pixels from one output to the next.</param>
        /// <param name="channels">Values of one pixel.</param>
        /// <param name="weights">[row][column][channel].</param>
        /// <param name="bias">One for each channel.</param>
        /// <param name="output">Width × channels.</param>
        /// <param name="width">Pixels of the output.</param>
        /// <param name="low">Results below are set to this.</param>
        /// <param name="high">Results above are set to this.</param>
        /// <param name="useVectors">Of eight, with fused multiply-add; results differ in the last digits.</param>
        public static void Row(float** rows, int window, int widthOfWindow, int stride, int channels, float* weights, float* bias, float* output,
            int width, float low, float high, bool useVectors)
        {
            int first = 0;
#if NET8_0_OR_GREATER
            if (useVectors)
                first = RowVector(rows, window, widthOfWindow, stride, channels, weights, bias, output, width, low, high);
#endif
            if (first == channels)
                return;
            for (int x = 0; x < width; x++)
            {
                float* target = output + (long)x * channels;
                for (int c = first; c < channels; c++)
                    target[c] = bias[c];
                for (int y = 0; y < window; y++)
                {
                    for (int k = 0; k < widthOfWindow; k++)
                    {
                        float* source = rows[y] + (long)(x * stride + k) * channels;
                        float* weight = weights + (long)(y * widthOfWindow + k) * channels;
                        for (int c = first; c < channels; c++)
                            target[c] += source[c] * weight[c];
                    }
                }

                for (int c = first; c < channels; c++)
                    target[c] = Math.Max(low, Math.Min(high, target[c]));
            }
        }
    }
}
