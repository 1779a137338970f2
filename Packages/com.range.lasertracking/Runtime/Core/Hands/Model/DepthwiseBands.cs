using System;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// A depthwise convolution; a band is a share of the output's rows. The rows under the window lie in a ring of padded copies, one
    /// for each band, so that the kernel knows no borders.
    /// </summary>
    internal unsafe struct DepthwiseBands : IKernelBands
    {
        public FeatureMap Input;
        public FeatureMap Output;
        public SlidingWindow Window;
        public float* Weights;
        public float* Bias;
        public float Low;
        public float High;
        public bool UseVectors;
        public int BandCount;

        /// <summary>Floats of one padded row.</summary>
        public int RowLength;

        /// <summary>One row more than the window has for each band: the last one is zeros, in place of those above and below the picture.</summary>
        public float* Rings;

        public void Execute(int band)
        {
            int first = (int)((long)Output.Height * band / BandCount), end = (int)((long)Output.Height * (band + 1) / BandCount);
            float* ring = Rings + (long)band * (Window.Height + 1) * RowLength;
            float* zeros = ring + (long)Window.Height * RowLength;

            // Room for a pointer each; of constant size, so that no instruction checks for overflow.
            long* room = stackalloc long[SlidingWindow.MaxSide];
            float** rows = (float**)room;
            int above = Window.PaddingAbove(Input.Height), filled = 0;
            for (int y = first; y < end; y++)
            {
                int top = y * Window.StrideY - above;
                filled = Math.Max(filled, top);
                for (; filled < Math.Min(Input.Height, top + Window.Height); filled++)
                    Fill(ring, filled);
                for (int k = 0; k < Window.Height; k++)
                    rows[k] = (uint)(top + k) < (uint)Input.Height ? ring + (long)((top + k) % Window.Height) * RowLength : zeros;
                DepthwiseKernel.Row(rows, Window.Height, Window.Width, Window.StrideX, Input.Channels, Weights, Bias, Output.Row(y), Output.Width, Low, High, UseVectors);
            }
        }

        /// <summary>The padding stays zero from the start: only the picture's part is ever written.</summary>
        private void Fill(float* ring, int y)
        {
            float* target = ring + (long)(y % Window.Height) * RowLength + Window.PaddingLeft(Input.Width) * Input.Channels;
            PixelMemory.Copy(Input.Row(y), target, Input.Width * Input.Channels);
        }
    }
}
