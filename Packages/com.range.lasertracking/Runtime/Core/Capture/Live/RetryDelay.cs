using System;

namespace LaserTracking.Capture.Live
{
    /// <summary>How long to wait before a lost camera is looked for again: doubles up to a longest wait.</summary>
    public sealed class RetryDelay
    {
        private readonly long _firstUs;
        private readonly long _longestUs;
        private long _nextUs;

        public RetryDelay(int firstMs, int longestMs)
        {
            _firstUs = firstMs * 1000L;
            _longestUs = longestMs * 1000L;
            _nextUs = _firstUs;
        }

        /// <summary>The wait after one more failure, microseconds.</summary>
        public long Next()
        {
            long wait = _nextUs;
            _nextUs = Math.Min(_longestUs, _nextUs * 2);
            return wait;
        }

        /// <summary>It works again.</summary>
        public void Reset() => _nextUs = _firstUs;
    }
}
