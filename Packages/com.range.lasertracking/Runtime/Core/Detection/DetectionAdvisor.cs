using System;
using LaserTracking.Capture;
using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Says what the dimmest and the shortest flash is that will be caught here. Dots of rising power are drawn into the detector's
    /// working picture all over the screen and put through its own tests, so background, noise, motion and every limit are the
    /// detector's; how much of a flash an exposure sees follows from its length. On the detector's thread, between frames.
    /// </summary>
    public sealed class DetectionAdvisor
    {
        /// <summary>Frames in which the detector learns what is ordinary here: it sees less meanwhile.</summary>
        private const int SettlingFrames = 20;

        /// <summary>The flash by which what to change is judged, ms: the shortest that trainers fire.</summary>
        private const double ShortFlashMs = 5;

        private const double ShortestIntervalUs = 500;
        private const double LongestIntervalUs = 2_000_000;
        private const double UsualIntervalUs = 33_333;

        private readonly ShotDetector _detector;
        private readonly AdvisorSettings _settings;
        private readonly PowerLadder[] _ladders;
        private readonly int[] _reasons = new int[256];
        private ScreenGeometry? _screen;
        private long _firstUs;
        private long _lastUs;
        private int _frames;
        private int _region;

        /// <param name="detector">Learns from the same frames.</param>
        /// <param name="settings">Defaults when absent. Copied.</param>
        /// <param name="screen">Null: the whole picture, as wide as the settings say.</param>
        /// <exception cref="ArgumentException">A setting is outside its range.</exception>
        public DetectionAdvisor(ShotDetector detector, AdvisorSettings? settings = null, ScreenGeometry? screen = null)
        {
            _detector = detector;
            _settings = settings?.Clone() ?? new AdvisorSettings();
            _settings.Validate();
            _screen = screen;
            _ladders = new PowerLadder[_settings.Columns * _settings.Rows];
            for (int i = 0; i < _ladders.Length; i++)
                _ladders[i] = new PowerLadder(_settings.Gamma);
        }

        /// <summary>How often all parts of the screen were looked at.</summary>
        public int Rounds { get; private set; }

        /// <summary>
        /// Takes the frame that the detector processed last, every frame in turn, and tries dots at one place of the screen; costs less
        /// than a millisecond. A round over all parts of the map takes as many frames.
        /// </summary>
        public void Look(Frame frame)
        {
            if (!Note(frame))
                return;
            Try(_detector.Probe, _region);
            _region = (_region + 1) % _ladders.Length;
            if (_region == 0)
                Rounds++;
        }

        /// <summary>As <see cref="Look"/>, at one place in every part of the screen: a whole round, some ten milliseconds.</summary>
        public void LookEverywhere(Frame frame)
        {
            if (!Note(frame))
                return;
            for (int region = 0; region < _ladders.Length; region++)
                Try(_detector.Probe, region);
            Rounds++;
        }

        /// <summary>Only takes note of the frame's time; true when it can be looked at.</summary>
        public bool Note(Frame frame)
        {
            if (_frames == 0)
                _firstUs = frame.TimeUs;
            _frames++;
            _lastUs = frame.TimeUs;
            if (!frame.Color.IsPresent || !_detector.Probe.IsReady || _frames <= SettlingFrames)
                return false;
            _screen ??= WholePicture(frame.Color.Width, frame.Color.Height);
            return true;
        }

        /// <summary>What the looks so far amount to.</summary>
        /// <exception cref="InvalidOperationException">No round was finished yet.</exception>
        public DetectionAdvice Advise()
        {
            if (Rounds == 0)
                throw new InvalidOperationException("the advisor has not looked at every part of the screen yet");
            // A clock that stands still or leaps says nothing about the camera.
            double intervalUs = _frames > 1 ? (_lastUs - _firstUs) / (double)(_frames - 1) : 0;
            if (!(intervalUs >= ShortestIntervalUs && intervalUs <= LongestIntervalUs))
                intervalUs = UsualIntervalUs;
            double exposureUs = _settings.ExposureUs > 0 ? Math.Min(_settings.ExposureUs, intervalUs) : intervalUs / 2;
            var regions = new RegionAdvice[_ladders.Length];
            for (int i = 0; i < regions.Length; i++)
            {
                PowerLadder ladder = _ladders[i];
                double dimmest = ladder.LeastMw(_settings.CaughtShare), rise = 255 * ladder.Rise(dimmest), level = 255 * ladder.Background;
                regions[i] = new RegionAdvice(dimmest, rise, ladder.ShortestMs(_settings.CaughtShare, _settings.PowerMw, exposureUs, intervalUs, _detector.Probe.MaxWaitFrames(intervalUs)), level);
            }

            return new DetectionAdvice(_settings, _ladders, regions, MedianRise, intervalUs, exposureUs, _detector.Probe.MaxWaitFrames(intervalUs), Gain(exposureUs, intervalUs));
        }

        private double MedianRise(double powerMw)
        {
            var rises = new double[_ladders.Length];
            for (int i = 0; i < rises.Length; i++)
                rises[i] = 255 * _ladders[i].Rise(powerMw);
            Array.Sort(rises);
            return rises[rises.Length / 2];
        }

        private ScreenGeometry WholePicture(int width, int height)
        {
            double scale = _settings.PictureWidthM / width;
            return new ScreenGeometry(new Homography(new[] { scale, 0, 0, 0, scale, 0, 0, 0, 1 }), new Vector2D(width * scale, height * scale));
        }

        private void Try(DetectorProbe probe, int region)
        {
            probe.SetGamma(_settings.Gamma);
            double whiteLight = _settings.WhiteLight > 0 ? _settings.WhiteLight : Math.Pow(Math.Max(1, probe.ContentLevel) / 255.0, _settings.Gamma);
            PowerLadder ladder = _ladders[region];

            // Two irrational steps fill a region evenly, whatever the number of places.
            double u = Fraction(0.5 + 0.7548776662466927 * (ladder.Tried + 7 * region)), v = Fraction(0.5 + 0.5698402909980532 * (ladder.Tried + 7 * region));
            Vector2D size = _screen!.ScreenSizeM;
            var screen = new Vector2D((region % _settings.Columns + u) / _settings.Columns * size.X, (region / _settings.Columns + v) / _settings.Rows * size.Y);
            Vector2D image = _screen.ToImagePx(screen);
            _screen.Jacobian(image, out double a, out double b, out double c, out double d);
            double pixelM2 = Math.Abs(a * d - b * c), radius = _settings.DotRadiusMm / 2000;
            double sigma2 = radius * radius / pixelM2 + _settings.BlurPx * _settings.BlurPx + 1.0 / 12;
            double perMw = 1e-3 / pixelM2 / _settings.WhiteWPerM2 * whiteLight / (2 * Math.PI * sigma2)
                * (1 - _settings.HaloShare + 2 * _settings.HaloShare / (_settings.HaloScale * _settings.HaloScale));
            LaserResponse.Of(_settings.Color, out float red, out float green, out float blue);
            ladder.BeginTry(Math.Pow(probe.LevelAt(image) / 255.0, _settings.Gamma), perMw * Math.Max(red, Math.Max(green, blue)));
            for (int step = 0; step < PowerLadder.Steps; step++)
            {
                double power = PowerLadder.PowerMw(step), peak = power * perMw;
                var light = new ProbeLight
                {
                    PositionPx = image,
                    Blue = (float)(peak * blue),
                    Green = (float)(peak * green),
                    Red = (float)(peak * red),
                    SigmaPx = Math.Sqrt(sigma2),
                    HaloShare = _settings.HaloShare,
                    HaloScale = _settings.HaloScale,
                };
                if (probe.Takes(light, out bool isConclusive, out RejectionReason reason))
                    ladder.Take(step, isConclusive);
                else if (power > 0.3 * _settings.PowerMw)
                    _reasons[(int)reason]++;
            }
        }

        private string Gain(double exposureUs, double intervalUs)
        {
            double caught = 0;
            foreach (PowerLadder ladder in _ladders)
                caught += ladder.Caught(_settings.PowerMw, ShortFlashMs * 1000, exposureUs, intervalUs, _detector.Probe.MaxWaitFrames(intervalUs));
            caught /= _ladders.Length;
            double between = FlashTiming.Missed(ShortFlashMs * 1000, exposureUs, intervalUs), unseen = 1 - caught - between;
            if (caught > 0.98)
                return string.Empty;
            if (_settings.ExposureUs > 0 && between >= unseen)
                return FormattableString.Invariant($"{between * 100:F0} % of flashes of {ShortFlashMs:0} ms fall between two exposures: choose the camera's highest frame rate, or an exposure as long as the brightness allows");
            if (unseen < 0.05)
                return string.Empty;
            int worst = 0;
            for (int i = 1; i < _reasons.Length; i++)
            {
                if (_reasons[i] > _reasons[worst])
                    worst = i;
            }

            return Remedy((RejectionReason)worst);
        }

        private string Remedy(RejectionReason reason)
        {
            switch (reason)
            {
                case RejectionReason.MovingSurroundings:
                case RejectionReason.NotIsolated:
                    return "most of what is missed falls on moving parts of the picture: lower the exposure until a dot is brighter than the picture";
                case RejectionReason.TooSmall:
                    return "dots are too small in this picture: choose a higher resolution or zoom in on the screen";
                case RejectionReason.TooLarge:
                    return "dots are too large in this picture: lower the exposure";
                default:
                    bool isBright = _detector.Probe.ContentLevel > 200;
                    bool isNoisy = _detector.Probe.Noise > 2;
                    return isBright ? "the picture leaves a dot little room: lower the exposure"
                        : isNoisy ? "noise hides faint dots: lower the camera's gain"
                        : "dots are faint here: let the screen fill the camera's picture, or use a stronger laser";
            }
        }

        private static double Fraction(double value) => value - Math.Floor(value);
    }
}
