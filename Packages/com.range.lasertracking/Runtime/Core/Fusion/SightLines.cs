using System;
using System.Runtime.CompilerServices;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands;

namespace LaserTracking.Fusion
{
    /// <summary>
    /// The point over which each person aims. All lines of fire of somebody who stands pass near it, so it starts at the eyes as
    /// seen and is refined by every shot that surely is theirs: least squares over the lines, in information form (a line fixes a
    /// point across itself only). Absorbs what is constant: how the head is seen, how the weapon is held, its boresight.
    /// Bounded, without allocation, deterministic.
    /// </summary>
    internal sealed class SightLines
    {
        private struct Entry
        {
            public int PersonId;
            public long SeenUs;
            public Vector3D EyeM;

            /// <summary>Where the eyes were when shots were learned from; the farther off now, the less those count.</summary>
            public Vector3D LearnedAtM;

            /// <summary>1 / σ² of that along each axis of screen space.</summary>
            public Vector3D Prior;
            public double ReachM;
            public double ReachVariance;

            /// <summary>Of shots that are weighed no more, and of those that still are.</summary>
            public SightEvidence Old;
            public SightEvidence Recent;

            /// <summary>Of all that, while nothing of it has changed.</summary>
            public SightPivot Pivot;
            public bool HasPivot;

            /// <summary>Shots of each colour.</summary>
            public ColorTally Colors;
        }

        private const int Capacity = 32;

        /// <summary>Weight of older shots at each new one: posture changes over some twenty.</summary>
        private const double Keep = 0.95;

        /// <summary>Least weight of another shot for an arm's reach: posture changes.</summary>
        private const double MinReachGain = 0.1;

        /// <summary>Who moved that far has half forgotten how they stood.</summary>
        private const double MovedM = 0.2;

        private readonly FusionSettings _settings;
        private readonly Entry[] _entries = new Entry[Capacity];
        private int _count;

        public SightLines(FusionSettings settings) => _settings = settings;

        public int Count => _count;

        public void Clear() => _count = 0;

        public int PersonAt(int index) => _entries[index].PersonId;

        public long SeenUsAt(int index) => _entries[index].SeenUs;

        /// <summary>Notes where somebody's eyes are; who was seen longest ago gives way.</summary>
        public void See(in PersonObservation person, HandCamera camera, long timeUs)
        {
            int at = IndexOf(person.PersonId);
            if (at < 0)
            {
                at = _count < Capacity ? _count++ : Oldest();
                _entries[at] = new Entry { PersonId = person.PersonId, ReachM = _settings.ReachM, ReachVariance = _settings.ReachSigmaM * _settings.ReachSigmaM };
            }

            _entries[at].SeenUs = timeUs;
            _entries[at].EyeM = camera.ToScreenM(person.EyeMm) + new Vector3D(0, _settings.SightHeightM, 0);
            _entries[at].HasPivot = false;
            double beside = person.SigmaMm * Axes.MetresPerMillimetre, height = person.HeightSigmaMm > 0 ? person.HeightSigmaMm * Axes.MetresPerMillimetre : beside;
            _entries[at].Prior = new Vector3D(1 / (beside * beside), 1 / (height * height), 1 / (beside * beside));
        }

        public bool TryEyes(int personId, out Vector3D eyesM)
        {
            int at = IndexOf(personId);
            eyesM = at < 0 ? default : _entries[at].EyeM;
            return at >= 0;
        }

        /// <summary>Where the person's sight line starts, and its standard deviation across a direction; false for an unknown person.</summary>
        public bool TryPivot(int personId, Vector3D towards, out Vector3D pivotM, out double sigmaM, out double reachM)
        {
            pivotM = default;
            sigmaM = reachM = 0;
            int at = IndexOf(personId);
            if (at < 0)
                return false;
            ref readonly SightPivot pivot = ref Pivot(at);
            pivotM = pivot.PlaceM;
            sigmaM = Math.Sqrt(0.5 * pivot.VarianceAcross(towards.Normalized));
            reachM = _entries[at].ReachM;
            return true;
        }

        private ref readonly SightPivot Pivot(int at)
        {
            ref Entry e = ref _entries[at];
            if (!e.HasPivot)
            {
                SightEvidence known = e.Recent;
                known.Add(e.Old, StillShare(e));
                e.Pivot = SightPivot.Of(known, e.EyeM, e.Prior);
                e.HasPivot = true;
            }

            return ref e.Pivot;
        }

