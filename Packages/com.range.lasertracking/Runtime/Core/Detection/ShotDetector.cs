using System;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>
    /// The default detector. A dot is what rises sharply above the recent past of its own pixels, measured against the room that was
    /// left there, alone in quiet surroundings. Works on saturated and on faint dots, while other parts of the picture move, and
    /// usually from a single frame. Integer kernels on the raw frame find the few tiles worth exact work.
    /// </summary>
    public sealed unsafe class ShotDetector : IShotDetector
    {
        /// <summary>Levels that a tile's largest onset must exceed in any case.</summary>
        internal const int GateFloor = 2;

        private readonly ShotDetectorSettings _settings;
        private readonly DetectionPlanes _planes;
        private readonly BlobMeasurer _blobs = new BlobMeasurer();
        private readonly CandidateJudge _judge;
        private readonly SeedFinder _finder;
        private readonly DotMeasurer _measurer;
        private readonly DotMemory _memory = new DotMemory();
        private readonly RestingDots _resting;
        private readonly NoiseMeter _noise;
        private readonly GlobalChangeMeter _change;
        private readonly ContentCeiling _content;
        private readonly ScreenMask _mask = new ScreenMask();
        private readonly BlindMeter _blind;
        private readonly int[] _reciprocal = FrameView.Reciprocals();
        private readonly WaitingCandidate[] _waiting;
        private readonly Candidate[] _seeds;
        private readonly int[] _seedOrder;
        private readonly ExpectedView? _expected;
        private readonly ExpectedLightJudge? _expectedJudge;
        private int _examinedCount;
        private int _waitingCount;
        private bool _isSmooth;
        private bool _isPredicted;

        /// <param name="settings">Defaults when absent. Copied.</param>
        /// <param name="expected">What the camera should see of the projected picture, where the rendered pictures are known.</param>
        /// <param name="kernels">What runs the heavy kernels; this thread when absent.</param>
        /// <exception cref="ArgumentException">A setting is outside its range.</exception>
        public ShotDetector(ShotDetectorSettings? settings = null, ExpectedView? expected = null, KernelRunner? kernels = null)
        {
            kernels ??= KernelRunner.Plain;
            _planes = new DetectionPlanes(kernels);
            _noise = new NoiseMeter(kernels);
            _change = new GlobalChangeMeter(kernels);
            _content = new ContentCeiling(kernels);
            _settings = settings?.Clone() ?? new ShotDetectorSettings();
            _settings.Validate();
            _blind = new BlindMeter(_settings);
            _measurer = new DotMeasurer(_settings);
            _judge = new CandidateJudge(_settings, _blobs);
            _expected = expected;
            _expectedJudge = expected == null ? null : new ExpectedLightJudge(_settings, _blobs, expected);
            _waiting = new WaitingCandidate[4 * _settings.MaxCandidates];
            _seeds = new Candidate[_settings.MaxCandidates];
            _seedOrder = new int[_settings.MaxCandidates];
            _resting = new RestingDots(_blobs, _memory);
            _finder = new SeedFinder(_settings.MaxCandidates, _blobs, _memory, kernels);
            Probe = new DetectorProbe(_settings, _planes, _change, _judge, _blobs, _finder, _reciprocal);
        }

        public string Name => "shots";

        /// <summary>Records what each frame's candidates were tested for, when there is one; costs nothing otherwise.</summary>
        public DetectionTrace? Trace
        {
            get => _judge.Trace;
            set
            {
                _judge.Trace = value;
                if (_expectedJudge != null)
                    _expectedJudge.Trace = value;
            }
        }

        /// <summary>To ask what it would have taken in the last frame.</summary>
        internal DetectorProbe Probe { get; }

        /// <summary>Temporal noise of the working picture, levels; not misled by moving content where that is known.</summary>
        private double Noise => _isPredicted && _expected!.Noise > 0 ? _expected.Noise : _noise.Sigma;

        public void SetScreenPolygon(Vector2D[] cornersPx) => _mask.Set(cornersPx);

        public void Reset()
        {
            _planes.Reset();
            _expected?.Reset();
        }

        public void Process(Frame frame, Detections detections)
        {
            Image image = frame.Color;
            detections.Begin(frame.Index, image.IsPresent ? image.TimeUs : frame.TimeUs);
            Trace?.Begin(frame.Index);
            if (!image.IsPresent || !PixelRow.CanRead(image.Format))
                return;
            detections.ImageWidthPx = image.Width;
            detections.ImageHeightPx = image.Height;
            if (_planes.Fit(image, _settings.FullSizeMaxWidthPx))
                Restart();

            // Noise of the raw picture decides, with a gap between on and off: a smoothed picture has three eighths of it.
            double rawNoise = _isSmooth ? Noise / 0.375 : Noise;
            bool isSmooth = rawNoise > (_isSmooth ? 0.8 : 1) * _settings.SmoothingNoise;
            if (isSmooth != _isSmooth)
            {
                _isSmooth = isSmooth;
                _noise.Scale(isSmooth ? 0.375 : 1 / 0.375);
                if (_expected != null)
                    _expected.Noise *= isSmooth ? 0.375 : 1 / 0.375;
            }

            Probe.IsSmooth = _isSmooth;
            // What is known to move is no movement of the camera: where the rendered pictures are known, that is not guessed at.
            if (_expected?.DelayUs != null)
                _change.Hold();
            else
                _change.Measure(image, rawNoise);
            _content.Scale(_change.Gain);
            _planes.Update(image, _change, Decay(), _isSmooth, _settings.UseVectors);
            if (_planes.FrameCount < 2)
                return;
            fixed (uint* now = _planes.Now, before = _planes.Before)
            fixed (byte* oldMin = _planes.OldSmallest, newMin = _planes.NewSmallest, oldMax = _planes.OldLargest, newMax = _planes.NewLargest)
            fixed (int* reciprocal = _reciprocal)
            {
                FrameView view = FrameView.Of(_planes, _change, now, before, oldMin, newMin, oldMax, newMax, reciprocal);
                Search(image, view, detections);
            }
        }

        /// <summary>While the camera shakes, things dim and brighten by how they fall on the pixels: the past then fades by a level every fourth frame only.</summary>
        private int Decay() => !_change.IsUnsteady ? _settings.EnvelopeDecay : _planes.FrameCount % 4 == 3 ? 1 : 0;

        private void Restart()
        {
            double scale = _planes.Width / 640.0;
            _judge.Scale = Math.Max(0.25, scale);
            _blobs.Resize(_planes.Width * _planes.Height, (int)(_settings.MaxAreaPx * _judge.Scale * _judge.Scale) + 1);
            _memory.Clear();
            _blind.Resize();
            _noise.Reset();
            _change.Reset(_planes.Width, _planes.Height, _planes.Factor);
            _content.Reset();
            _isSmooth = false;
        }

        private void Search(Image image, in FrameView view, Detections detections)
        {
            _noise.Update(view);
            _judge.Noise = _noise.Sigma;
            _judge.Movement = _noise.Movement;
            _judge.TimeUs = detections.TimeUs;
            _content.Update(view);
            _judge.ContentLevel = _content.Level;
            _examinedCount = 0;
            _isPredicted = _expected != null
                && _expected.Update(view, _planes.Factor, image.Width, image.Height, detections.TimeUs, _noise.Sigma, _settings.UseVectors);
            detections.Prediction = _expected?.State ?? PredictionState.Off;
            detections.PredictedDelayUs = _expected?.DelayUs;
            if (_isPredicted)
                SearchAboveExpected(image, view, _expected!, detections);
            else
                KeepResting(image, view, detections);
            SearchPlane(image, view, DetectionPlane.Smallest, _planes.SmallestTiles, GateFloor, detections);
            SearchPlane(image, view, DetectionPlane.Largest, _planes.LargestTiles, GateFloor, detections);
            AddWaiting(image, view, detections);
            if (_judge.IsContentKnown)
                SearchAboveContent(image, view, detections);
            Trace?.Spot?.Look(view, _judge.IsContentKnown ? _content.Level + _settings.MinContentExcess : 256, _memory);
            _expected?.EndFrame(detections.Dots.Length, _memory);
            _blind.Measure(view, _planes.SmallestTiles, _mask, _planes.Factor, Noise, _judge.IsContentKnown, detections);
            if (_isPredicted)
                detections.BlindShare = _expected!.BlindShare();
            _memory.ReportTraces(view, Noise, detections);
            _memory.Protect(view, _planes.SmallestTiles, _planes.LargestTiles);
            if (_planes.FrameCount == 2)
            {
                _planes.SmallestTiles.LearnAtOnce();
                _planes.LargestTiles.LearnAtOnce();
            }
            else
            {
                _planes.SmallestTiles.Learn();
                _planes.LargestTiles.Learn();
            }
        }

        private void SearchPlane(Image image, in FrameView view, DetectionPlane plane, TileGrid tiles, int floor, Detections detections)
        {
            // Two rounds: a tile may hold two dots. The highest rise goes first, or a faint neighbour would grow into it and take it along.
            _blobs.Begin();
            Span<int> hot = tiles.FindHot(floor, _settings.MaxCandidates);
            detections.Skip(tiles.HotCount - hot.Length);
            _judge.IsCrowded = tiles.HotCount > _settings.CrowdedShare * tiles.Columns * tiles.Rows;
            bool isAboveExpected = tiles == _expected?.Tiles;
            if (!isAboveExpected)
                Trace?.Spot?.SetTile(plane, tiles, hot, floor, view, _planes.Factor);
            if (_isPredicted)
                hot = _expected!.Unexplained(hot);
            _finder.Fill(view, plane, tiles.Columns, hot);
            for (int round = 0; round < 2; round++)
            {
                int seeds = 0;
                for (int slot = 0; slot < hot.Length; slot++)
                {
                    int tile = hot[slot];
                    if (!_finder.TryFind(view, plane, tile % tiles.Columns, tile / tiles.Columns, slot, out Candidate candidate))
                        continue;
                    candidate.Activity = tiles.Activity(tile);
                    candidate.ActivityAround = tiles.ActivityAround(tile);
                    candidate.IsAboveExpected = isAboveExpected;
                    _seeds[seeds] = candidate;
                    _seedOrder[seeds] = seeds - (candidate.PeakRelativeRise << 16);
                    seeds++;
                }

                Array.Sort(_seedOrder, 0, seeds);
                for (int i = 0; i < seeds && _examinedCount < _waiting.Length; i++)
                {
                    ref Candidate candidate = ref _seeds[_seedOrder[i] & 0xFFFF];
                    if (_blobs.IsTaken(candidate.SeedY * view.Width + candidate.SeedX) || _memory.IsLit(candidate.SeedX, candidate.SeedY))
                        continue;
                    Examine(image, view, ref candidate, detections);
                    _examinedCount++;
                }
            }

            _memory.ForgetProvisional();
        }

        /// <summary>Light that no projected picture reaches, wherever no dot has been found yet: motion around it means nothing.</summary>
        private void SearchAboveContent(Image image, in FrameView view, Detections detections)
        {
            TileGrid tiles = _planes.LargestTiles;
            int limit = _content.Level + _settings.MinContentExcess;
            _blobs.Begin();
            for (int tile = 0; tile < tiles.Columns * tiles.Rows && _examinedCount < _waiting.Length; tile++)
            {
                if (tiles.Onset(tile) < _settings.MinContentExcess / 2 || (_isPredicted && _expected!.ExplainsTile(tile))
                    || !_finder.TryFindExcess(view, tile % tiles.Columns, tile / tiles.Columns, limit, out Candidate candidate))
                    continue;
                candidate.Activity = tiles.Activity(tile);
                candidate.IsAboveContent = true;
                Examine(image, view, ref candidate, detections);
                _examinedCount++;
            }
        }

        /// <summary>Light that is not the projected picture's, with the expected view in the place of the pixels' past.</summary>
        private void SearchAboveExpected(Image image, in FrameView view, ExpectedView expected, Detections detections)
        {
            fixed (byte* reference = expected.Reference)
            fixed (uint* picture = expected.Picture)
            {
                FrameView against = view;
                against.OldLargest = reference;
                against.Before = picture;
                against.IsBetweenPixels = false;
                SearchPlane(image, against, DetectionPlane.Largest, expected.Tiles, expected.MinExcess - 1, detections);
            }
        }

        private void Examine(Image image, in FrameView view, ref Candidate candidate, Detections detections)
        {
            RememberedDot known;
            if (candidate.IsAboveExpected)
                _expectedJudge!.Judge(view, ref candidate, _judge.Scale, Noise, _memory, out known);
            else if (_isPredicted && _expected!.Explains(view, candidate, out int excess))
                _expectedJudge!.RejectExplained(ref candidate, excess, out known);
            else if (candidate.IsAboveContent)
                _judge.JudgeAboveContent(view, ref candidate, _memory, out known);
            else
                _judge.Judge(view, ref candidate, _memory, out known);
            int factor = _planes.Factor;
            var position = new Vector2D((candidate.CenterX + view.ShiftX + 0.5) * factor - 0.5, (candidate.CenterY + view.ShiftY + 0.5) * factor - 0.5);
            if (candidate.Reason == RejectionReason.None && !_mask.IsWholePicture)
            {
                double outside = _mask.SignedDistancePx(position);
                Trace?.Add(RejectionReason.OutsideScreen, outside <= 0, outside, 0, null);
                if (outside > 0)
                {
                    candidate.Reason = RejectionReason.OutsideScreen;
                    candidate.Value = outside;
                    candidate.Limit = 0;
                }
            }

            if (candidate.Reason != RejectionReason.None && candidate.Reason != RejectionReason.TooFaint && candidate.Fade(view))
                Trace?.Add(candidate.Reason, false, candidate.Value, candidate.Limit, null);
            double near = 0, reach = 0;
            if (candidate.Reason == RejectionReason.None && _memory.IsHaloOf(candidate, out near, out reach))
            {
                candidate.Reason = RejectionReason.Duplicate;
                candidate.Value = near * factor;
                candidate.Limit = reach * factor;
                Trace?.Add(candidate.Reason, false, candidate.Value, candidate.Limit, null);
            }

            if (candidate.Reason != RejectionReason.None)
            {
                Trace?.Finish(candidate, view, position, factor, known.Frames > 0, -1);
                detections.Reject(new RejectedCandidate { PositionPx = position, Reason = candidate.Reason, Value = candidate.Value, Limit = candidate.Limit });
                return;
            }

            if (!candidate.IsConclusive && known.Frames == 0 && !candidate.IsAboveExpected && !candidate.IsAboveContent)
            {
                int traceIndex = Trace?.FinishWaiting(candidate, view, position, factor) ?? -1;
                _waiting[_waitingCount++] = new WaitingCandidate(candidate, traceIndex);
                RememberedDot place = RememberedDot.PlaceOf(candidate);
                place.IsProvisional = true;
                _memory.Add(place);
                return;
            }

            Take(image, view, candidate, known, detections);
        }

        private void KeepResting(Image image, in FrameView view, Detections detections)
        {
            for (int next = 0; _resting.TryFind(view, Noise, detections.TimeUs, ref next, out Candidate candidate, out RememberedDot known);)
                Take(image, view, candidate, known, detections);
        }

        private void Take(Image image, in FrameView view, in Candidate candidate, in RememberedDot known, Detections detections)
        {
            Dot dot = _measurer.Measure(image, view, _planes.Factor, candidate, known, Noise);
            Trace?.Finish(candidate, view, dot.PositionPx, _planes.Factor, known.Frames > 0, detections.Dots.Length);
            detections.Add(dot);
            Remember(view, candidate, dot, known);
        }

        /// <summary>
        /// What this frame does not decide comes last, by what speaks for it: one light may show in both planes, and the part of it that
        /// was met first must not hide the rest.
        /// </summary>
        private void AddWaiting(Image image, in FrameView view, Detections detections)
        {
            // Lasers begin one or two at a time: what speaks for many at once is shared out among them.
            double least = _settings.MinLogOdds + Math.Log(Math.Max(1, _waitingCount / 2.0));
            for (; _waitingCount > 0; _waitingCount--)
            {
                int best = 0;
                for (int i = 1; i < _waitingCount; i++)
                {
                    if (_waiting[i].Candidate.LogOdds > _waiting[best].Candidate.LogOdds)
                        best = i;
                }

                WaitingCandidate waiting = _waiting[best];
                _waiting[best] = _waiting[_waitingCount - 1];
                Candidate candidate = waiting.Candidate;
                Dot dot = _measurer.Measure(image, view, _planes.Factor, candidate, default, Noise);
                bool isHalo = _memory.IsHaloOf(candidate, out double near, out double reach);
                if (isHalo || candidate.LogOdds < least)
                {
                    RejectedCandidate rejected = isHalo
                        ? new RejectedCandidate { PositionPx = dot.PositionPx, Reason = RejectionReason.Duplicate, Value = near * _planes.Factor, Limit = reach * _planes.Factor }
                        : new RejectedCandidate { PositionPx = dot.PositionPx, Reason = RejectionReason.LowConfidence, Value = candidate.LogOdds, Limit = least };
                    detections.Reject(rejected);
                    Trace?.SettleWaiting(waiting.TraceIndex, rejected);
                    continue;
                }

                Trace?.SettleWaiting(waiting.TraceIndex, dot.PositionPx, detections.Dots.Length);
                detections.Add(dot);
                Remember(view, candidate, dot, default);
            }
        }

        private void Remember(in FrameView view, in Candidate candidate, in Dot dot, in RememberedDot known)
        {
            RememberedDot remembered = RememberedDot.Of(candidate);
            remembered.Frames = known.Frames + 1;
            remembered.FirstTimeUs = remembered.LastTimeUs = _judge.TimeUs;
            remembered.Color = dot.Color;
            remembered.PositionPx = dot.PositionPx;
            remembered.WasAboveContent = _judge.IsClearlyAboveContent(view, candidate);
            if (known.Frames == 0)
                remembered.RememberPlace(view, candidate);
            else
                remembered.TakePlaceOf(known);
            _memory.Add(remembered);
        }
    }
}
