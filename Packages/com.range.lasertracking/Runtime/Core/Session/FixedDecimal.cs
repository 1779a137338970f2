using System;

namespace LaserTracking.Session
{
    /// <summary>
    /// Numbers as text with at most a given number of decimals, trailing zeros dropped: the same characters on every platform and
    /// in every culture, which the runtime's own formatting does not promise across versions. No allocation.
    /// </summary>
    public static class FixedDecimal
    {
        /// <summary>Room that any number needs.</summary>
        public const int MaximumLength = 32;

        private const double LargestExact = 9007199254740992; // 2^53: above it a double's integers have gaps
        private const double LargestLong = 9.2e18;

        private static readonly double[] PowersOfTen = { 1, 10, 100, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9 };

        /// <summary>
        /// Writes a number in plain notation, rounded to the nearest step (half to even). Numbers too large for the decimals lose
        /// decimals, never digits before the point.
        /// </summary>
        /// <param name="value">Any double.</param>
        /// <param name="decimals">0…9.</param>
        /// <param name="destination">At least <see cref="MaximumLength"/> bytes.</param>
        /// <returns>Bytes written; 0 for NaN, infinities and magnitudes of 9.2e18 and more, which have no such text.</returns>
        public static int Write(double value, int decimals, Span<byte> destination)
        {
            double magnitude = Math.Abs(value);
            if (!(magnitude < LargestLong))
                return 0;
            while (decimals > 0 && magnitude * PowersOfTen[decimals] >= LargestExact)
                decimals--;
            long scaled = (long)Math.Round(magnitude * PowersOfTen[decimals], MidpointRounding.ToEven);
            while (decimals > 0 && scaled % 10 == 0)
            {
                scaled /= 10;
                decimals--;
            }

            int length = 0;
            if (value < 0 && scaled != 0)
                destination[length++] = (byte)'-';
            int digits = Math.Max(CountDigits(scaled), decimals + 1);
            int end = length + digits + (decimals > 0 ? 1 : 0);
            for (int i = end - 1, written = 0; i >= length; i--, written++)
            {
                if (decimals > 0 && written == decimals)
                {
                    destination[i] = (byte)'.';
                    continue;
                }

                destination[i] = (byte)('0' + scaled % 10);
                scaled /= 10;
            }

            return end;
        }

        /// <summary>Writes a whole number. Returns the bytes written, at most 20.</summary>
        public static int Write(long value, Span<byte> destination)
        {
            ulong rest = value < 0 ? 0UL - unchecked((ulong)value) : (ulong)value;
            int length = 0;
            if (value < 0)
                destination[length++] = (byte)'-';
            int digits = 1;
            for (ulong left = rest; left >= 10; left /= 10)
                digits++;
            for (int i = length + digits - 1; i >= length; i--)
            {
                destination[i] = (byte)('0' + rest % 10);
                rest /= 10;
            }

            return length + digits;
        }

        private static int CountDigits(long value)
        {
            int digits = 1;
            while (value >= 10)
            {
                value /= 10;
                digits++;
            }

            return digits;
        }
    }
}
