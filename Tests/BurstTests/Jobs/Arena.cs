using System;
using System.Runtime.InteropServices;

namespace LaserTracking.Burst
{
    /// <summary>Native memory, random by a seed, handed out in pieces with some in between that nobody may touch.</summary>
    internal sealed unsafe class Arena : IDisposable
    {
        private const int Size = 1 << 20, Gap = 64;
        private readonly byte* _memory = (byte*)Marshal.AllocHGlobal(Size);
        private readonly Random _random;
        private int _used = Gap;

        public Arena(int seed)
        {
            _random = new Random(seed);
            ulong state = (ulong)seed * 0x9E3779B97F4A7C15 + 1;
            for (int i = 0; i < Size / sizeof(ulong); i++)
            {
                state ^= state << 13;
                state ^= state >> 7;
                state ^= state << 17;
                ((ulong*)_memory)[i] = state;
            }
        }

        public ReadOnlySpan<byte> Bytes => new ReadOnlySpan<byte>(_memory, Size);

        public T* Take<T>(int count) where T : unmanaged
        {
            byte* piece = _memory + _used;
            _used += (count * sizeof(T) + Gap - 1) / Gap * Gap + Gap;
            if (_used > Size)
                throw new InvalidOperationException("the arena is too small for this test");
            return (T*)piece;
        }

        public T* Zeros<T>(int count) where T : unmanaged
        {
            T* piece = Take<T>(count);
            new Span<T>(piece, count).Clear();
            return piece;
        }

        /// <summary>From low to high.</summary>
        public float* Floats(int count, float low, float high)
        {
            float* piece = Take<float>(count);
            for (int i = 0; i < count; i++)
                piece[i] = low + (high - low) * _random.NextSingle();
            return piece;
        }

        public int* Indices(int count, int below)
        {
            int* piece = Take<int>(count);
            for (int i = 0; i < count; i++)
                piece[i] = _random.Next(below);
            return piece;
        }

        public void Dispose() => Marshal.FreeHGlobal((IntPtr)_memory);
    }
}
