using LaserTracking.Kernels;

namespace LaserTracking.Unity
{
    /// <summary>What runs the heavy kernels of detection and hands.</summary>
    internal static class RangeKernels
    {
        /// <summary>Burst where the package com.unity.burst is there, plain code elsewhere; the results are the same. Main thread.</summary>
        public static KernelRunner Create()
        {
#if RANGE_BURST
            return new LaserTracking.Burst.BurstKernelRunner();
#else
            return KernelRunner.Plain;
#endif
        }
    }
}
