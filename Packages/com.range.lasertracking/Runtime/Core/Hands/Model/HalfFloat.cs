using System;

namespace LaserTracking.Hands.Model
{
    /// <summary>IEEE 754 binary16, which netstandard2.1 has no type for.</summary>
    internal static class HalfFloat
    {
        /// <summary>The same number as a float; exact.</summary>
        public static float ToSingle(ushort half)
        {
            int sign = (half & 0x8000) << 16;
            int exponent = (half >> 10) & 0x1F;
            int fraction = half & 0x3FF;
            if (exponent == 0)
            {
                float small = fraction * (1f / (1 << 24));
                return sign == 0 ? small : -small;
            }

            int bits = exponent == 0x1F ? 0x7F800000 : (exponent + 112) << 23;
            return BitConverter.Int32BitsToSingle(sign | bits | (fraction << 13));
        }
    }
}
