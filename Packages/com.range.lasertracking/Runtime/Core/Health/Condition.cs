namespace LaserTracking.Health
{
    /// <summary>
    /// Something that begins and ends, with a gap between the two limits and a time that either must last, so that what wavers about
    /// a limit is said once.
    /// </summary>
    internal struct Condition
    {
        private long _sinceUs;
        private bool _isChanging;

        /// <summary>It has begun and not ended.</summary>
        public bool IsOn { get; private set; }

        /// <summary>Takes the present state; true when this is the moment at which it begins or ends.</summary>
        /// <param name="isAbove">Beyond the limit from which it begins.</param>
        /// <param name="isBelow">Beyond the limit at which it ends; not the opposite of the other.</param>
        /// <param name="timeUs">Now.</param>
        /// <param name="beginAfterUs">How long it must be above without a break to begin.</param>
        /// <param name="endAfterUs">How long it must be below without a break to end.</param>
        public bool Update(bool isAbove, bool isBelow, long timeUs, long beginAfterUs, long endAfterUs)
        {
            if (IsOn ? !isBelow : !isAbove)
            {
                _isChanging = false;
                return false;
            }

            if (!_isChanging || timeUs < _sinceUs)
            {
                _isChanging = true;
                _sinceUs = timeUs;
            }

            if (timeUs - _sinceUs < (IsOn ? endAfterUs : beginAfterUs))
                return false;
            _isChanging = false;
            IsOn = !IsOn;
            return true;
        }
    }
}
