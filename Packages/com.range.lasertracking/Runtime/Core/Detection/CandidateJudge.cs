using System;

namespace LaserTracking.Detection
{
    /// <summary>Puts a candidate through the tests, cheap ones first; the first one failed is the reason of its rejection.</summary>
    internal sealed unsafe class CandidateJudge
    {
        /// <summary>A long streak through the middle takes two of the eight.</summary>
        private const double MaxSpokeShare = 0.25;

        /// <summary>A faint glow that is brightest nearer to the picture's edge than this, working px, has its source outside.</summary>
        private const int MinFaintToEdge = 2;

        private readonly ShotDetectorSettings _settings;
        private readonly BlobMeasurer _blobs;

        public CandidateJudge(ShotDetectorSettings settings, BlobMeasurer blobs)
        {
            _settings = settings;
            _blobs = blobs;
        }

        /// <summary>Records every test when there is one.</summary>
        public DetectionTrace? Trace { get; set; }

        /// <summary>Temporal noise of this frame, levels (one standard deviation).</summary>
        public double Noise { get; set; }

        /// <summary>Working pixels per pixel of a picture 640 wide.</summary>
        public double Scale { get; set; } = 1;

        /// <summary>Brightness of the projected picture's brightest parts, levels.</summary>
        public int ContentLevel { get; set; }

        /// <summary>There is room above the projected picture's brightest for light that proves itself by its brightness.</summary>
        public bool IsContentKnown => ContentLevel + 1.5 * _settings.MinContentExcess <= 255;

        /// <summary>Levels above the projected picture's brightest at which one frame suffices.</summary>
        private double ConclusiveExcess => Math.Max(_settings.MinContentExcess, 0.6 * (255 - ContentLevel));

        /// <param name="view">The frame.</param>
        /// <param name="candidate">Plane, seed and peaks given; everything else is filled.</param>
        /// <param name="memory">Dots of the last frame: what goes on from there need not prove itself again.</param>
        /// <param name="known">The dot of the last frame that it continues, if any.</param>
        public void Judge(in FrameView view, ref Candidate candidate, DotMemory memory, out RememberedDot known)
        {
            known = default;
            double area = Scale * Scale;
            bool isLargest = candidate.Plane == DetectionPlane.Largest;
            candidate.CenterX = candidate.SeedX;
            candidate.CenterY = candidate.SeedY;
            double minLevels = Math.Max(_settings.MinRiseLevels, _settings.MinRiseSigmas * Noise);
            if (Fails(ref candidate, candidate.PeakRise < minLevels, RejectionReason.TooFaint, candidate.PeakRise, minLevels, "rise, levels"))
                return;
            double rise = candidate.PeakRelativeRise / 255.0;
            if (Fails(ref candidate, rise < _settings.MinRise, RejectionReason.TooFaint, rise, _settings.MinRise, "rise, share of room"))
                return;

            // Eight looks at the distance no dot reaches spare the growing of most moving things.
            double around = SurroundingsMeasurer.SpokeShare(view, candidate, (int)Math.Ceiling(1.5 * Math.Sqrt(_settings.MaxAreaPx * area / Math.PI)));
            if (Fails(ref candidate, around > MaxSpokeShare, RejectionReason.NotIsolated, around, MaxSpokeShare, "as bright all around"))
                return;
            _blobs.Grow(view, ref candidate);
            if (Fails(ref candidate, candidate.Area > _settings.MaxAreaPx * area, RejectionReason.TooLarge, candidate.Area / area, _settings.MaxAreaPx)
                || Fails(ref candidate, candidate.Area < _settings.MinAreaPx * area, RejectionReason.TooSmall, candidate.Area / area, _settings.MinAreaPx))
                return;
            bool isFaint = isLargest || rise < _settings.ConclusiveRise;
            if (Fails(ref candidate, candidate.Compactness < _settings.MinCompactness, RejectionReason.NotCompact, candidate.Compactness, _settings.MinCompactness))
                return;
            if (isFaint && FailsAtEdge(view, ref candidate))
                return;
            candidate.Strength = candidate.PeakRise * Math.Sqrt(candidate.Area / area);
            double minStrength = isFaint
                ? _settings.MinFaintStrength + _settings.FaintStrengthPerActivity * candidate.Activity
                : _settings.MinStrength + _settings.StrengthPerActivity * candidate.Activity;
            if (Fails(ref candidate, candidate.Strength < minStrength, RejectionReason.TooFaint, candidate.Strength, minStrength, "strength, levels·px"))
                return;
            double elongation = candidate.LongSigma / candidate.ShortSigma;
            double maxElongation = isLargest ? _settings.MaxLargestElongation : rise < _settings.StreakRise ? _settings.MaxFaintElongation : _settings.MaxElongation;
            if (Fails(ref candidate, elongation > maxElongation, RejectionReason.TooElongated, elongation, maxElongation))
                return;
            JudgeSurroundings(view, ref candidate, memory, out known, isFaint, elongation);
        }

