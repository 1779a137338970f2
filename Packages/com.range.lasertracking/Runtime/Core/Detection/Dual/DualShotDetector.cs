using System;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Infrared and colour together, after the published dual filter: finds lasers at rest, several at once, and rejects lights that
    /// are red, blue, white or yellow. Spots of the infrared picture come first and colour is read only around them; flashes in colour
    /// come from <see cref="ShotDetector"/>; green dots at rest that infrared does not show are found by a search spread over frames.
    /// Infrared is optional: a 532 nm dot is not in an 850 nm picture, and an 850 nm emitter is hardly in the other.
    /// </summary>
    public sealed class DualShotDetector : IShotDetector
    {
        private const int MaxDots = 64;

        /// <summary>How far a light may go from one frame to the next, px of a picture 1920 wide: the tracker's own reach.</summary>
        private const double LinkPx = 120;
        /// <summary>Light this near to a dot is that dot's, px of a picture 1920 wide.</summary>
        private const double OtherDotPx = 3;

        private readonly DualDetectorSettings _settings;
        private readonly InfraredMapping? _calibrated;
        private readonly ShotDetector _flashes;
        private readonly Detections _found = new Detections();
        private readonly InfraredSpotFinder _infrared;
        private readonly ColorProbe _probe;
        private readonly RestingDotFinder _resting;
        private readonly ScreenMask _mask = new ScreenMask();
        private readonly Vector2D[] _last = new Vector2D[MaxDots];
        private InfraredMapping? _mapping;
        private int _infraredWidth;
        private int _infraredHeight;
        private int _width;
        private int _height;
        private int _lastCount;
        private Vector2D[] _wrong = new Vector2D[MaxDots];
        private Vector2D[] _wrongBefore = new Vector2D[MaxDots];
        private int _wrongCount;
        private int _wrongBeforeCount;

        /// <param name="settings">Defaults when absent. Copied.</param>
        /// <param name="mapping">From infrared to colour px; null, or one for pictures of other sizes: equal fields of view.</param>
        /// <param name="kernels">What runs the heavy kernels; this thread when absent.</param>
        /// <param name="flashSettings">Of the search for flashes in colour; defaults when absent.</param>
        /// <exception cref="ArgumentException">A setting is outside its range.</exception>
        public DualShotDetector(DualDetectorSettings? settings = null, InfraredMapping? mapping = null, ShotDetectorSettings? flashSettings = null,
            KernelRunner? kernels = null)
        {
            kernels ??= KernelRunner.Plain;
            _settings = settings?.Clone() ?? new DualDetectorSettings();
            _settings.Validate();
            _calibrated = mapping;
            _flashes = new ShotDetector(flashSettings, null, kernels);
            _infrared = new InfraredSpotFinder(_settings, kernels);
            _probe = new ColorProbe(_settings);
            _resting = new RestingDotFinder(_settings, _probe, kernels);
        }

        public string Name => "dual";

        public void SetScreenPolygon(Vector2D[] cornersPx)
        {
            _mask.Set(cornersPx);
            _flashes.SetScreenPolygon(cornersPx);
        }

        public void Reset()
        {
            _flashes.Reset();
            _resting.Reset();
            _mapping = null;
            _width = _infraredWidth = _lastCount = _wrongCount = _wrongBeforeCount = 0;
        }

        /// <summary>Without a colour picture ever, positions are infrared px; a frame that lacks it uses the size of the last one.</summary>
        public void Process(Frame frame, Detections detections)
        {
            Image color = frame.Color, infrared = frame.Infrared;
            bool hasColor = color.IsPresent && PixelRow.CanRead(color.Format);
            bool hasInfrared = infrared.IsPresent && infrared.Format == PixelFormat.Infrared16;
            detections.Begin(frame.Index, color.IsPresent ? color.TimeUs : frame.TimeUs);
            if (!hasColor && !hasInfrared)
                return;
            FitSizes(color, hasColor, infrared, hasInfrared);
            detections.ImageWidthPx = _width;
            if (hasColor && _settings.SearchesColor)
                _flashes.Process(frame, _found);
            else
                _found.Begin(frame.Index, frame.TimeUs);
            detections.BlindShare = _found.BlindShare;
            detections.Skip(_found.OverflowCount);
            foreach (RejectedCandidate candidate in _found.Rejected)
                detections.Reject(candidate);
            if (hasInfrared)
                AddInfrared(infrared, hasColor ? color : null, detections);
            int confirmed = detections.Dots.Length;
            AddFlashes(color, confirmed, detections);
            if (hasColor && _settings.SearchesColor)
                AddResting(color, detections);
            ReadOnlySpan<Dot> dots = detections.Dots;
            _lastCount = Math.Min(MaxDots, dots.Length);
            for (int i = 0; i < _lastCount; i++)
                _last[i] = dots[i].PositionPx;
        }

        private void FitSizes(Image color, bool hasColor, Image infrared, bool hasInfrared)
        {
            int width = hasColor ? color.Width : _width > 0 ? _width : infrared.Width, height = hasColor ? color.Height : _width > 0 ? _height : infrared.Height;
            bool isSame = width == _width && height == _height && (!hasInfrared || (infrared.Width == _infraredWidth && infrared.Height == _infraredHeight));
            _width = width;
            _height = height;
            if (!hasInfrared || (isSame && _mapping != null))
                return;
            _infraredWidth = infrared.Width;
            _infraredHeight = infrared.Height;
            _mapping = _calibrated != null && _calibrated.IsFor(_infraredWidth, _infraredHeight, width, height)
                ? _calibrated
                : InfraredMapping.EqualFields(_infraredWidth, _infraredHeight, width, height);
        }

        private double Scale => Math.Max(0.25, _width / 1920.0);

        /// <summary>As far as the mapping may be off, and a little for the light's own width.</summary>
        private double LookRadiusPx => Math.Min(_settings.MatchRadiusPx, 6 + 3 * _mapping!.SigmaPx) * Scale;

        private void AddInfrared(Image infrared, Image? color, Detections detections)
        {
            _infrared.Find(infrared);
            detections.Skip(_infrared.SkippedCount);
            ReadOnlySpan<Spot> spots = _infrared.Spots;
            for (int i = 0; i < spots.Length; i++)
            {
                if (!_mapping!.TryMap(spots[i].PositionPx, out Vector2D at))
                    continue;
                RejectedCandidate verdict = _infrared.Verdicts[i];
                double outside = _mask.SignedDistancePx(at);
                if (outside > 0 && verdict.Reason != RejectionReason.TooFaint)
                    verdict = new RejectedCandidate { Reason = RejectionReason.OutsideScreen, Value = outside };
                if (verdict.Reason == RejectionReason.None)
                    verdict = JudgeColor(spots[i], at, color, detections);
                verdict.PositionPx = at;
                if (verdict.Reason != RejectionReason.None)
                    detections.Reject(verdict);
            }
        }

        /// <summary>Adds the dot unless its visible light, or its confidence, speaks against it; then says why.</summary>
        private RejectedCandidate JudgeColor(in Spot spot, Vector2D at, Image? color, Detections detections)
        {
            LightHue hue = color == null ? LightHue.Unknown : _probe.Look(color, at, LookRadiusPx);
            if ((hue == LightHue.White || hue == LightHue.Other) && _probe.RelativeRise < _settings.MaxInfraredLeak)
                hue = LightHue.Magenta;
            if (hue == LightHue.White || hue == LightHue.Other)
                return new RejectedCandidate { Reason = RejectionReason.WrongColor, Value = _probe.GreenShare, Limit = _settings.MinGreenShare };
            if (hue != LightHue.Green && HasGreenFlash(at))
                return default;
            double share = spot.Rise / (double)Math.Max(1, spot.Rise + spot.Background);
            var dot = new Dot { IsConclusive = true };
            bool isOwnLight = color != null && hue != LightHue.None && NearestPx(_probe.Spot.PositionPx, detections.Dots) > OtherDotPx * Scale;
            if (isOwnLight)
            {
                Place(_probe.Spot, _probe.Peak, ref dot);
                dot.Color = hue == LightHue.Green ? LaserColor.Green : hue == LightHue.Unknown ? LaserColor.Unknown : LaserColor.Infrared;
            }
            else
            {
                Place(spot, at, share, ref dot);
                dot.Color = color == null ? LaserColor.Unknown : LaserColor.Infrared;
            }

            double other = NearestPx(dot.PositionPx, detections.Dots);
            if (other <= OtherDotPx * Scale)
                return new RejectedCandidate { Reason = RejectionReason.Duplicate, Value = other, Limit = OtherDotPx * Scale };
            return Add(ref dot, share, spot.RingShare, detections);
        }

        /// <summary>The search for flashes, which knows the background, has seen green here: its dot will be added.</summary>
        private bool HasGreenFlash(Vector2D at)
        {
            foreach (Dot flash in _found.Dots)
            {
                if (flash.Color == LaserColor.Green && (flash.PositionPx - at).Length <= _settings.MatchRadiusPx * Scale)
                    return true;
            }

            return false;
        }

        /// <summary>Where infrared alone shows it: its position and covariance carried over, with the mapping's own doubt.</summary>
        private void Place(in Spot spot, Vector2D at, double share, ref Dot dot)
        {
            dot.PositionPx = at;
            dot.Peak = (int)Math.Round(255 * share);
            Vector2D p = spot.PositionPx;
            if (!_mapping!.TryMap(p + new Vector2D(1, 0), out Vector2D right) || !_mapping.TryMap(p + new Vector2D(0, 1), out Vector2D below))
                right = below = at;
            Vector2D x = right - at, y = below - at;
            Covariance2D carried = spot.CovariancePx.Transform(x.X, y.X, x.Y, y.Y);
            double doubt = _mapping.SigmaPx * Scale;
            dot.CovariancePx = new Covariance2D(carried.XX + doubt * doubt, carried.XY, carried.YY + doubt * doubt);
            dot.AreaPx = (int)Math.Round(spot.Area * Math.Abs(Vector2D.Cross(x, y)));
        }

        private static void Place(in Spot spot, int peak, ref Dot dot)
        {
            dot.PositionPx = spot.PositionPx;
            dot.CovariancePx = spot.CovariancePx;
            dot.Peak = peak;
            dot.AreaPx = spot.Area;
        }

        private void AddFlashes(Image color, int confirmed, Detections detections)
        {
            (_wrong, _wrongBefore) = (_wrongBefore, _wrong);
            _wrongBeforeCount = _wrongCount;
            _wrongCount = 0;
            foreach (Dot flash in _found.Dots)
            {
                Dot dot = flash;
                if (IsNear(dot.PositionPx, detections.Dots.Slice(0, confirmed)))
                    continue;
                LightHue hue = dot.Color == LaserColor.Unknown ? _probe.Look(color, dot.PositionPx, 4 * Scale) : LightHue.Unknown;
                bool isWrong = dot.Color == LaserColor.Red || hue == LightHue.White || hue == LightHue.Other;

                // A streak may be red in its first frame, and too white to tell or the complement of what it left behind in the next.
                isWrong |= WasWrong(dot.PositionPx);
                if (isWrong)
                {
                    // A green light beside it must be able to come out of this a frame later.
                    if (_wrongCount < MaxDots && dot.Color != LaserColor.Green)
                        _wrong[_wrongCount++] = dot.PositionPx;
                    double share = dot.Color == LaserColor.Red ? -1 : _probe.GreenShare;
                    detections.Reject(new RejectedCandidate { PositionPx = dot.PositionPx, Reason = RejectionReason.WrongColor, Value = share, Limit = _settings.MinGreenShare });
                    continue;
                }

                if (hue == LightHue.Green)
                    dot.Color = LaserColor.Green;
                detections.Add(dot);
            }
        }

        /// <summary>A light of the wrong colour was here in the frame before.</summary>
        private bool WasWrong(Vector2D at)
        {
            for (int i = 0; i < _wrongBeforeCount; i++)
            {
                if ((_wrongBefore[i] - at).Length <= LinkPx * Scale)
                    return true;
            }

            return false;
        }

        private void AddResting(Image color, Detections detections)
        {
            _resting.Update(color);
            int others = detections.Dots.Length;
            foreach (RestingDot resting in _resting.Dots)
            {
                if (resting.Frames < _settings.RestFrames || IsNear(resting.PositionPx, detections.Dots.Slice(0, others)))
                    continue;
                double outside = _mask.SignedDistancePx(resting.PositionPx);
                var dot = new Dot { IsConclusive = true, Color = LaserColor.Green };
                Place(resting.Spot, resting.Peak, ref dot);
                RejectedCandidate verdict = outside > 0
                    ? new RejectedCandidate { Reason = RejectionReason.OutsideScreen, Value = outside }
                    : Add(ref dot, Math.Min(1, resting.RelativeRise), resting.Spot.RingShare, detections);
                verdict.PositionPx = resting.PositionPx;
                if (verdict.Reason != RejectionReason.None)
                    detections.Reject(verdict);
            }
        }

        private RejectedCandidate Add(ref Dot dot, double peak, double ringShare, Detections detections)
        {
            var center = new Vector2D((_width - 1) * 0.5, (_height - 1) * 0.5);
            double away = (dot.PositionPx - center).Length / Math.Max(1, center.Length);
            double moved = double.PositiveInfinity;
            for (int i = 0; i < _lastCount; i++)
                moved = Math.Min(moved, (_last[i] - dot.PositionPx).Length);
            double link = LinkPx * Scale;
            dot.IsOnset = moved > link;
            dot.Factors = new ConfidenceFactors(
                0.4 * Math.Min(1, peak), 0.3 * (1 - ringShare), 0.2 * Math.Max(0, 1 - away), dot.IsOnset ? 0.1 : 0.1 * (1 - moved / link));
            dot.Confidence = Math.Min(1, dot.Factors.Sum);
            if (dot.Confidence < _settings.MinConfidence)
                return new RejectedCandidate { Reason = RejectionReason.LowConfidence, Value = dot.Confidence, Limit = _settings.MinConfidence };
            detections.Add(dot);
            return default;
        }

        private bool IsNear(Vector2D at, ReadOnlySpan<Dot> dots) => NearestPx(at, dots) <= _settings.MatchRadiusPx * Scale;

        private static double NearestPx(Vector2D at, ReadOnlySpan<Dot> dots)
        {
            double nearest = double.PositiveInfinity;
            foreach (Dot dot in dots)
                nearest = Math.Min(nearest, (dot.PositionPx - at).Length);
            return nearest;
        }
    }
}
