using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Hands
{
    /// <summary>Every cell that has a depth waits at level 1, on its own until a body is found behind it; a band is a row.</summary>
    internal unsafe struct DepthLevelBands : IKernelBands
    {
        public int Width;
        public float* Z;
        public byte* Levels;
        public float* Before;

        public void Execute(int row)
        {
            long first = (long)row * Width;
            float* z = Z + first;
            byte* levels = Levels + first;
            int width = Width;
            for (int i = 0; i < width; i++)
                levels[i] = z[i] > 0 ? (byte)1 : (byte)0;
            PixelMemory.Fill(Before + first, width, float.MaxValue);
        }
    }
}