        private void JudgeSurroundings(
            in FrameView view, ref Candidate candidate, DotMemory memory, out RememberedDot known, bool isFaint, double elongation)
        {
            int seed = candidate.SeedY * view.Width + candidate.SeedX;
            double fresh = view.Change(seed, candidate.Plane) / (double)candidate.PeakRise;
            candidate.IsOnset = fresh >= 0.5;
            SurroundingsMeasurer.ColorRise(view, ref candidate);
            int excess = SurroundingsMeasurer.PeakLevel(view, candidate) - ContentLevel;
            candidate.MayBeContent = excess < _settings.MinContentExcess && (IsContentKnown || candidate.ActivityAround > _settings.QuietActivity);
            bool isProvenByLevel = IsContentKnown && excess >= ConclusiveExcess;
            if (memory.TryFind(candidate, out known))
            {
                candidate.IsConclusive = known.IsConclusive || isProvenByLevel;
                Fails(ref candidate, !candidate.IsConclusive && known.Frames > _settings.MaxWaitFrames, RejectionReason.NotConfirmed, known.Frames, _settings.MaxWaitFrames);
                return;
            }

            double minFreshness = isFaint ? _settings.MinFaintFreshness : _settings.MinFreshness;

            // On saturated backgrounds only blue has room to rise: strong candidates may count on it, faint ones must show laser light.
            double freshness = isFaint ? candidate.Vividness : candidate.Freshness;
            if (Fails(ref candidate, freshness < minFreshness, RejectionReason.NotNew, freshness, minFreshness, isFaint ? "vividness" : "freshness")
                || Fails(ref candidate, !candidate.IsOnset, RejectionReason.NotNew, fresh, 0.5))
                return;

            // Large dots are bright lasers: their rim has the colour of one. Large things without it are round at least, or no dots.
            bool isVivid = candidate.Vividness >= _settings.VividFreshness && candidate.Strength >= _settings.VividStrength;
            bool isBlunt = candidate.Vividness < _settings.VividFreshness && candidate.Area > _settings.ConclusiveAreaPx * Scale * Scale;
            double coherence = Math.Abs(candidate.GreenCoherence);
            if (Fails(ref candidate, isBlunt && elongation > _settings.MaxBluntElongation, RejectionReason.TooElongated, elongation, _settings.MaxBluntElongation, "length / width, blunt")
                || Fails(ref candidate, isBlunt && coherence < _settings.MinBluntCoherence, RejectionReason.WrongColor, coherence, _settings.MinBluntCoherence))
                return;
            SurroundingsMeasurer.Ring(view, ref candidate, Noise);
            double maxShare = isFaint && !isVivid ? _settings.MaxFaintRingShare : _settings.MaxRingShare;
            double maxLevel = !isFaint ? _settings.MaxRingLevel : isVivid ? _settings.MaxVividRingLevel : _settings.MaxFaintRingLevel;
            if (Fails(ref candidate, candidate.RingShare > maxShare, RejectionReason.NotIsolated, candidate.RingShare, maxShare, "ring: share risen")
                || Fails(ref candidate, candidate.RingLevel > maxLevel, RejectionReason.NotIsolated, candidate.RingLevel, maxLevel, "ring: level"))
                return;
            candidate.MotionShare = SurroundingsMeasurer.MotionShare(view, candidate, (int)(_settings.MotionRadiusPx * Scale), Noise);
            double maxMotion = isFaint ? _settings.MaxFaintMotionShare : IsExemplary(candidate, elongation) ? _settings.MaxExemplaryMotionShare : _settings.MaxMotionShare;
            if (Fails(ref candidate, candidate.MotionShare > maxMotion, RejectionReason.MovingSurroundings, candidate.MotionShare, maxMotion))
                return;

            // What comes out of nowhere may be the corner of a target, rim and all, unless it is a dot as dots should be, or round and vivid.
            bool isRoundAndVivid = candidate.Vividness >= _settings.VividFreshness && elongation <= _settings.MaxBluntElongation;
            bool isLively = candidate.ActivityAround > _settings.QuietActivity;
            bool isSuspect = candidate.MayBeContent && ((isLively && IsContentKnown) || (!isRoundAndVivid && !IsExemplary(candidate, elongation)));
            candidate.IsConclusive = (isProvenByLevel && Suffices(ConclusiveExcess - excess, 0, "levels missing above")) || Suffices(!isSuspect, "may be the picture")
                & Suffices(!isFaint, "faint") & Suffices(!isBlunt, "blunt")
                & Suffices(candidate.RingShare, _settings.ConclusiveRingShare, "ring: share risen")
                & Suffices(candidate.RingLevel, _settings.ConclusiveRingLevel, "ring: level")
                & Suffices(candidate.MotionShare, _settings.ConclusiveMotionShare, "motion around")
                & Suffices(elongation, _settings.ConclusiveElongation, "length / width");
        }

