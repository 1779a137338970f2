using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Session;

namespace LaserTracking.Health
{
    /// <summary>
    /// Watches camera 0's picture for what makes a detector miss: too bright, too dark, flicker, exposure or colours that change by
    /// themselves, a bumped camera, a frozen picture. Each is said once when it begins, with the one thing to do. Reads a few
    /// thousand pixels of the raw frame; no allocation per frame once warm; one thread at a time.
    /// </summary>
    public sealed class PictureMonitor
    {
        private readonly HealthWriter _health;
        private readonly SampleGrid _grid = new SampleGrid();
        private readonly ScreenMask _screen = new ScreenMask();
        private readonly BrightnessCheck _brightness;
        private readonly FrozenCheck _frozen;
        private readonly ExposureCheck _exposure;
        private readonly FlickerCheck _flicker;
        private readonly MotionCheck _motion;

        /// <param name="sink">Receives what is noticed.</param>
        /// <param name="settings">Defaults when absent. Copied.</param>
        /// <param name="limits">What the detector in use needs; defaults when absent.</param>
        /// <exception cref="System.ArgumentException">A setting is outside its range.</exception>
        public PictureMonitor(IEventSink sink, PictureMonitorSettings? settings = null, ShotDetectorSettings? limits = null)
        {
            settings = settings?.Clone() ?? new PictureMonitorSettings();
            settings.Validate();
            limits ??= new ShotDetectorSettings();
            limits.Validate();
            _health = new HealthWriter(sink);
            _brightness = new BrightnessCheck(settings, limits);
            _frozen = new FrozenCheck(settings);
            _exposure = new ExposureCheck(settings);
            _flicker = new FlickerCheck(settings);
            _motion = new MotionCheck(settings);
        }

        /// <summary>The screen's outline in image pixels; without corners the whole picture.</summary>
        public void SetScreenPolygon(Vector2D[] cornersPx)
        {
            _screen.Set(cornersPx);
            _motion.SetScreen(cornersPx);
            _grid.Reset();
        }

        /// <summary>Looks at the next frame; one without a picture is passed over.</summary>
        public void Process(Frame frame)
        {
            if (!frame.Color.IsPresent || !PixelRow.CanRead(frame.Color.Format))
                return;
            _health.Begin(frame.Index, frame.TimeUs);
            _grid.Read(frame.Color, _screen);
            if (_grid.FrameCount == 1)
                _motion.Reset();
            _brightness.Update(_grid, _health);
            _frozen.Update(_grid, _health);
            _exposure.Update(_grid, _health);
            _flicker.Update(_grid, _health);
            _motion.Update(frame.Color, _health);
        }
    }
}
