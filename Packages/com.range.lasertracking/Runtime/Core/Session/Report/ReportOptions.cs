using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Scoring;

namespace LaserTracking.Session
{
    /// <summary>What a report shows besides the session itself. Everything is optional.</summary>
    public sealed class ReportOptions
    {
        public string Title { get; set; } = "Range session";

        /// <summary>Draws the targets as they stood; without it the screen is empty but for the shots.</summary>
        public SceneModel? Scene { get; set; }

        /// <summary>Time on the recording's clock at which the scene's clock shows 0; null: the session's start.</summary>
        public long? SceneZeroTimeUs { get; set; }

        /// <summary>Moment on the scene's clock at which the picture shows moving targets, seconds; null: the first shot.</summary>
        public double? PictureTimeS { get; set; }

        /// <summary>Size of the projected picture, metres, when there is no scene that says it.</summary>
        public Vector2D? ScreenSizeM { get; set; }

        /// <summary>Size of camera 0's picture, for sessions without a screen calibration; null: taken from the shots.</summary>
        public Vector2D? ImageSizePx { get; set; }

        /// <summary>
        /// A PNG file's bytes laid under the shots: what the projector showed, or camera 0's picture for a session without
        /// calibration. Fills the picture.
        /// </summary>
        public byte[]? BackgroundPng { get; set; }

        /// <summary>Names of shooters 1, 2, …; those without one are called "Shooter n".</summary>
        public IReadOnlyList<string> ShooterNames { get; set; } = new string[0];

        /// <summary>One sentence on how points become the score.</summary>
        public string ScoringRule { get; set; } = "the zone's points, times how certain the shot is, times how difficult its distance makes it; penalties count in full.";

        /// <summary>Shows what frames cost. Off by default: it is the only part that differs between two runs.</summary>
        public bool ShowProcessingTimes { get; set; }
    }
}
