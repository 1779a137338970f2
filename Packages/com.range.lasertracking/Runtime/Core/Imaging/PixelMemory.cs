#if NET8_0_OR_GREATER
using System;
#endif

namespace LaserTracking.Imaging
{
    /// <summary>Plain loops that Burst makes block copies of; .NET has better ones of its own. No overlap.</summary>
    internal static unsafe class PixelMemory
    {
        public static void Copy(uint* source, uint* target, int count)
        {
#if NET8_0_OR_GREATER
            new ReadOnlySpan<uint>(source, count).CopyTo(new Span<uint>(target, count));
#else
            for (int i = 0; i < count; i++)
                target[i] = source[i];
#endif
        }

        public static void Copy(float* source, float* target, int count)
        {
#if NET8_0_OR_GREATER
            new ReadOnlySpan<float>(source, count).CopyTo(new Span<float>(target, count));
#else
            for (int i = 0; i < count; i++)
                target[i] = source[i];
#endif
        }

        public static void Fill(float* target, int count, float value)
        {
#if NET8_0_OR_GREATER
            new Span<float>(target, count).Fill(value);
#else
            for (int i = 0; i < count; i++)
                target[i] = value;
#endif
        }

        /// <summary>The first place of a value; count where there is none.</summary>
        public static int Find(byte* source, int count, byte value)
        {
#if NET8_0_OR_GREATER
            int place = new ReadOnlySpan<byte>(source, count).IndexOf(value);
            return place < 0 ? count : place;
#else
            int i = 0;
            while (i < count && source[i] != value)
                i++;
            return i;
#endif
        }

        public static void Clear(byte* target, int count)
        {
#if NET8_0_OR_GREATER
            new Span<byte>(target, count).Clear();
#else
            for (int i = 0; i < count; i++)
                target[i] = 0;
#endif
        }
    }
}
