using System;

namespace LaserTracking.Detection
{
    /// <summary>
    /// The tests for light above the expected view of the projected picture. It needs no onset and no quiet surroundings, only to be
    /// of a dot's size and shape and alone: what else exceeds the expected view are people, and edges where the prediction is a little off.
    /// </summary>
    internal sealed class ExpectedLightJudge
    {
        private const double MaxRingShare = 0.1;

        /// <summary>Least excess times root of the area, levels·px at 640: what is left over along edges stays below.</summary>
        private const double MinStrength = 80;

        /// <summary>Below so many times the least excess, light that is drawn out is left over along an edge.</summary>
        private const double FaintExcess = 2.5;

        /// <summary>Share of the room above the expected view, of 255, from which a spot fills it.</summary>
        private const int FullRise = 150;

        private const double MinCompactness = 0.7;
        private const double MinFullCompactness = 0.5;

        /// <summary>Largest length through width of what is not far above the expected view.</summary>
        private const double MaxElongation = 2.5;

        private readonly ShotDetectorSettings _settings;
        private readonly BlobMeasurer _blobs;
        private readonly ExpectedView _expected;

        public ExpectedLightJudge(ShotDetectorSettings settings, BlobMeasurer blobs, ExpectedView expected)
        {
            _settings = settings;
            _blobs = blobs;
            _expected = expected;
        }

        /// <summary>See <see cref="ShotDetector.Trace"/>.</summary>
        public DetectionTrace? Trace { get; set; }

        /// <param name="view">The frame, with the expected view in the place of the past.</param>
        /// <param name="candidate">Seed and peaks given; everything else is filled.</param>
        /// <param name="scale">Working pixels per pixel of a picture 640 wide.</param>
        /// <param name="noise">Temporal noise, levels.</param>
        /// <param name="memory">Dots of the last frame.</param>
        /// <param name="known">The dot of the last frame that it continues, if any.</param>
        public void Judge(in FrameView view, ref Candidate candidate, double scale, double noise, DotMemory memory, out RememberedDot known)
        {
            known = default;

            // In small pictures a pixel is still a pixel: one alone is noise.
            double area = Math.Max(1, scale * scale);
            candidate.CenterX = candidate.SeedX;
            candidate.CenterY = candidate.SeedY;
            candidate.IsOnset = true;
            if (Fails(ref candidate, candidate.PeakRise < _expected.MinExcess, RejectionReason.TooFaint, candidate.PeakRise, _expected.MinExcess, "above expected, levels"))
                return;
            _blobs.Grow(view, ref candidate);

            candidate.Strength = Math.Max(candidate.PeakRise, candidate.PeakRelativeRise / 2) * Math.Sqrt(candidate.Area / area);

            // Over bright content little of a saturated dot is left, and that little is ragged; but it takes all the room there is.
            double minCompactness = candidate.PeakRelativeRise >= FullRise ? MinFullCompactness : MinCompactness;
            if (Fails(ref candidate, candidate.Area > _settings.MaxAreaPx * area, RejectionReason.TooLarge, candidate.Area / area, _settings.MaxAreaPx)
                || Fails(ref candidate, candidate.Area < _settings.MinAreaPx, RejectionReason.TooSmall, candidate.Area, _settings.MinAreaPx)
                || Fails(ref candidate, candidate.Compactness < minCompactness, RejectionReason.NotCompact, candidate.Compactness, minCompactness))
                return;
            double elongation = candidate.LongSigma / candidate.ShortSigma;
            double maxElongation = candidate.PeakRise < FaintExcess * _expected.MinExcess ? MaxElongation : _settings.MaxElongation;
            if (Fails(ref candidate, candidate.Strength < MinStrength, RejectionReason.TooFaint, candidate.Strength, MinStrength, "strength, levels·px")
                || Fails(ref candidate, elongation > maxElongation, RejectionReason.TooElongated, elongation, maxElongation))
                return;
            int margin = 6 + candidate.Right - candidate.Left + candidate.Bottom - candidate.Top;
            _expected.CopyExpected(candidate.Left - margin, candidate.Top - margin, candidate.Right + margin, candidate.Bottom + margin);
            SurroundingsMeasurer.ColorRise(view, ref candidate);
            SurroundingsMeasurer.Ring(view, ref candidate, noise);
            bool isKnown = memory.TryFind(candidate, out known);
            if (!isKnown && Fails(ref candidate, candidate.RingShare > MaxRingShare, RejectionReason.NotIsolated, candidate.RingShare, MaxRingShare, "ring: share above expected"))
                return;
            double unexplained = _expected.UnexplainedAround(candidate.SeedX, candidate.SeedY);
            if (!isKnown && Fails(ref candidate, unexplained > UnexplainedTiles.MaxShare, RejectionReason.MovingSurroundings, unexplained, UnexplainedTiles.MaxShare, "frames with unexpected light around"))
                return;
            candidate.IsOnset = !isKnown;
            candidate.IsConclusive = known.IsConclusive || (elongation <= _settings.ConclusiveElongation && candidate.RingShare <= _settings.MaxRingShare);
        }

        /// <summary>For a candidate of the usual search that is no brighter than expected.</summary>
        public void RejectExplained(ref Candidate candidate, int excess, out RememberedDot known)
        {
            known = default;
            candidate.CenterX = candidate.SeedX;
            candidate.CenterY = candidate.SeedY;
            Fails(ref candidate, true, RejectionReason.Rendered, excess, ExpectedView.MinUnexplained, "above expected, levels");
        }

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
    }
}
