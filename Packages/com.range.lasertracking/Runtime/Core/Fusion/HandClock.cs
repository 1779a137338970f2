using System;
using LaserTracking.Geometry;
using LaserTracking.Hands;

namespace LaserTracking.Fusion
{
    /// <summary>
    /// How far camera 1's clock is off camera 0's: of all offsets the one at which the lines of sight of those who fired met their
    /// dots best. Only dots that move are asked: a hand that holds still before its shot and swings on after it would seem late. Older
    /// shots count less and less, so that a drift is followed. Bounded, without allocation, deterministic.
    /// </summary>
    internal sealed class HandClock
    {
        private struct Waiting
        {
            public int PersonId;
            public int TrackId;
            public long TimeUs;
            public Vector3D DotM;
        }

        private const long ReachUs = 200_000;
        private const long StepUs = 10_000;
        private const int Steps = (int)(2 * ReachUs / StepUs) + 1;

        /// <summary>Shots wait until camera 1 has been seen that long after them.</summary>
        private const long RipeUs = ReachUs + 40_000;
        private const int MaxWaiting = 16;
        private const int MaxSightings = 48;

        /// <summary>Sightings farther apart are not interpolated between.</summary>
        private const long GapUs = 120_000;

        /// <summary>Error of a line of sight, radians, and beyond how many of it a sighting says no more.</summary>
        private const double SightRad = 0.012;
        private const double MaxErrors = 4;

        /// <summary>Share of what older shots said that is left after another one: a hundred parts in a million make 6 ms in the minute that forty take.</summary>
        private const double Keep = 0.985;

        /// <summary>Logarithm of how much likelier the best offset must be than those half this far on either side.</summary>
        private const double NeededEvidence = 8;
        private const int EvidenceSteps = 5;

        /// <summary>Smaller than this an offset is left alone: hands hold still longer.</summary>
        private const long MinOffsetUs = 8_000;

        private readonly Waiting[] _waiting = new Waiting[MaxWaiting];
        private readonly double[] _fit = new double[Steps];
        private readonly HandObservation[] _hands = new HandObservation[MaxSightings];
        private readonly long[] _timesUs = new long[MaxSightings];
        private readonly Vector3D[] _errors = new Vector3D[MaxSightings];
        private readonly HandCamera _camera;
        private int _count;

        public HandClock(HandCamera camera) => _camera = camera;

        /// <summary>Camera 1's clock minus camera 0's as known so far, microseconds; positive: its pictures are stamped late.</summary>
        public long OffsetUs { get; private set; }

        /// <summary>Standard deviation of that, microseconds; 0 while nothing has told.</summary>
        public long SigmaUs { get; private set; }

        public void Clear()
        {
            _count = 0;
            OffsetUs = SigmaUs = 0;
            Array.Clear(_fit, 0, Steps);
        }

        /// <summary>Notes a shot that most likely is this person's with this hand.</summary>
        public void Note(int personId, int trackId, long timeUs, Vector3D dotM)
        {
            if (_count < MaxWaiting)
                _waiting[_count++] = new Waiting { PersonId = personId, TrackId = trackId, TimeUs = timeUs, DotM = dotM };
        }

        /// <summary>Weighs what has waited long enough; at most one shot a call.</summary>
        /// <param name="nowUs">Time of camera 1's last picture, corrected.</param>
        /// <param name="history">Corrected times.</param>
        /// <param name="sights">Where everybody aims over.</param>
        public void Update(long nowUs, HandHistory history, SightLines sights)
        {
            if (_count == 0 || nowUs - _waiting[0].TimeUs < RipeUs)
                return;
            Waiting shot = _waiting[0];
            Array.Copy(_waiting, 1, _waiting, 0, --_count);
            int seen = history.CopyTrack(shot.TrackId, shot.TimeUs - RipeUs, shot.TimeUs + RipeUs, _hands, _timesUs);
            for (int i = 0; i < seen; i++)
            {
                Vector3D muzzle = _camera.ToScreenM(_hands[i].MuzzleMm);
                if (!sights.TrySight(shot.PersonId, muzzle, 0, out Vector3D sight, out _))
                    return;
                _errors[i] = (shot.DotM - muzzle).Normalized - sight.Normalized;
            }

            if (seen < 3)
                return;
            Weigh(shot.TimeUs, seen);
            Decide();
        }

        private void Weigh(long shotUs, int seen)
        {
            int at = 0;
            for (int step = 0; step < Steps; step++)
            {
                long time = shotUs - ReachUs + step * StepUs;
                while (at + 2 < seen && _timesUs[at + 1] < time)
                    at++;
                long gap = _timesUs[at + 1] - _timesUs[at];
                double cost = MaxErrors * MaxErrors;
                if (gap > 0 && gap <= GapUs && time >= _timesUs[at] && time <= _timesUs[at + 1])
                {
                    double part = (time - _timesUs[at]) / (double)gap;
                    Vector3D error = _errors[at] + (_errors[at + 1] - _errors[at]) * part;
                    cost = Math.Min(cost, error.LengthSquared / (SightRad * SightRad));
                }

                _fit[step] = _fit[step] * Keep - 0.5 * cost;
            }
        }

        private void Decide()
        {
            int best = 0;
            for (int step = 1; step < Steps; step++)
            {
                if (_fit[step] > _fit[best])
                    best = step;
            }

            if (best < EvidenceSteps || best >= Steps - EvidenceSteps
                || _fit[best] - Math.Max(_fit[best - EvidenceSteps], _fit[best + EvidenceSteps]) < NeededEvidence)
                return;
            // A parabola through the best and those beside it, wide enough that the steps' noise does not matter.
            const int wide = 3;
            double left = _fit[best - wide], right = _fit[best + wide], curve = 2 * _fit[best] - left - right;
            double peak = best + wide * 0.5 * (right - left) / curve;
            var residual = (long)Math.Round((peak - (Steps - 1) / 2.0) * StepUs);
            SigmaUs = (long)Math.Round(wide * StepUs / Math.Sqrt(curve));
            if (Math.Abs(residual) < Math.Max(MinOffsetUs, 2 * SigmaUs))
                return;
            OffsetUs += residual;
            Array.Clear(_fit, 0, Steps);
            _count = 0;
        }
    }
}
