using System;

namespace LaserTracking.Hands
{
    /// <summary>The hands of one frame of camera 1. Fixed room, used again for every frame.</summary>
    public sealed class HandObservations
    {
        private readonly HandObservation[] _hands;
        private int _count;

        public HandObservations(int capacity = 16) => _hands = new HandObservation[capacity];

        public int FrameIndex { get; private set; }

        /// <summary>Mid-exposure of the depth picture, microseconds on camera 1's clock.</summary>
        public long TimeUs { get; private set; }

        public ReadOnlySpan<HandObservation> Hands => new ReadOnlySpan<HandObservation>(_hands, 0, _count);

        public void Begin(int frameIndex, long timeUs)
        {
            FrameIndex = frameIndex;
            TimeUs = timeUs;
            _count = 0;
        }

        /// <summary>False when there is no room left.</summary>
        public bool Add(in HandObservation hand)
        {
            if (_count == _hands.Length)
                return false;
            _hands[_count++] = hand;
            return true;
        }
    }
}
