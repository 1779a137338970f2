namespace LaserTracking.Kernels
{
    /// <summary>A heavy loop cut into bands that may run in any order and at the same time.</summary>
    internal interface IKernelBands
    {
        void Execute(int band);
    }
}
