using System;
using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>
    /// What <see cref="ShotDetector"/> examined in its last frame: every candidate with every test it was put through, in order. Hang
    /// one on <see cref="ShotDetector.Trace"/> before Process and read it after. Fixed room, no allocation once constructed; without one the
    /// detector records nothing. Same thread as the detector.
    /// </summary>
    public sealed class DetectionTrace
    {
        private readonly ExaminedCandidate[] _candidates;
        private readonly TestOutcome[] _tests;
        private int _candidateCount;
        private int _testCount;
        private int _firstTest;

        /// <param name="candidateCapacity">Candidates kept a frame; what goes beyond is counted, 1…65536.</param>
        /// <exception cref="ArgumentOutOfRangeException">The capacity is outside its range.</exception>
        public DetectionTrace(int candidateCapacity = 512)
        {
            if (candidateCapacity < 1 || candidateCapacity > 65536)
                throw new ArgumentOutOfRangeException(nameof(candidateCapacity), "1…65536 candidates can be kept");
            _candidates = new ExaminedCandidate[candidateCapacity];
            _tests = new TestOutcome[32 * candidateCapacity];
        }

        /// <summary>A place to look at closely in every frame, whatever happens there; null: none.</summary>
        public SpotTrace? Spot { get; set; }

        /// <summary>Index of the frame; -1 before the first one.</summary>
        public int FrameIndex { get; private set; } = -1;

        /// <summary>In the order in which they were examined.</summary>
        public ReadOnlySpan<ExaminedCandidate> Candidates => new ReadOnlySpan<ExaminedCandidate>(_candidates, 0, _candidateCount);

        /// <summary>Candidates that found no room.</summary>
        public int OverflowCount { get; private set; }

        /// <summary>The tests of a candidate, in order. The last failed one with a reason is the verdict: a spot that grows dimmer is said to go out, whatever else it failed.</summary>
        public ReadOnlySpan<TestOutcome> TestsOf(in ExaminedCandidate candidate) =>
            new ReadOnlySpan<TestOutcome>(_tests, candidate.FirstTest, candidate.TestCount);

        /// <summary>Log-odds of a dot before any <see cref="DotFeature"/> is measured.</summary>
        public double BaseLogOdds { get; private set; } = DotEvidence.Learned.Base;

        /// <summary>What each <see cref="DotFeature"/> says about a candidate, in their order; empty where it was not weighed.</summary>
        public ReadOnlySpan<TestOutcome> EvidenceOf(in ExaminedCandidate candidate)
        {
            ReadOnlySpan<TestOutcome> tests = TestsOf(candidate);
            for (int first = 0; first + DotEvidence.Count <= tests.Length; first++)
            {
                if (tests[first].IsEvidence)
                    return tests.Slice(first, DotEvidence.Count);
            }

            return default;
        }

        /// <summary>Whether this reason's limit is the least value that passes; otherwise it is the largest.</summary>
        public static bool IsMinimum(RejectionReason reason)
        {
            switch (reason)
            {
                case RejectionReason.TooSmall:
                case RejectionReason.NotCompact:
                case RejectionReason.TooFaint:
                case RejectionReason.NotNew:
                case RejectionReason.CutByEdge:
                case RejectionReason.WrongColor:
                case RejectionReason.LowConfidence:
                case RejectionReason.Duplicate:
                    return true;
                default:
                    return false;
            }
        }

        internal void Begin(int frameIndex)
        {
            FrameIndex = frameIndex;
            Spot?.Begin();
            _candidateCount = _testCount = _firstTest = OverflowCount = 0;
        }

        /// <summary>A test with a reason. What: null for the reason's usual measure.</summary>
        internal void Add(RejectionReason reason, bool isPassed, double value, double limit, string? what)
        {
            // Passed beyond its limit: the test is not meant for candidates like this one.
            // A curve may speak against too much where its reason usually means too little.
            bool isMinimum = isPassed || value == limit ? IsMinimum(reason) : value < limit;
            if (!isPassed || (isMinimum ? value >= limit : value <= limit))
                Add(new TestOutcome { What = what ?? UsualMeasure(reason), Reason = reason, IsPassed = isPassed, Value = value, Limit = limit, IsMinimum = isMinimum, LogOdds = double.NaN });
        }

        /// <summary>A test that decides only whether this frame suffices.</summary>
        internal void AddConclusive(bool isPassed, double value, double limit, string what, bool isMinimum) =>
            Add(new TestOutcome { What = what, IsPassed = isPassed, Value = value, Limit = limit, IsMinimum = isMinimum, LogOdds = double.NaN });

        /// <summary>What each measure says, what was known before any of them, and all of it together against the least that a candidate needs.</summary>
        internal void AddEvidence(DotEvidence evidence, ReadOnlySpan<float> features, double before, double minLogOdds)
        {
            BaseLogOdds = evidence.Base;
            for (int i = 0; i < features.Length; i++)
            {
                EvidenceCurve curve = evidence.Curves[i];
                Add(new TestOutcome { What = curve.What, Reason = curve.Reason, IsPassed = true, Value = features[i], Limit = double.NaN, LogOdds = curve.At(features[i]) });
            }

            double all = before + evidence.LogOdds(features);
            double known = before + evidence.Base;
            Add(new TestOutcome { What = "before this frame", IsPassed = true, Value = known, Limit = double.NaN, LogOdds = known });
            Add(new TestOutcome { What = "all evidence", IsPassed = all >= minLogOdds, Value = all, Limit = minLogOdds, IsMinimum = true, LogOdds = all });
        }

        /// <summary>The candidate whose tests were added since the last call; its index, -1 when there was no room for it.</summary>
        internal int Finish(in Candidate candidate, in FrameView view, Vector2D positionPx, int factor, bool isContinued, int dotIndex)
        {
            int first = _firstTest;
            _firstTest = _testCount;
            if (_candidateCount == _candidates.Length)
            {
                OverflowCount++;
                return -1;
            }

            double half = (factor - 1) * 0.5;
            bool isGrown = candidate.Area > 0;
            int shiftX = view.ShiftX, shiftY = view.ShiftY;
            var seed = new Vector2D((candidate.SeedX + shiftX) * factor + half, (candidate.SeedY + shiftY) * factor + half);
            _candidates[_candidateCount++] = new ExaminedCandidate
            {
                SeedPx = seed,
                PositionPx = positionPx,
                TopLeftPx = isGrown ? new Vector2D((candidate.Left + shiftX) * factor, (candidate.Top + shiftY) * factor) : seed,
                BottomRightPx = isGrown ? new Vector2D((candidate.Right + shiftX + 1) * factor - 1, (candidate.Bottom + shiftY + 1) * factor - 1) : seed,
                IsSmallestChannel = candidate.Plane == DetectionPlane.Smallest,
                IsAboveContent = candidate.IsAboveContent,
                RiseLevels = candidate.PeakRise,
                Rise = candidate.PeakRelativeRise / 255.0,
                IsContinued = isContinued,
                IsOnset = candidate.IsOnset,
                IsConclusive = candidate.IsConclusive,
                Reason = candidate.Reason,
                Value = candidate.Value,
                Limit = candidate.Limit,
                DotIndex = dotIndex,
                FirstTest = first,
                TestCount = _testCount - first,
            };
            return _candidateCount - 1;
        }

        /// <summary>The same for a candidate that waits for the others of its frame; room is kept for the test that decides then.</summary>
        internal int FinishWaiting(in Candidate candidate, in FrameView view, Vector2D positionPx, int factor)
        {
            Add(RejectionReason.Duplicate, true, 0, 0, null);
            return Finish(candidate, view, positionPx, factor, false, -1);
        }

        /// <summary>A candidate that waited is a dot.</summary>
        internal void SettleWaiting(int index, Vector2D positionPx, int dotIndex)
        {
            if (index < 0)
                return;
            _candidates[index].PositionPx = positionPx;
            _candidates[index].DotIndex = dotIndex;
            if (_candidates[index].TestCount > 0)
                _candidates[index].TestCount--;
        }

        /// <summary>A candidate that waited lies beside a dot that more speaks for, or is one of too many.</summary>
        internal void SettleWaiting(int index, in RejectedCandidate rejected)
        {
            if (index < 0)
                return;
            ref ExaminedCandidate candidate = ref _candidates[index];
            candidate.Reason = rejected.Reason;
            candidate.Value = rejected.Value;
            candidate.Limit = rejected.Limit;
            int last = candidate.FirstTest + candidate.TestCount - 1;
            if (candidate.TestCount == 0 || _tests[last].Reason != RejectionReason.Duplicate)
                return;
            _tests[last].Reason = rejected.Reason;
            _tests[last].What = UsualMeasure(rejected.Reason);
            _tests[last].IsMinimum = IsMinimum(rejected.Reason);
            _tests[last].IsPassed = false;
            _tests[last].Value = rejected.Value;
            _tests[last].Limit = rejected.Limit;
        }

        private void Add(in TestOutcome test)
        {
            if (_testCount < _tests.Length)
                _tests[_testCount++] = test;
        }

        private static string UsualMeasure(RejectionReason reason)
        {
            switch (reason)
            {
                case RejectionReason.OutsideScreen: return "outside screen, px";
                case RejectionReason.TooSmall: return "area, working px";
                case RejectionReason.TooLarge: return "area, px² at 640";
                case RejectionReason.NotCompact: return "compactness";
                case RejectionReason.TooElongated: return "length / width";
                case RejectionReason.MovingSurroundings: return "motion around";
                case RejectionReason.WrongColor: return "red-green coherence";
                case RejectionReason.NotConfirmed: return "frames waited";
                case RejectionReason.Duplicate: return "distance to a dot, px";
                case RejectionReason.LowConfidence: return "log-odds, one of many at once";
                case RejectionReason.NotNew: return "new light, share";
                case RejectionReason.CutByEdge: return "to the edge, px";
                default: return reason.ToString();
            }
        }
    }
}
