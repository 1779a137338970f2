using System;
using LaserTracking.Detection;
using LaserTracking.Health;
using LaserTracking.Tracking;

namespace LaserTracking.Pipeline
{
    /// <summary>What the pipeline itself decides; each step has settings of its own. Validated when the pipeline is built.</summary>
    public sealed class PipelineSettings
    {
        /// <summary>
        /// Device time of camera 0 at which the scene's clock stood at zero, microseconds; null: the time of the first frame.
        /// </summary>
        public long? SceneTimeZeroUs { get; set; }

        /// <summary>Share of the searched picture, 0…1, above which a frame counts as blind and a health event says so.</summary>
        public double BlindShareLimit { get; set; } = 0.5;

        /// <summary>A gap of more than this many usual frame intervals is reported; above 1.</summary>
        public double FrameGapFactor { get; set; } = 2.5;

        /// <summary>When the picture itself is worth a word.</summary>
        public PictureMonitorSettings Monitor { get; set; } = new PictureMonitorSettings();

        /// <summary>What is said about what can be seen here after the first seconds; null: nothing.</summary>
        public AdvisorSettings? Advisor { get; set; } = new AdvisorSettings();

        /// <summary>Shutter and rolling shutter of camera 0, for the tracker of the usual pipeline.</summary>
        public CameraTimingSettings CameraTiming { get; set; } = new CameraTimingSettings();

        /// <exception cref="ArgumentException">A value is outside its range.</exception>
        public void Validate()
        {
            CameraTiming.Validate();
            if (!(BlindShareLimit >= 0 && BlindShareLimit <= 1))
                throw new ArgumentException("BlindShareLimit must lie in 0…1");
            if (!(FrameGapFactor > 1) || double.IsInfinity(FrameGapFactor))
                throw new ArgumentException("FrameGapFactor must be above 1");
            Monitor.Validate();
            Advisor?.Validate();
        }
    }
}
