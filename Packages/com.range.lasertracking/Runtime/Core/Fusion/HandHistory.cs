using System;
using LaserTracking.Geometry;
using LaserTracking.Hands;

namespace LaserTracking.Fusion
{
    /// <summary>
    /// The last sightings of every hand, to be asked where a hand was when a photon left. Fixed room, in order of time: the oldest
    /// are overwritten. One thread at a time.
    /// </summary>
    public sealed class HandHistory
    {
        /// <summary>Tracks told apart within one window; of more, those seen last.</summary>
        private const int MaxTracks = 64;

        /// <summary>A velocity is taken over at most this: three frames at 30 a second, within which a swing hardly turns.</summary>
        private const long VelocityUs = 110_000;

        private struct Found
        {
            public int TrackId;

            /// <summary>Logical places; -1: none. The last sighting at or before the moment, the first at or after it, the earliest one for a velocity.</summary>
            public int Before;
            public int After;
            public int Earliest;
        }

        private readonly HandObservation[] _hands;
        private readonly long[] _timesUs;
        private readonly Found[] _found = new Found[MaxTracks];
        private int _count;
        private int _start;

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
        public void Add(HandObservations hands) => Add(hands, hands.TimeUs);

        /// <param name="hands">One frame's hands, any order of frames.</param>
        /// <param name="timeUs">When they were seen, in place of the time that they carry.</param>
        public void Add(HandObservations hands, long timeUs)
        {
            foreach (ref readonly HandObservation hand in hands.Hands)
                Insert(hand, timeUs);
        }

        public void Clear() => _count = _start = 0;

        /// <summary>Moves all sightings in time, microseconds: the clock that stamped them is known better.</summary>
        public void Shift(long byUs)
        {
            for (int i = 0; i < _timesUs.Length; i++)
                _timesUs[i] += byUs;
        }

        /// <summary>
        /// Each hand seen within the window of the moment, in order of track id, at that moment: interpolated between the sightings
        /// around it where they are at most maxInterpolationUs apart, else the nearest one. When there are more hands than room,
        /// those with the lowest ids are given.
        /// </summary>
        /// <returns>How many were written.</returns>
        public int At(long timeUs, long windowUs, long maxInterpolationUs, Span<PairedHand> hands)
        {
            int tracks = Gather(timeUs, windowUs);
            int given = Math.Min(tracks, hands.Length);
            for (int i = 0; i < given; i++)
                hands[i] = Pair(timeUs, maxInterpolationUs, _found[i]);
            return given;
        }

        /// <summary>One hand's sightings of a stretch of time, in order; the latest where there is no room for all.</summary>
        /// <returns>How many were written.</returns>
        public int CopyTrack(int trackId, long fromUs, long toUs, Span<HandObservation> hands, Span<long> timesUs)
        {
            int room = Math.Min(hands.Length, timesUs.Length), copied = 0;
            for (int i = _count - 1; i >= 0 && copied < room; i--)
            {
                int place = Place(i);
                if (_timesUs[place] < fromUs)
                    break;
                if (_timesUs[place] > toUs || _hands[place].TrackId != trackId)
                    continue;
                hands[copied] = _hands[place];
                timesUs[copied++] = _timesUs[place];
            }

            hands.Slice(0, copied).Reverse();
            timesUs.Slice(0, copied).Reverse();
            return copied;
        }

        /// <summary>
        /// The mean place of a muzzle over the sightings up to a moment, back as far as it held still: of what a sighting errs the greater part is
        /// different in each. Camera space.
        /// </summary>
        /// <param name="trackId">Whose.</param>
        /// <param name="fromUs">Earliest sighting that counts.</param>
        /// <param name="toUs">Latest one.</param>
        /// <param name="stillMm">A sighting farther than that from the mean of those after it was of a moving weapon.</param>
        /// <param name="muzzleMm">The mean; zero when there is none.</param>
        /// <returns>Of how many.</returns>
        public int Steady(int trackId, long fromUs, long toUs, double stillMm, out Vector3D muzzleMm)
        {
            int count = 0;
            double sigma = 0;
            muzzleMm = default;
            for (int i = _count - 1; i >= 0; i--)
            {
                int place = Place(i);
                if (_timesUs[place] < fromUs)
                    break;
                ref readonly HandObservation hand = ref _hands[place];
                if (_timesUs[place] > toUs || hand.TrackId != trackId)
                    continue;
                if (count == 0)
                    sigma = hand.MuzzleSigmaMm;
                else if (hand.MuzzleSigmaMm > sigma || (hand.MuzzleMm - muzzleMm).LengthSquared > stillMm * stillMm)
                    break;
                count++;
                muzzleMm += (hand.MuzzleMm - muzzleMm) * (1.0 / count);
            }

            return count;
        }

