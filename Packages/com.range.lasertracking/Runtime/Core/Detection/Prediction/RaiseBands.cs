using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>Each byte of a picture becomes the larger one; a band is a run of pixels.</summary>
    internal unsafe struct RaiseBands : IKernelBands
    {
        public const int PixelsPerBand = 4096;

        public uint* Source;
        public uint* Target;
        public int Count;
        public bool UseVectors;

        public int BandCount => (Count + PixelsPerBand - 1) / PixelsPerBand;

        public void Execute(int band)
        {
            int first = band * PixelsPerBand, count = Count - first < PixelsPerBand ? Count - first : PixelsPerBand;
            ExpectationKernel.Raise(Source + first, count, Target + first, UseVectors);
        }
    }
}
