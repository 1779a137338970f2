using System;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// out[p][j] = clamp(bias[j] + Σ_k in[p][k]·weight[k][j]) for rows of floats: convolutions of 1×1, any convolution whose windows
    /// were copied side by side, and fully connected layers. Weights are packed in blocks of <see cref="Block"/> outputs:
    /// [block][k][16], zeros after the last output, so that a block stays in the first-level cache while all rows pass.
    /// </summary>
    internal static unsafe partial class PointwiseKernel
    {
        /// <summary>Outputs side by side in packed weights: two vectors of eight.</summary>
        public const int Block = 16;

        public static int PackedLength(int outputs, int depth) => (outputs + Block - 1) / Block * Block * depth;

        /// <summary>From [output][k], as the file has them.</summary>
        public static void Pack(ReadOnlySpan<float> weights, int outputs, int depth, float* packed)
        {
            for (int j = 0; j < outputs; j++)
            {
                float* column = packed + (long)(j / Block) * Block * depth + j % Block;
                for (int k = 0; k < depth; k++)
                    column[(long)k * Block] = weights[j * depth + k];
            }
        }

        /// <param name="input">Rows × depth.</param>
        /// <param name="rows">Pixels, or 1.</param>
        /// <param name="depth">Values of one row.</param>
        /// <param name="packed">Of <see cref="Pack"/>.</param>
        /// <param name="bias">Room for whole blocks, zeros after the last output.</param>
        /// <param name="outputs">Values of one row of the output.</param>
        /// <param name="output">Rows × outputs; not the input.</param>
        /// <param name="low">Results below are set to this.</param>
        /// <param name="high">Results above are set to this.</param>
        /// <param name="useVectors">Of eight, with fused multiply-add; results differ in the last digits.</param>
        public static void Multiply(float* input, int rows, int depth, float* packed, float* bias, int outputs, float* output, float low, float high,
            bool useVectors)
        {
#if NET8_0_OR_GREATER
            if (useVectors)
            {
                MultiplyVector(input, rows, depth, packed, bias, outputs, output, low, high);
                return;
            }
#endif
            for (int first = 0; first < outputs; first += Block)
            {
                float* weights = packed + (long)first * depth;
                int count = Math.Min(Block, outputs - first);
                for (int row = 0; row < rows; row++)
                    RowScalar(input + (long)row * depth, depth, weights, bias + first, count, output + (long)row * outputs + first, low, high);
            }
        }

        private static void RowScalar(float* input, int depth, float* weights, float* bias, int count, float* output, float low, float high)
        {
            float* sums = stackalloc float[Block];
            for (int j = 0; j < Block; j++)
                sums[j] = bias[j];
            for (int k = 0; k < depth; k++)
            {
                float value = input[k];
                float* weight = weights + (long)k * Block;
                for (int j = 0; j < Block; j++)
                    sums[j] += value * weight[j];
            }

            for (int j = 0; j < count; j++)
                output[j] = Math.Max(low, Math.Min(high, sums[j]));
        }
    }
}
