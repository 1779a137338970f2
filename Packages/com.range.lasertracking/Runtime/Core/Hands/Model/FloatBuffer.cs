using System;
using System.Runtime.InteropServices;

namespace LaserTracking.Hands.Model
{
    /// <summary>Native memory for floats, aligned to 64 bytes and zero at first. Valid until <see cref="Dispose"/>.</summary>
    internal sealed unsafe class FloatBuffer : IDisposable
    {
        private const int Alignment = 64;

        private IntPtr _memory;

        /// <param name="count">0 or more.</param>
        public FloatBuffer(long count)
        {
            long bytes = Math.Max(1, count) * sizeof(float);
            _memory = Marshal.AllocHGlobal(new IntPtr(bytes + Alignment));
            Floats = (float*)((_memory.ToInt64() + Alignment - 1) / Alignment * Alignment);
            Count = count;
            for (long i = 0; i < count; i++)
                Floats[i] = 0;
        }

        ~FloatBuffer() => Free();

        public float* Floats { get; private set; }

        public long Count { get; }

        public void Dispose()
        {
            Free();
            GC.SuppressFinalize(this);
        }

        private void Free()
        {
            if (_memory != IntPtr.Zero)
                Marshal.FreeHGlobal(_memory);
            _memory = IntPtr.Zero;
            Floats = null;
        }
    }
}
