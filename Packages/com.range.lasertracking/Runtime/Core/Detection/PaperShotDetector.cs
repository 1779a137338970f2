using System;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Detection
{
    /// <summary>
    /// The published algorithm, step for step: running-mean background, decaying spike map, green excess, the top half per cent of
    /// their weighted sum inside the screen, the best candidate of the frame accepted by a confidence of four factors. It stays for
    /// comparison; its weaknesses (saturated cores, moving pictures, one dot only) are the publication's.
    /// </summary>
    public sealed unsafe class PaperShotDetector : IShotDetector
    {
        private const int HistogramBins = 4096;
        private readonly PaperDetectorSettings _settings;
        private readonly PaperPlanes _planes;
        private readonly ScreenMask _mask = new ScreenMask();
        private readonly int[] _histogram = new int[4 * HistogramBins];
        private Vector2D _lastPx;
        private bool _hasLast;

        /// <param name="settings">Published defaults when absent. Copied.</param>
        /// <param name="kernels">What runs the heavy kernels; this thread when absent.</param>
        /// <exception cref="ArgumentException">A setting is outside its range.</exception>
        public PaperShotDetector(PaperDetectorSettings? settings = null, KernelRunner? kernels = null)
        {
            _settings = settings?.Clone() ?? new PaperDetectorSettings();
            _settings.Validate();
            _planes = new PaperPlanes(_settings, kernels ?? KernelRunner.Plain);
        }

        public string Name => "paper";

        /// <summary>Least score of a candidate in the last frame, levels.</summary>
        internal float Threshold { get; private set; }

        public void SetScreenPolygon(Vector2D[] cornersPx) => _mask.Set(cornersPx);

        public void Reset()
        {
            _planes.Reset();
            _hasLast = false;
        }

        public void Process(Frame frame, Detections detections)
        {
            Image image = frame.Color;
            detections.Begin(frame.Index, image.IsPresent ? image.TimeUs : frame.TimeUs);
            if (!image.IsPresent || !PixelRow.CanRead(image.Format))
                return;
            detections.ImageWidthPx = image.Width;
            detections.ImageHeightPx = image.Height;
            if (!_planes.Update(image))
                return;
            Threshold = PercentileScore();
            int best = BestCandidate(Threshold, out int outside);
            if (outside >= 0)
            {
                Vector2D at = ToSource(outside % _planes.Width, outside / _planes.Width);
                Reject(detections, at, RejectionReason.OutsideScreen, _mask.SignedDistancePx(at), 0);
            }

            if (best >= 0)
                Judge(best, detections);
            else
                _hasLast = false;
        }

        /// <summary>
        /// The score that only the top share of the frame reaches, from a histogram (one bin is a sixteenth of a level). It follows the
        /// scene's intensity, as published, by being a share of the frame and no fixed level: twice the light, twice the threshold.
        /// </summary>
        private float PercentileScore()
        {
            Array.Clear(_histogram, 0, _histogram.Length);
            float[] score = _planes.Score;
            fixed (float* s = score)
            fixed (int* bins = _histogram)
            {
                // Most pixels fall into a few bins: four tables spare each count the wait for the one before.
                int i = 0;
                for (; i + 4 <= score.Length; i += 4)
                {
                    bins[Math.Min(HistogramBins - 1, (int)(s[i] * 16))]++;
                    bins[HistogramBins + Math.Min(HistogramBins - 1, (int)(s[i + 1] * 16))]++;
                    bins[2 * HistogramBins + Math.Min(HistogramBins - 1, (int)(s[i + 2] * 16))]++;
                    bins[3 * HistogramBins + Math.Min(HistogramBins - 1, (int)(s[i + 3] * 16))]++;
                }

                for (; i < score.Length; i++)
                    bins[Math.Min(HistogramBins - 1, (int)(s[i] * 16))]++;
            }

            long allowed = (long)(_settings.TopShare * score.Length);
            int bin = HistogramBins - 1;
            for (long above = 0; bin > 0; bin--)
            {
                above += _histogram[bin] + _histogram[HistogramBins + bin] + _histogram[2 * HistogramBins + bin] + _histogram[3 * HistogramBins + bin];
                if (above >= allowed)
                    break;
            }

            return bin / 16f;
        }

        /// <summary>The candidate pixel of highest score inside the screen; also the best one outside when it beats all inside.</summary>
        private int BestCandidate(float threshold, out int outside)
        {
            float minExcess = (float)_settings.MinGreenExcess;
            float bestScore = -1, outsideScore = -1;
            int best = -1, count = _planes.Score.Length;
            outside = -1;
            fixed (float* score = _planes.Score, excess = _planes.Excess)
            {
                for (int i = 0; ; i++)
                {
                    i = PaperKernel.FindCandidate(score, excess, i, count, threshold, minExcess, bestScore, _settings.UseVectors);
                    if (i == count)
                        break;
                    if (!_mask.IsWholePicture && _mask.SignedDistancePx(ToSource(i % _planes.Width, i / _planes.Width)) > 0)
                    {
                        if (score[i] > outsideScore)
                        {
                            outsideScore = score[i];
                            outside = i;
                        }

                        continue;
                    }

                    best = i;
                    bestScore = score[i];
                }
            }

            if (outsideScore <= bestScore)
                outside = -1;
            return best;
        }

        private void Judge(int best, Detections detections)
        {
            int w = _planes.Width, h = _planes.Height, r = _settings.WindowRadiusPx;
            int px = best % w, py = best / w;
            float[] intensity = _planes.Intensity;
            float[] score = _planes.Score;
            double half = score[best] * 0.5, sum = 0, sumX = 0, sumY = 0, levels = 0;
            float peak = 0;
            int area = 0, count = 0;
            for (int y = Math.Max(0, py - r); y <= Math.Min(h - 1, py + r); y++)
            {
                for (int x = Math.Max(0, px - r); x <= Math.Min(w - 1, px + r); x++)
                {
                    int i = y * w + x;
                    levels += intensity[i];
                    count++;
                    double weight = score[i] - half;
                    if (weight < 0)
                        continue;
                    area++;
                    peak = Math.Max(peak, intensity[i]);
                    sum += weight;
                    sumX += weight * x;
                    sumY += weight * y;
                }
            }

            double cx = sum > 0 ? sumX / sum : px, cy = sum > 0 ? sumY / sum : py;
            Vector2D position = ToSource(cx, cy);
            double contrast = Math.Max(0, peak - levels / count) / 255;
            double fromCenter = new Vector2D(cx - (w - 1) * 0.5, cy - (h - 1) * 0.5).Length / Math.Max(1, 0.5 * Math.Sqrt(w * (double)w + h * (double)h));
            var reduced = new Vector2D(cx, cy);
            double moved = _hasLast ? (reduced - _lastPx).Length : 0;
            var factors = new ConfidenceFactors(
                _settings.PeakWeight * peak / 255,
                _settings.ContrastWeight * contrast,
                _settings.CenterWeight * Math.Max(0, 1 - fromCenter),
                _settings.StabilityWeight * Math.Max(0, 1 - moved / _settings.StabilityRangePx));
            if (factors.Sum < _settings.MinConfidence)
            {
                _hasLast = false;
                Reject(detections, position, RejectionReason.LowConfidence, factors.Sum, _settings.MinConfidence);
                return;
            }

            var dot = new Dot
            {
                PositionPx = position,
                CovariancePx = Covariance2D.Isotropic(0.5 * Math.Sqrt(_planes.ScaleX * _planes.ScaleY)),
                Peak = (int)Math.Round(peak),
                AreaPx = (int)Math.Round(area * _planes.ScaleX * _planes.ScaleY),
                Color = LaserColor.Green,
                Confidence = Math.Min(1, factors.Sum),
                Factors = factors,
                IsConclusive = true,
                IsOnset = !_hasLast || moved > r,
            };
            detections.Add(dot);
            _lastPx = reduced;
            _hasLast = true;
        }

        private Vector2D ToSource(double x, double y) =>
            new Vector2D((x + 0.5) * _planes.ScaleX - 0.5, (y + 0.5) * _planes.ScaleY - 0.5);

        private static void Reject(Detections detections, Vector2D at, RejectionReason reason, double value, double limit) =>
            detections.Reject(new RejectedCandidate { PositionPx = at, Reason = reason, Value = value, Limit = limit });
    }
}
