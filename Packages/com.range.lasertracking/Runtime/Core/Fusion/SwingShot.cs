using System;
using LaserTracking.Geometry;
using LaserTracking.Hands;

namespace LaserTracking.Fusion
{
    /// <summary>
    /// A shot from a swing, and where camera 1 saw everybody's muzzle for a while around it: at which moment of camera 1's clock somebody's line of
    /// sight met the dot. Kept as it was seen, to be weighed again when the lines are known better. Fixed room; an older shot gives way.
    /// </summary>
    internal sealed class SwingShot
    {
        private struct Sighting
        {
            public int TrackId;
            public int PersonId;
            public Vector3D MuzzleM;
            public double MuzzleSigmaM;

            /// <summary>As camera 1 stamped it, minus the time of the shot.</summary>
            public long AfterUs;
        }

        private const int MaxSightings = 512;

        /// <summary>Of one hand: a second and a half at 60 frames/s.</summary>
        private const int SightingsEach = 96;
        private const int MaxTracks = 16;

        /// <summary>Sightings farther apart are not interpolated between.</summary>
        private const long GapUs = 120_000;

        /// <summary>Share of shots that none of the lines seen explains, spread over the half space.</summary>
        private const double UnseenShare = 0.3;

        /// <summary>Share of sightings that are far worse than they say, with three times the standard deviation.</summary>
        private const double PoorShare = 0.05;

        /// <summary>Half the squared error in standard deviations beyond which nothing is left of such a sighting either.</summary>
        private const double MaxSquares = 9 * 40;

        private readonly Sighting[] _sightings = new Sighting[MaxSightings];
        private Vector3D _dotM;
        private double _timeSigmaUs;
        private int _count;
        private int _tracks;

        /// <param name="timeUs">When it was fired, on camera 0's clock.</param>
        /// <param name="timeSigmaUs">Standard deviation of that.</param>
        /// <param name="dotM">Where, screen space.</param>
        /// <param name="reachUs">Sightings so long before and after it are taken.</param>
        /// <param name="history">All sightings, by corrected times.</param>
        /// <param name="offsetUs">What those were corrected by.</param>
        /// <param name="camera">Camera 1.</param>
        public void Take(long timeUs, long timeSigmaUs, Vector3D dotM, long reachUs, HandHistory history, long offsetUs, HandCamera camera)
        {
            Span<PairedHand> near = stackalloc PairedHand[MaxTracks];
            Span<HandObservation> hands = stackalloc HandObservation[SightingsEach];
            Span<long> timesUs = stackalloc long[SightingsEach];
            _dotM = dotM;
            _timeSigmaUs = timeSigmaUs;
            _count = 0;
            _tracks = history.At(timeUs, reachUs, 0, near);
            for (int i = 0; i < _tracks; i++)
            {
                int seen = history.CopyTrack(near[i].Hand.TrackId, timeUs - reachUs, timeUs + reachUs, hands, timesUs);
                for (int k = 0; k < seen && _count < MaxSightings; k++)
                {
                    _sightings[_count++] = new Sighting
                    {
                        TrackId = hands[k].TrackId,
                        PersonId = hands[k].PersonId,
                        MuzzleM = camera.ToScreenM(hands[k].MuzzleMm),
                        MuzzleSigmaM = hands[k].MuzzleSigmaMm * Axes.MetresPerMillimetre,
                        AfterUs = timesUs[k] + offsetUs - timeUs,
                    };
                }
            }
        }

        /// <summary>
        /// Logarithm of the likelihood of evenly spaced offsets of camera 1's clock: of the dot's direction seen from the muzzles, per steradian, whoever
        /// fired.
        /// </summary>
        public void Weigh(SightLines sights, long firstUs, long stepUs, Span<double> logLikelihood)
        {
            logLikelihood.Fill(UnseenShare / (2 * Math.PI));
            for (int begin = 0, end; begin < _count; begin = end)
            {
                for (end = begin + 1; end < _count && _sightings[end].TrackId == _sightings[begin].TrackId;)
                    end++;
                AddHand(sights, begin, end, firstUs, stepUs, logLikelihood);
            }

            for (int i = 0; i < logLikelihood.Length; i++)
                logLikelihood[i] = Math.Log(logLikelihood[i]);
        }

        private void AddHand(SightLines sights, int begin, int end, long firstUs, long stepUs, Span<double> likelihood)
        {
            Span<Vector3D> errors = stackalloc Vector3D[SightingsEach];
            Span<double> variances = stackalloc double[SightingsEach];
            Span<long> times = stackalloc long[SightingsEach];
            int seen = 0;
            for (int i = begin; i < end; i++)
            {
                ref readonly Sighting s = ref _sightings[i];
                if (!sights.TrySight(s.PersonId, s.MuzzleM, s.MuzzleSigmaM, out Vector3D sight, out double sigma))
                    continue;
                errors[seen] = (_dotM - s.MuzzleM).Normalized - sight.Normalized;
                variances[seen] = sigma * sigma;
                times[seen++] = s.AfterUs;
            }

            double share = (1 - UnseenShare) / _tracks;
            int at = 0;
            for (int step = 0; step < likelihood.Length && seen > 1; step++)
            {
                long time = firstUs + step * stepUs;
                while (at + 2 < seen && times[at + 1] < time)
                    at++;
                long gap = times[at + 1] - times[at];
                if (gap <= 0 || gap > GapUs || time < times[at] || time > times[at + 1])
                    continue;
                double part = (time - times[at]) / (double)gap, late = _timeSigmaUs / gap;
                Vector3D change = errors[at + 1] - errors[at], error = errors[at] + change * part;
                // The moment of the shot is not known to the end either: while the weapon swings that is an angle, along one axis of two.
                double variance = variances[at] + (variances[at + 1] - variances[at]) * part + 0.5 * change.LengthSquared * late * late;
                double squares = error.LengthSquared / (2 * variance);
                if (squares > MaxSquares)
                    continue;

                // The ninth power of the poor one's exponential is the good one's.
                double poor = Math.Exp(-squares / 9), cube = poor * poor * poor;
                likelihood[step] += share / (2 * Math.PI * variance) * ((1 - PoorShare) * (cube * cube * cube) + PoorShare / 9 * poor);
            }
        }
    }
}
