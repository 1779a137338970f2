using System;
using LaserTracking.Geometry;
using LaserTracking.Hands;

namespace LaserTracking.Fusion
{
    /// <summary>
    /// The last sightings of every hand, to be asked where a hand was when a photon left. Fixed room: the oldest are overwritten.
    /// One thread at a time.
    /// </summary>
    public sealed class HandHistory
    {
        private readonly HandObservation[] _hands;
        private readonly long[] _timesUs;
        private int _count;
        private int _next;

        /// <param name="capacity">Sightings kept, over all hands.</param>
        public HandHistory(int capacity = 1024)
        {
            if (capacity < 1)
                throw new ArgumentOutOfRangeException(nameof(capacity));
            _hands = new HandObservation[capacity];
            _timesUs = new long[capacity];
        }

        public int Count => _count;

        /// <param name="hands">One frame's hands, any order of frames.</param>
        public void Add(HandObservations hands)
        {
            foreach (ref readonly HandObservation hand in hands.Hands)
            {
                _hands[_next] = hand;
                _timesUs[_next] = hands.TimeUs;
                _next = (_next + 1) % _hands.Length;
                _count = Math.Min(_count + 1, _hands.Length);
            }
        }

        public void Clear() => _count = _next = 0;

        /// <summary>
        /// Each hand seen within the window of the moment, in order of track id, at that moment: interpolated between the sightings
        /// around it where they are at most maxInterpolationUs apart, else the nearest one. When there are more hands than room,
        /// those with the lowest ids are given.
        /// </summary>
        /// <returns>How many were written.</returns>
        public int At(long timeUs, long windowUs, long maxInterpolationUs, Span<PairedHand> hands)
        {
            int found = 0, lastId = int.MinValue;
            while (found < hands.Length && TryNextId(timeUs, windowUs, lastId, out int id))
            {
                hands[found++] = Pair(timeUs, windowUs, maxInterpolationUs, id);
                lastId = id;
            }

            return found;
        }

        private bool TryNextId(long timeUs, long windowUs, int after, out int id)
        {
            id = int.MaxValue;
            bool any = false;
            for (int i = 0; i < _count; i++)
            {
                int candidate = _hands[i].TrackId;
                if (candidate <= after || (any && candidate >= id) || Math.Abs(_timesUs[i] - timeUs) > windowUs)
                    continue;
                id = candidate;
                any = true;
            }

            return any;
        }

        private PairedHand Pair(long timeUs, long windowUs, long maxInterpolationUs, int id)
        {
            int before = -1, after = -1;
            for (int i = 0; i < _count; i++)
            {
                long delta = _timesUs[i] - timeUs;
                if (_hands[i].TrackId != id || Math.Abs(delta) > windowUs)
                    continue;
                if (delta <= 0 && (before < 0 || _timesUs[i] > _timesUs[before]))
                    before = i;
                if (delta >= 0 && (after < 0 || _timesUs[i] < _timesUs[after]))
                    after = i;
            }

            int nearest = before < 0 ? after : after < 0 ? before
                : timeUs - _timesUs[before] <= _timesUs[after] - timeUs ? before : after;
            var pair = new PairedHand { Hand = _hands[nearest], DeltaUs = _timesUs[nearest] - timeUs };
            if (before < 0 || after < 0)
                return pair;
            long gap = _timesUs[after] - _timesUs[before];
            if (gap == 0 || gap > maxInterpolationUs)
                return pair;
            double f = (timeUs - _timesUs[before]) / (double)gap;
            ref readonly HandObservation a = ref _hands[before];
            ref readonly HandObservation b = ref _hands[after];
            pair.IsInterpolated = true;
            pair.Hand.PalmMm = Between(a.PalmMm, b.PalmMm, f);
            pair.Hand.MuzzleMm = Between(a.MuzzleMm, b.MuzzleMm, f);
            if (a.AimDirection.LengthSquared > 0 && b.AimDirection.LengthSquared > 0)
                pair.Hand.AimDirection = Between(a.AimDirection, b.AimDirection, f).Normalized;
            if (a.SightDirection.LengthSquared > 0 && b.SightDirection.LengthSquared > 0)
                pair.Hand.SightDirection = Between(a.SightDirection, b.SightDirection, f).Normalized;
            pair.Hand.DepthSource = a.DepthSource > b.DepthSource ? a.DepthSource : b.DepthSource;
            // No smaller than the better of the two: their errors are mostly common (shape, bias).
            pair.Hand.SigmaMm = a.SigmaMm + (b.SigmaMm - a.SigmaMm) * f;
            pair.Hand.MuzzleSigmaMm = a.MuzzleSigmaMm + (b.MuzzleSigmaMm - a.MuzzleSigmaMm) * f;
            pair.Hand.AimSigmaRad = a.AimSigmaRad + (b.AimSigmaRad - a.AimSigmaRad) * f;
            return pair;
        }

        private static Vector3D Between(Vector3D a, Vector3D b, double f) => a + (b - a) * f;
    }
}