        private int Place(int logical)
        {
            int at = _start + logical;
            return at < _hands.Length ? at : at - _hands.Length;
        }

        private void Insert(in HandObservation hand, long timeUs)
        {
            if (_count == _hands.Length)
            {
                // Older than all that is kept: nothing to forget for it.
                if (timeUs < _timesUs[_start])
                    return;
                _start = Place(1);
                _count--;
            }

            int at = _count++;
            for (; at > 0 && _timesUs[Place(at - 1)] > timeUs; at--)
            {
                _hands[Place(at)] = _hands[Place(at - 1)];
                _timesUs[Place(at)] = _timesUs[Place(at - 1)];
            }

            _hands[Place(at)] = hand;
            _timesUs[Place(at)] = timeUs;
        }

        /// <summary>From the newest back to the window's beginning; the tracks come in order of their ids.</summary>
        private int Gather(long timeUs, long windowUs)
        {
            int tracks = 0;
            for (int i = _count - 1; i >= 0; i--)
            {
                int place = Place(i);
                long time = _timesUs[place];
                if (time - timeUs > windowUs)
                    continue;
                if (timeUs - time > windowUs)
                    break;
                int track = Slot(_hands[place].TrackId, ref tracks);
                if (track < 0)
                    continue;
                ref Found found = ref _found[track];
                if (time >= timeUs)
                    found.After = i;
                if (time > timeUs)
                    continue;
                if (found.Before < 0)
                    found.Before = found.Earliest = i;
                else if (_timesUs[Place(found.Before)] - time <= VelocityUs)
                    found.Earliest = i;
            }

            return tracks;
        }

        private int Slot(int trackId, ref int tracks)
        {
            int at = tracks;
            while (at > 0 && _found[at - 1].TrackId >= trackId)
                at--;
            if (at < tracks && _found[at].TrackId == trackId)
                return at;
            if (tracks == MaxTracks)
                return -1;
            Array.Copy(_found, at, _found, at + 1, tracks - at);
            _found[at] = new Found { TrackId = trackId, Before = -1, After = -1, Earliest = -1 };
            tracks++;
            return at;
        }

        private PairedHand Pair(long timeUs, long maxInterpolationUs, in Found found)
        {
            long beforeUs = found.Before < 0 ? 0 : _timesUs[Place(found.Before)], afterUs = found.After < 0 ? 0 : _timesUs[Place(found.After)];
            bool takesAfter = found.Before < 0 || (found.After >= 0 && timeUs - beforeUs > afterUs - timeUs);
            var pair = new PairedHand { Hand = _hands[Place(takesAfter ? found.After : found.Before)], DeltaUs = (takesAfter ? afterUs : beforeUs) - timeUs };
            AddVelocity(found, ref pair);
            if (found.Before < 0 || found.After < 0)
                return pair;
            long gap = afterUs - beforeUs;
            if (gap == 0 || gap > maxInterpolationUs)
                return pair;
            double f = (timeUs - beforeUs) / (double)gap;
            ref readonly HandObservation a = ref _hands[Place(found.Before)];
            ref readonly HandObservation b = ref _hands[Place(found.After)];
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

        /// <summary>Over all sightings from the earliest on, those around the moment included.</summary>
        private void AddVelocity(in Found found, ref PairedHand pair)
        {
            int first = found.Earliest >= 0 ? Place(found.Earliest) : -1, last = found.Before >= 0 ? Place(found.Before) : -1;
            if (found.After >= 0 && first >= 0 && _timesUs[Place(found.After)] - _timesUs[first] <= 2 * VelocityUs)
                last = Place(found.After);
            if (first < 0 || last < 0 || _timesUs[last] <= _timesUs[first])
                return;
            double seconds = (_timesUs[last] - _timesUs[first]) * 1e-6;
            pair.MuzzleVelocityMmS = (_hands[last].MuzzleMm - _hands[first].MuzzleMm) * (1 / seconds);
            pair.VelocitySeconds = seconds;
        }

        private static Vector3D Between(Vector3D a, Vector3D b, double f) => a + (b - a) * f;
    }
}