        /// <summary>
        /// How far beside the line of sight over a muzzle a direction is, as an angle and a standard deviation that give the density of the
        /// true error, which is wider sideways and where no shot has shown the line yet. The other variance (about one axis, square radians) is added. False for an unknown person.
        /// </summary>
        public bool TryMatch(int personId, Vector3D muzzleM, double muzzleSigmaM, Vector3D direction, double otherVariance, out double errorRad, out double sigmaRad)
        {
            errorRad = sigmaRad = 0;
            int at = IndexOf(personId);
            if (at < 0)
                return false;
            ref readonly Entry e = ref _entries[at];
            ref readonly SightPivot pivot = ref Pivot(at);
            Vector3D sight = muzzleM - pivot.PlaceM;
            double reach = Math.Max(0.1, sight.Length), even = SpreadScale(e) * Expected(muzzleSigmaM, reach) + otherVariance;
            Vector3D s = sight.Normalized, turn = Vector3D.Cross(s, direction);
            double perSquare = 1 / (reach * reach);
            double determinant = pivot.DeterminantAcross(s) * perSquare * perSquare + even * (pivot.VarianceAcross(s) * perSquare + even);
            double variance = Math.Sqrt(determinant), size = turn.Length;
            sigmaRad = Math.Sqrt(variance);
            if (!(size > 0))
                return true;
            // At right angles to the error: of a narrow ellipse the long axis lets an error across it count more.
            double besideError = pivot.VarianceAlong(turn * (1 / size)) * perSquare + even;
            errorRad = Math.Atan2(size, Vector3D.Dot(s, direction)) * Math.Sqrt(besideError / variance);
            return true;
        }

        /// <summary>
        /// Standard deviation of the line of sight over a muzzle, radians: the pivot's error, and the muzzle's and the aim's, these as this
        /// person's shots have shown them to be. False for an unknown person.
        /// </summary>
        public bool TrySight(int personId, Vector3D muzzleM, double muzzleSigmaM, out Vector3D sight, out double sigmaRad)
        {
            sight = default;
            sigmaRad = 0;
            int at = IndexOf(personId);
            if (at < 0 || !TryPivot(personId, muzzleM - _entries[at].EyeM, out Vector3D pivot, out double pivotSigma, out _))
                return false;
            sight = muzzleM - pivot;
            double reach = Math.Max(0.1, sight.Length);
            sigmaRad = Math.Sqrt(pivotSigma * pivotSigma / (reach * reach) + SpreadScale(_entries[at]) * Expected(muzzleSigmaM, reach));
            return true;
        }

        /// <summary>What a shot tells that with this probability is this person's, seen against all that is known of them so far.</summary>
        public SightEvidence Weigh(int personId, Vector3D muzzleM, double muzzleSigmaM, Vector3D directionM, double probability)
        {
            int at = IndexOf(personId);
            if (at < 0 || !TryPivot(personId, directionM, out Vector3D pivot, out double pivotSigma, out _))
                return default;
            ref readonly Entry e = ref _entries[at];
            double reach = Math.Max(0.1, (muzzleM - pivot).Length), expected = Expected(muzzleSigmaM, reach);
            double error = ShotHandPairing.AngleRad(muzzleM - pivot, directionM), total = expected + pivotSigma * pivotSigma / (reach * reach);
            SightEvidence evidence = SightEvidence.OfLine(muzzleM, directionM.Normalized, probability / (SpreadScale(e) * expected * reach * reach));

            // An error in two directions has twice the variance; one that the pivot may explain says the less about the rest.
            evidence.SpreadCount = probability * expected / total;
            evidence.SpreadSum = evidence.SpreadCount * error * error / (2 * total);
            return evidence;
        }

        /// <summary>Adds what a shot tells, or with a share of -1 takes it back.</summary>
        public void Add(int personId, in SightEvidence evidence, double share)
        {
            int at = IndexOf(personId);
            if (at < 0)
                return;
            _entries[at].Recent.Add(evidence, share);
            _entries[at].HasPivot = false;
        }

