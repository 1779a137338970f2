using System;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// A convolution as a product of matrices; a band is a share of the output's rows, or of its pixels where the window is one pixel
    /// and nothing need be copied side by side.
    /// </summary>
    internal unsafe struct ConvolutionBands : IKernelBands
    {
        public FeatureMap Input;
        public FeatureMap Output;
        public SlidingWindow Window;

        /// <summary>Values under the window.</summary>
        public int Depth;
        public float* Weights;
        public float* Bias;
        public float Low;
        public float High;
        public bool UseVectors;
        public int BandCount;

        /// <summary>Scratch, output width × depth for each band; null: the window is one pixel.</summary>
        public float* Columns;

        public void Execute(int band)
        {
            if (Columns == null)
            {
                int firstPixel = (int)((long)Input.Pixels * band / BandCount), endPixel = (int)((long)Input.Pixels * (band + 1) / BandCount);
                Multiply(Input.Data + (long)firstPixel * Depth, endPixel - firstPixel, Output.Data + (long)firstPixel * Output.Channels);
                return;
            }

            int first = (int)((long)Output.Height * band / BandCount), end = (int)((long)Output.Height * (band + 1) / BandCount);
            float* columns = Columns + (long)band * Output.Width * Depth;
            for (int y = first; y < end; y++)
            {
                Gather(y, columns);
                Multiply(columns, Output.Width, Output.Row(y));
            }
        }

        private void Multiply(float* input, int rows, float* output) =>
            PointwiseKernel.Multiply(input, rows, Depth, Weights, Bias, Output.Channels, output, Low, High, UseVectors);

        private void Gather(int y, float* columns)
        {
            int channels = Input.Channels, span = Window.Width * channels;
            int top = y * Window.StrideY - Window.PaddingAbove(Input.Height);
            int left = -Window.PaddingLeft(Input.Width);
            for (int x = 0; x < Output.Width; x++, left += Window.StrideX)
            {
                // Of the window's columns, those within the picture.
                int from = Math.Max(0, -left), to = Math.Min(Window.Width, Input.Width - left);
                for (int k = 0; k < Window.Height; k++, columns += span)
                {
                    bool isInside = (uint)(top + k) < (uint)Input.Height && to > from;
                    if (!isInside || to - from < Window.Width)
                        PixelMemory.Fill(columns, span, 0);
                    if (!isInside)
                        continue;
                    float* source = Input.Row(top + k) + (long)(left + from) * channels;
                    float* target = columns + from * channels;
                    int count = (to - from) * channels;
                    for (int i = 0; i < count; i++)
                        target[i] = source[i];
                }
            }
        }
    }
}