        /// <summary>
        /// The tests for light above everything that the projected picture shows: it needs no quiet surroundings, only to be new, small
        /// and alone up there.
        /// </summary>
        public void JudgeAboveContent(in FrameView view, ref Candidate candidate, DotMemory memory, out RememberedDot known)
        {
            known = default;
            double area = Scale * Scale;
            candidate.IsAboveContent = true;
            candidate.ContentLevel = ContentLevel;
            candidate.CenterX = candidate.SeedX;
            candidate.CenterY = candidate.SeedY;
            int seed = candidate.SeedY * view.Width + candidate.SeedX;
            int excess = FrameView.Level(view.Now[seed], candidate.Plane) - ContentLevel;
            _blobs.Grow(view, ref candidate);
            candidate.Strength = excess * Math.Sqrt(candidate.Area / area);
            if (Fails(ref candidate, candidate.Area > _settings.MaxAreaPx * area, RejectionReason.TooLarge, candidate.Area / area, _settings.MaxAreaPx)
                || Fails(ref candidate, candidate.Area < 2, RejectionReason.TooSmall, candidate.Area / area, 2 / area))
                return;
            if (excess < ConclusiveExcess && FailsAtEdge(view, ref candidate))
                return;
            double elongation = candidate.LongSigma / candidate.ShortSigma;

            // A resting dot trembles: only where nothing near was as bright in the frame before has light begun.
            double before = SurroundingsMeasurer.ExcessBefore(view, candidate);
            candidate.IsOnset = before < 0.5;
            SurroundingsMeasurer.ColorRise(view, ref candidate);
            if (memory.TryFind(candidate, out known))
            {
                candidate.IsConclusive = known.IsConclusive || excess >= ConclusiveExcess;
                return;
            }

            candidate.RingShare = SurroundingsMeasurer.ExcessRingShare(view, candidate);
            if (Fails(ref candidate, !candidate.IsOnset, RejectionReason.NotNew, 1 - before, 0.5)
                || Fails(ref candidate, elongation > _settings.MaxElongation, RejectionReason.TooElongated, elongation, _settings.MaxElongation)
                || Fails(ref candidate, candidate.RingShare > _settings.MaxRingShare, RejectionReason.NotIsolated, candidate.RingShare, _settings.MaxRingShare, "ring: share risen"))
                return;
            candidate.IsConclusive = Suffices(ConclusiveExcess - excess, 0, "levels missing above")
                & Suffices(elongation, _settings.ConclusiveElongation, "length / width");
        }

        private bool FailsAtEdge(in FrameView view, ref Candidate candidate)
        {
            int toEdge = Math.Min(Math.Min(candidate.SeedX, view.Width - 1 - candidate.SeedX), Math.Min(candidate.SeedY, view.Height - 1 - candidate.SeedY));
            return Fails(ref candidate, toEdge < MinFaintToEdge, RejectionReason.CutByEdge, toEdge, MinFaintToEdge);
        }

        /// <summary>So much like a dot in itself that only its neighbourhood speaks against it: a bumped camera must not hide it.</summary>
        private bool IsExemplary(in Candidate candidate, double elongation) =>
            candidate.PeakRelativeRise >= 255 * _settings.ExemplaryRise && candidate.Compactness >= _settings.ExemplaryCompactness
            && candidate.Area <= _settings.ConclusiveAreaPx * Scale * Scale && elongation <= _settings.MaxLargestElongation
            && candidate.RingShare <= _settings.MaxFaintRingShare && candidate.RingLevel <= _settings.MaxFaintRingLevel;

        private bool Fails(ref Candidate candidate, bool isFailed, RejectionReason reason, double value, double limit, string? what = null)
        {
            Trace?.Add(reason, !isFailed, value, limit, what);
            if (!isFailed)
                return false;
            candidate.Reason = reason;
            candidate.Value = value;
            candidate.Limit = limit;
            return true;
        }

        private bool Suffices(bool isMet, string against)
        {
            Trace?.AddConclusive(isMet, isMet ? 0 : 1, double.NaN, against);
            return isMet;
        }

        /// <summary>One of the conditions under which this frame alone suffices; all of them are looked at, so that all can be shown.</summary>
        private bool Suffices(double value, double limit, string what)
        {
            Trace?.AddConclusive(value <= limit, value, limit, what);
            return value <= limit;
        }
    }
}
