using System;
using LaserTracking.Kernels;

namespace LaserTracking.Hands.Model
{
    /// <summary>
    /// Infrared in red to grey: brightened, and the root drawn, which is about how a camera shows such a hand. A band is a row of the
    /// crop.
    /// </summary>
    internal unsafe struct ExposureBands : IKernelBands
    {
        public float* Rgb;
        public int Width;
        public float Gain;

        public void Execute(int row)
        {
            float* rgb = Rgb + 3L * row * Width;
            for (int i = 0; i < Width; i++, rgb += 3)
                rgb[0] = rgb[1] = rgb[2] = (float)Math.Sqrt(Math.Min(1, Gain * rgb[0]));
        }
    }
}
