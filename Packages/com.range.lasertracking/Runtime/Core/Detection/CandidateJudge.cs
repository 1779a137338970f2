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

        /// <summary>Relative rise, of 255, below which a glow that touches the picture's edge has to show its middle.</summary>
        private const int FaintRise = 128;

        /// <summary>Grey things reach one, and a little more by noise.</summary>
        private const double GreyVividness = 1.25;

        /// <summary>What the projector could show itself, and what rises less than this beyond what moves in its picture, is faint there.</summary>
        private const double MovementFactor = 2;

        /// <summary>Red or green through blue: infrared light rises in all three alike.</summary>
        private const double MinRiseAgainstBlue = 0.4;

        /// <summary>Least difference from the frame before that no displacement takes away: what moves leaves less than that, light on texture more.</summary>
        private const double MinUnexplained = 0.6;

        /// <summary>Half of what a red laser's light does to the luma: see <see cref="SurroundingsMeasurer.LumaShare"/>.</summary>
        private const double MinLumaShare = 0.12;

        /// <summary>What hardly any displacement explains at all has this much more for it, log-odds, where noise, movement, and much that rises at once are no other reason.</summary>
        internal const double SurelyUnexplained = 0.85, NewLightLogOdds = 1;

        private readonly ShotDetectorSettings _settings;
        private readonly BlobMeasurer _blobs;

        public CandidateJudge(ShotDetectorSettings settings, BlobMeasurer blobs)
        {
            _settings = settings;
            _blobs = blobs;
        }

        /// <summary>Records every test when there is one.</summary>
        public DetectionTrace? Trace { get; set; }

        /// <summary>Of the frame, microseconds.</summary>
        public long TimeUs { get; set; }

        /// <summary>Much of the picture has risen at once: what is faint proves nothing there.</summary>
        public bool IsCrowded { get; set; }

        /// <summary>Temporal noise of this frame, levels (one standard deviation).</summary>
        public double Noise { get; set; }

        /// <summary>Change from frame to frame that few pixels exceed, levels.</summary>
        public double Movement { get; set; }

        /// <summary>Working pixels per pixel of a picture 640 wide.</summary>
        public double Scale { get; set; } = 1;

        /// <summary>Brightness of the projected picture's brightest parts, levels.</summary>
        public int ContentLevel { get; set; }

        /// <summary>There is room above the projected picture's brightest for light that proves itself by its brightness.</summary>
        public bool IsContentKnown => ContentLevel + 1.5 * _settings.MinContentExcess <= 255;

        /// <summary>Levels above the projected picture's brightest at which one frame suffices.</summary>
        private double ConclusiveExcess => Math.Max(_settings.MinContentExcess, 0.6 * (255 - ContentLevel));

        /// <summary>By a margin: speckle lifts a dot a little above the picture's brightest in one frame and not in the next.</summary>
        public bool IsClearlyAboveContent(in FrameView view, in Candidate candidate) => IsContentKnown && !candidate.MayBeContent
            && SurroundingsMeasurer.PeakLevel(view, candidate) >= ContentLevel + 2 * _settings.MinContentExcess;

        /// <param name="view">The frame.</param>
        /// <param name="candidate">Plane, seed and peaks given; everything else is filled.</param>
        /// <param name="memory">Dots of the last frame: what goes on from there need not prove itself again.</param>
        /// <param name="known">The dot of the last frame that it continues, if any.</param>
        public void Judge(in FrameView view, ref Candidate candidate, DotMemory memory, out RememberedDot known)
        {
            known = default;
            double area = Scale * Scale;
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
                || Fails(ref candidate, candidate.Area < _settings.MinAreaPx, RejectionReason.TooSmall, candidate.Area, _settings.MinAreaPx))
                return;
            if (Fails(ref candidate, candidate.Compactness < _settings.MinCompactness, RejectionReason.NotCompact, candidate.Compactness, _settings.MinCompactness))
                return;
            candidate.Strength = candidate.PeakRise * Math.Sqrt(candidate.Area / area);
            int seed = candidate.SeedY * view.Width + candidate.SeedX;
            double fresh = view.Change(seed, candidate.Plane) / (double)candidate.PeakRise;
            candidate.IsOnset = fresh >= 0.5;
            candidate.PeakLevel = SurroundingsMeasurer.PeakLevel(view, candidate);
            int excess = candidate.PeakLevel - ContentLevel;
            candidate.ContentLevel = ContentLevel;
            candidate.ExceedsContent = IsContentKnown && excess >= _settings.MinContentExcess;
            candidate.MayBeContent = excess < _settings.MinContentExcess && (IsContentKnown || candidate.ActivityAround > _settings.QuietActivity);

            // What waits is weighed anew where it has grown most: a light that the smallest channel hardly shows is left to the largest.
            int largest = view.RelativeRise(seed, DetectionPlane.Largest);
            if (candidate.PeakRelativeRise < largest && memory.IsWaiting(candidate)
                && Fails(ref candidate, true, RejectionReason.Duplicate, rise, largest / 255.0, "rise, share of room, in the largest channel"))
                return;
            bool isKnown = memory.TryFind(candidate, out known);
            if (!isKnown && memory.IsPartOfResting(candidate, out double part)
                && Fails(ref candidate, true, RejectionReason.Duplicate, part, DotMemory.MaxPartShare, "share of a resting dot's area"))
                return;
            if (!isKnown && (Fails(ref candidate, !candidate.IsOnset, RejectionReason.NotNew, fresh, 0.5) || FailsAtEdge(view, ref candidate)))
                return;
            SurroundingsMeasurer.ColorRise(view, ref candidate, isKnown && HasDoubled(candidate, known) ? Math.Min(1, fresh) : 1);

            // What is asked belongs to the sighting that was weighed: how vivid a later one looks by chance asks no less.
            if (isKnown && !IsWeighedAgain(candidate, known))
                candidate.Vividness = known.Vividness;
            bool isProvenByLevel = IsContentKnown && excess >= ConclusiveExcess;

            // What the projector could show itself needs more, and twice as much where it is grey: a laser so weak would have a colour.
            double more = _settings.ContentLogOdds * (candidate.Vividness < GreyVividness ? 2 : 1);
            double conclusive = _settings.ConclusiveLogOdds + (IsContentKnown && candidate.MayBeContent ? more : 0);
            if (isKnown)
                GoOn(view, ref candidate, known, isProvenByLevel, conclusive);
            else
                Begin(view, ref candidate, minLevels, conclusive);
        }

        private static bool HasDoubled(in Candidate candidate, in RememberedDot known) => candidate.IsOnset && candidate.PeakRise >= 2 * known.HighestRise;

        /// <summary>
        /// Light that grows further says the same once more; what the picture may show itself grows when it comes
        /// from behind, too: only what has become twice as bright is weighed, as if it began now.
        /// </summary>
        private static bool IsWeighedAgain(in Candidate candidate, in RememberedDot known) =>
            !known.IsConclusive && candidate.IsOnset && (HasDoubled(candidate, known) || !candidate.MayBeContent);

        /// <summary>What still has to be said of a light that was there in the last frame.</summary>
        private void GoOn(in FrameView view, ref Candidate candidate, in RememberedDot known, bool isProvenByLevel, double conclusive)
        {
            candidate.LogOdds = known.LogOdds;
            if (IsWeighedAgain(candidate, known))
            {
                double before = candidate.MayBeContent ? 0 : known.LogOdds;
                double now = Weigh(view, ref candidate, before, _settings.MinLogOdds, out int _, stackalloc float[DotEvidence.Count]);
                candidate.LogOdds = Math.Max(candidate.LogOdds, before + now);
            }

            candidate.IsConclusive = known.IsConclusive || isProvenByLevel || candidate.LogOdds >= conclusive;

            // What moves comes and goes: there a light has to be shorter to be one by its end.
            long wait = candidate.ActivityAround > _settings.QuietActivity ? _settings.MaxWaitAmidMovementUs : _settings.MaxWaitUs;
            long elapsed = TimeUs - known.FirstTimeUs;
            Fails(ref candidate, !candidate.IsConclusive && WaitLimit.IsOver(known.Frames, elapsed, _settings.MaxWaitFrames, wait), RejectionReason.NotConfirmed, known.Frames,
                WaitLimit.FramesAt(elapsed / (double)known.Frames, _settings.MaxWaitFrames, wait));
        }

        /// <summary>What a light that begins has to show.</summary>
        /// <param name="view">The frame.</param>
        /// <param name="candidate">Grown, with its colours measured.</param>
        /// <param name="minLevels">Least rise of any candidate.</param>
        /// <param name="conclusive">Log-odds from which this frame suffices.</param>
        private void Begin(in FrameView view, ref Candidate candidate, double minLevels, double conclusive)
        {
            double rise = candidate.PeakRelativeRise / 255.0;

            // Where a flash has passed, pixels stand above their past that have only stopped falling: light rises in some channel.
            if (Fails(ref candidate, candidate.Freshness < _settings.MinFreshness, RejectionReason.NotNew, candidate.Freshness, _settings.MinFreshness, "freshness"))
                return;
            Span<float> features = stackalloc float[DotEvidence.Count];
            bool isFaint = rise < _settings.FaintRise || (candidate.MayBeContent && candidate.PeakRise < MovementFactor * Movement);
            double least = isFaint ? Math.Max(_settings.MinLogOdds, IsCrowded ? conclusive : _settings.FaintLogOdds) : _settings.MinLogOdds;
            bool isCalm = !IsCrowded && !view.IsBetweenPixels && candidate.PeakRise >= 2 * minLevels;
            double unexplainedLogOdds = isCalm ? NewLightLogOdds : 0;
            candidate.LogOdds = Weigh(view, ref candidate, 0, least - unexplainedLogOdds, out int against, features);
            EvidenceCurve curve = _settings.Evidence.Curves[against];
            if (Fails(ref candidate, candidate.LogOdds < least - unexplainedLogOdds, curve.Reason, features[against], curve.NearestLimit(features[against]), curve.What))
                return;
            double againstBlue = SurroundingsMeasurer.RiseAgainstBlue(view, candidate);
            if (Fails(ref candidate, againstBlue < MinRiseAgainstBlue, RejectionReason.WrongColor, againstBlue, MinRiseAgainstBlue, "red or green through blue"))
                return;
            candidate.IsConclusive = candidate.LogOdds >= conclusive;
            Trace?.AddConclusive(candidate.IsConclusive, candidate.LogOdds, conclusive, "all evidence, log-odds", true);

            // Movement explains what is weak or doubtful; strong new light on texture it explains by chance, in part.
            if (candidate.LogOdds >= conclusive + _settings.ContentLogOdds && rise >= 2 * _settings.FaintRise)
                return;
            double unexplained = DisplacementMeasurer.Unexplained(view, candidate);
            if (Fails(ref candidate, unexplained < MinUnexplained, RejectionReason.MovingSurroundings, unexplained, MinUnexplained, "not explained by a displacement"))
                return;

            // It may wait for that, no more: nothing is decided by it.
            if (unexplained >= SurelyUnexplained)
                candidate.LogOdds = Math.Max(candidate.LogOdds, Math.Min(candidate.LogOdds + unexplainedLogOdds, least));
            Fails(ref candidate, candidate.LogOdds < least, curve.Reason, features[against], curve.NearestLimit(features[against]), curve.What);
        }

        /// <summary>No single measure decides: all of them together say how likely this is a laser's light.</summary>
        private double Weigh(in FrameView view, ref Candidate candidate, double before, double least, out int against, Span<float> features)
        {
            FeatureMeasurer.MeasureItself(view, candidate, Scale, ContentLevel, features);
            double highest = _settings.Evidence.HighestLogOdds(features);
            bool isHopeless = before + highest < least;
            if (!isHopeless || Trace != null)
            {
                SurroundingsMeasurer.Ring(view, ref candidate, Noise);
                FeatureMeasurer.MeasureAround(view, candidate, Noise, (int)(_settings.MotionRadiusPx * Scale), features);
                candidate.MotionShare = features[(int)DotFeature.BrightenedAround] + features[(int)DotFeature.DarkenedAround];
                Trace?.AddEvidence(_settings.Evidence, features, before, least);
            }

            against = _settings.Evidence.StrongestAgainst(features, !isHopeless);
            return isHopeless ? highest : _settings.Evidence.LogOdds(features);
        }

        /// <summary>
        /// The tests for light above everything that the projected picture shows: it needs no quiet surroundings, only to be new, small
        /// and alone up there.
        /// </summary>
        public void JudgeAboveContent(in FrameView view, ref Candidate candidate, DotMemory memory, out RememberedDot known)
        {
            known = default;
            double area = Scale * Scale;
            candidate.IsAboveContent = candidate.ExceedsContent = true;
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
            double luma = SurroundingsMeasurer.LumaShare(view, candidate);
            if (Fails(ref candidate, luma < MinLumaShare, RejectionReason.WrongColor, luma, MinLumaShare, "brighter, not only of another colour"))
                return;
            candidate.IsConclusive = Suffices(ConclusiveExcess - excess, 0, "levels missing above")
                & Suffices(elongation, _settings.ConclusiveElongation, "length / width");
        }

        private bool FailsAtEdge(in FrameView view, ref Candidate candidate)
        {
            bool touches = candidate.Left == 0 || candidate.Top == 0 || candidate.Right == view.Width - 1 || candidate.Bottom == view.Height - 1;
            int least = touches && candidate.PeakRelativeRise < FaintRise ? MinFaintToEdge + (candidate.Right - candidate.Left + candidate.Bottom - candidate.Top) / 6 : MinFaintToEdge;
            double toEdge = ToEdge(view, candidate.SeedX, candidate.SeedY);

            // The rest of a light whose brightest part has been met already begins at its rim: the middle says where it is.
            if (least > MinFaintToEdge)
                toEdge = Math.Min(toEdge, ToEdge(view, candidate.CenterX, candidate.CenterY));
            return Fails(ref candidate, toEdge < least, RejectionReason.CutByEdge, toEdge, least);
        }

        private static double ToEdge(in FrameView view, double x, double y) =>
            Math.Min(Math.Min(x, view.Width - 1 - x), Math.Min(y, view.Height - 1 - y));

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

        /// <summary>One of the conditions under which this frame alone suffices; all of them are looked at, so that all can be shown.</summary>
        private bool Suffices(double value, double limit, string what)
        {
            Trace?.AddConclusive(value <= limit, value, limit, what, false);
            return value <= limit;
        }
    }
}
