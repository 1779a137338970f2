namespace LaserTracking.Remote
{
    /// <summary>
    /// Which numbers of a growing series were there already: the newest and the 63 before it, as in IPsec's anti-replay window
    /// (RFC 4303, 3.4.3), so that what overtakes on the way is not lost. Older ones count as seen.
    /// </summary>
    internal struct CounterWindow
    {
        private const int Size = 64;

        private long _newest;
        private ulong _seen;

        public bool HasSeen(long number)
        {
            long back = _newest - number;
            return back >= 0 && (back >= Size || (_seen >> (int)back & 1) != 0);
        }

        public void Mark(long number)
        {
            long ahead = number - _newest;
            if (ahead > 0)
            {
                _seen = ahead >= Size ? 0 : _seen << (int)ahead;
                _newest = number;
                _seen |= 1;
            }
            else
            {
                _seen |= 1UL << (int)-ahead;
            }
        }
    }
}
