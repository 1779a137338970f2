using System;
using LaserTracking.Hands;

namespace LaserTracking.Fusion
{
    /// <summary>The last depth pictures of camera 1, to be asked for the one at a shot. As stamped: what is known of the clock may change. Fixed room.</summary>
    internal sealed class SeenDepths
    {
        /// <summary>0.13 s at 30 frames/s: shots are reported that late at most.</summary>
        private const int Capacity = 4;

        private readonly SeenDepth[] _depths = new SeenDepth[Capacity];
        private readonly long[] _timesUs = new long[Capacity];
        private int _next;

        public SeenDepths()
        {
            for (int i = 0; i < Capacity; i++)
                _depths[i] = new SeenDepth();
        }

        public void Clear()
        {
            foreach (SeenDepth depth in _depths)
                depth.Clear();
        }

        public void Add(HandObservations hands)
        {
            if (!hands.Depth.IsPresent)
                return;
            _depths[_next].CopyFrom(hands.Depth);
            _timesUs[_next] = hands.TimeUs;
            _next = (_next + 1) % Capacity;
        }

        /// <summary>The picture nearest to a moment of camera 1's clock, or null when none is that near.</summary>
        public SeenDepth? At(long timeUs, long withinUs)
        {
            SeenDepth? nearest = null;
            for (int i = 0; i < Capacity; i++)
            {
                long off = Math.Abs(_timesUs[i] - timeUs);
                if (!_depths[i].IsPresent || off > withinUs)
                    continue;
                withinUs = off;
                nearest = _depths[i];
            }

            return nearest;
        }
    }
}
