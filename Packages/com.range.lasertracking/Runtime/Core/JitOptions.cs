using System.Runtime.CompilerServices;

namespace LaserTracking
{
    /// <summary>Hints to .NET's compiler that netstandard2.1 has no names for.</summary>
    internal static class JitOptions
    {
        /// <summary>
        /// MethodImplOptions.AggressiveOptimization: fully optimised from the first call. For kernels that run for milliseconds a
        /// frame, where .NET's improvement step by step would outlast a short recording. Mono and Burst ignore it.
        /// </summary>
        public const MethodImplOptions OptimizeAtOnce = (MethodImplOptions)512;
    }
}
