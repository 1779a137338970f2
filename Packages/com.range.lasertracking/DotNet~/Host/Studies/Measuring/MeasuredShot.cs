using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Simulation;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Studies.Measuring
{
    /// <summary>A reported shot, the pulse that it is and that pulse's light in the frame where the shot begins.</summary>
    /// <param name="Range">Name of the simulated range.</param>
    /// <param name="Seen">As the tracker reported it.</param>
    /// <param name="Fired">The truth.</param>
    /// <param name="Light">The truth of the frame in which the shot begins.</param>
    /// <param name="OpenUs">Exposure, µs.</param>
    internal sealed record MeasuredShot(string Range, Shot Seen, TrueShot Fired, TrueDot Light, double OpenUs)
    {
        /// <summary>From where the light began to the reported place, px.</summary>
        public Vector2D ErrorPx => Seen.Dot.PositionPx - Fired.FirstLightPx;

        /// <summary>Begin of the light after the reported time, µs.</summary>
        public double LateUs => Fired.TimeUs - Seen.TimeUs;

        public bool IsStreak => Seen.Dot.StreakPx.LengthSquared > 0;

        public bool IsSaturated => Seen.Dot.Peak >= 252;

        /// <summary>The light began during this exposure.</summary>
        public bool IsPartlyLit => Light.LightUs < 0.98 * OpenUs;

        public bool IsColorUnknown => Seen.Dot.Color == LaserColor.Unknown;

        public bool IsColorRight => Seen.Dot.Color == Fired.Color;
    }
}