        /// <summary>Adds what a shot tells that will not be weighed again; older ones fade.</summary>
        public void Settle(int personId, in SightEvidence evidence, double probability)
        {
            int at = IndexOf(personId);
            if (at < 0)
                return;
            ref Entry e = ref _entries[at];
            e.LearnedAtM = e.Old.Diagonal.LengthSquared > 0 ? e.LearnedAtM + (e.EyeM - e.LearnedAtM) * (0.3 * probability) : e.EyeM;
            e.Old.Scale((1 - (1 - Keep) * probability) * (1 - (1 - StillShare(e)) * probability));
            e.Old.Add(evidence, 1);
            e.HasPivot = false;
        }

        /// <summary>What lines fired long ago told, that are weighed no more.</summary>
        public SightEvidence Old(int personId)
        {
            int at = IndexOf(personId);
            return at < 0 ? default : _entries[at].Old;
        }

        /// <summary>Puts that back, or with nothing believes it no more.</summary>
        public void SetOld(int personId, in SightEvidence old)
        {
            int at = IndexOf(personId);
            if (at < 0)
                return;
            _entries[at].Old = old;
            _entries[at].HasPivot = false;
        }

        /// <summary>Notes how far from the point they aim over a muzzle was that fired.</summary>
        public void NoteReach(int personId, Vector3D muzzleM, double probability)
        {
            int at = IndexOf(personId);
            if (at < 0)
                return;
            ref Entry e = ref _entries[at];
            double spread = _settings.ReachSpreadM * _settings.ReachSpreadM;
            double gain = probability * Math.Max(MinReachGain, e.ReachVariance / (e.ReachVariance + spread));
            e.ReachM += gain * ((muzzleM - Pivot(at).PlaceM).Length - e.ReachM);
            e.ReachVariance = Math.Max(e.ReachVariance * (1 - gain), MinReachGain * spread);
        }

        /// <summary>The point this person aims over, how far from it their muzzle is when they do, and the standard deviation of that; false for an unknown person.</summary>
        public bool TryReach(int personId, out Vector3D pivotM, out double reachM, out double sigmaM)
        {
            int at = IndexOf(personId);
            pivotM = default;
            reachM = sigmaM = 0;
            if (at < 0)
                return false;
            ref readonly Entry e = ref _entries[at];
            pivotM = Pivot(at).PlaceM;
            reachM = e.ReachM;
            sigmaM = Math.Sqrt(e.ReachVariance + _settings.ReachSpreadM * _settings.ReachSpreadM);
            return true;
        }

        /// <summary>Notes a shot's colour, as a part of a shot.</summary>
        public void CountColor(int personId, LaserColor color, double probability)
        {
            int at = IndexOf(personId);
            if (at >= 0)
                _entries[at].Colors.Count(color, probability);
        }

        public double ColorFactor(int personId, LaserColor color)
        {
            int at = IndexOf(personId);
            return at < 0 ? 1 : _entries[at].Colors.Factor(color, _settings.ColorKeptProbability);
        }

        /// <summary>Variance of the line of sight from the muzzle and the aim, square radians, before anything is known of the person.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private double Expected(double muzzleSigmaM, double reachM) =>
            muzzleSigmaM * muzzleSigmaM / (reachM * reachM) + _settings.SightSpreadRad * _settings.SightSpreadRad;

        /// <summary>Factor on that variance: the mean of what was seen and of the expectation, which counts for a few shots.</summary>
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private double SpreadScale(in Entry e) => Math.Max(_settings.MinSpreadScale * _settings.MinSpreadScale,
            (_settings.SpreadShots + e.Old.SpreadSum + e.Recent.SpreadSum) / (_settings.SpreadShots + e.Old.SpreadCount + e.Recent.SpreadCount));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private static double StillShare(in Entry e) => 1 / (1 + (e.EyeM - e.LearnedAtM).LengthSquared / (MovedM * MovedM));

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        private int IndexOf(int personId)
        {
            for (int i = 0; i < _count; i++)
            {
                if (_entries[i].PersonId == personId)
                    return i;
            }

            return -1;
        }

        private int Oldest()
        {
            int oldest = 0;
            for (int i = 1; i < _count; i++)
            {
                if (_entries[i].SeenUs < _entries[oldest].SeenUs)
                    oldest = i;
            }

            return oldest;
        }
    }
}
