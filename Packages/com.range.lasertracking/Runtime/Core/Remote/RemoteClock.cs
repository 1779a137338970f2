using System;

namespace LaserTracking.Remote
{
    /// <summary>
    /// How old a message's content is although nobody knows how the sender's clock stands: the message that came quickest within the last
    /// half minute counts as fresh. A drift of the clocks is followed; a clock that jumps is noticed. One thread; no allocation.
    /// </summary>
    public sealed class RemoteClock
    {
        private const long WindowUs = 15_000_000;

        /// <summary>No network is so slow: the sender began anew.</summary>
        private const long JumpUs = 5_000_000;

        private long _leastUs = long.MaxValue;
        private long _lastLeastUs = long.MaxValue;
        private long _windowEndUs;

        /// <summary>A message has come.</summary>
        /// <param name="timeUs">When its content was so, on the sender's clock.</param>
        /// <param name="receivedUs">When it came, on the receiver's; not before the last one.</param>
        public void Add(long timeUs, long receivedUs)
        {
            long differenceUs = receivedUs - timeUs;
            if (Math.Min(_leastUs, _lastLeastUs) < differenceUs - JumpUs)
                _leastUs = _lastLeastUs = long.MaxValue;
            if (receivedUs >= _windowEndUs)
            {
                _lastLeastUs = _leastUs;
                _leastUs = long.MaxValue;
                _windowEndUs = receivedUs + WindowUs;
            }

            _leastUs = Math.Min(_leastUs, differenceUs);
        }

        /// <summary>Seconds since a moment on the sender's clock, beyond what the quickest message took; at least 0.</summary>
        /// <param name="timeUs">On the sender's clock.</param>
        /// <param name="nowUs">On the receiver's.</param>
        public double AgeS(long timeUs, long nowUs)
        {
            long leastUs = Math.Min(_leastUs, _lastLeastUs);
            return leastUs == long.MaxValue ? 0 : Math.Max(0, nowUs - timeUs - leastUs) * 1e-6;
        }
    }
}
