using System;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Hands.Model
{
    /// <summary>The largest value under a window; a band is a row of the output.</summary>
    internal unsafe struct MaxPoolBands : IKernelBands
    {
        public FeatureMap Input;
        public FeatureMap Output;
        public SlidingWindow Window;
        public float Low;
        public float High;

        public void Execute(int row)
        {
            int top = row * Window.StrideY - Window.PaddingAbove(Input.Height), padding = Window.PaddingLeft(Input.Width);
            for (int x = 0; x < Output.Width; x++)
                Pool(Output.Row(row) + (long)x * Output.Channels, top, x * Window.StrideX - padding);
        }

        private void Pool(float* output, int top, int left)
        {
            int channels = Output.Channels, bottom = Math.Min(Input.Height, top + Window.Height), right = Math.Min(Input.Width, left + Window.Width);
            PixelMemory.Fill(output, channels, float.NegativeInfinity);
            for (int y = Math.Max(0, top); y < bottom; y++)
            {
                for (int x = Math.Max(0, left); x < right; x++)
                {
                    float* source = Input.Row(y) + (long)x * channels;
                    for (int c = 0; c < channels; c++)
                        output[c] = source[c] > output[c] ? source[c] : output[c];
                }
            }

            for (int c = 0; c < channels; c++)
                output[c] = Math.Max(Low, Math.Min(High, output[c]));
        }
    }
}
