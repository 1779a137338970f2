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
            for (long i = first; i < first + Width; i++)
            {
                Levels[i] = Z[i] > 0 ? (byte)1 : (byte)0;
                Before[i] = float.MaxValue;
            }
        }
    }
}
