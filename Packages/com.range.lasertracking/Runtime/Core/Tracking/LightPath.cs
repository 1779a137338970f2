using System;
using LaserTracking.Detection;
using LaserTracking.Geometry;

namespace LaserTracking.Tracking
{
    /// <summary>
    /// Whether a dot can be the light of a track gone on, and how far it lies from where that would be. A laser keeps its colour, stays
    /// where it was or goes on as it went, and smears as it moves. Lengths in pixels of a picture 640 wide.
    /// </summary>
    internal readonly struct LightPath
    {
        /// <summary>So near it is the same light whatever else speaks against it: a dot's size and what its middle wanders by saturation.</summary>
        private const double OwnPx = 12;

        /// <summary>Between two frames a flash that neither moved nor smears goes no farther; the largest of 110 recorded ways is 13 px.</summary>
        private const double MaxSharpWayPx = 25;

        /// <summary>No swing is faster, even at few frames a second: a quarter of the picture from one frame to the next.</summary>
        public const double MaxWayPx = 160;

        /// <summary>Least smear along a way through its length: the share of the time that a short shutter is open.</summary>
        private const double MinSmearShare = 0.2;

        /// <summary>A swing changes its way from one frame to the next by half of it at most.</summary>
        private const double TurnShare = 0.5;

        private readonly double _radiusPx;
        private readonly double _scale;

        /// <param name="radiusPx">Where a dot without haste is looked for, px at 640.</param>
        /// <param name="scale">Pixels per pixel of a picture 640 wide.</param>
        public LightPath(double radiusPx, double scale)
        {
            _radiusPx = radiusPx;
            _scale = scale;
        }

        /// <summary>Distance from the nearer of the track's last place and where its way leads, px of the picture; infinite when it is other light.</summary>
        /// <param name="track">Seen before this frame.</param>
        /// <param name="dot">Of this frame.</param>
        /// <param name="frameIndex">This frame.</param>
        /// <param name="timeUs">Its time.</param>
        /// <param name="isHeld">The track is a laser held on, which may jerk, or pass behind things.</param>
        public double DistancePx(in DotTrack track, in Dot dot, int frameIndex, long timeUs, bool isHeld)
        {
            // Where it went says nothing of where it comes back after it was hidden.
            bool isFresh = frameIndex - track.LastFrame <= 2;
            Vector2D step = dot.PositionPx - track.LastPx, way = isFresh ? track.VelocityPxPerUs * Math.Max(0, timeUs - track.LastTimeUs) : default;
            double distance = Math.Min(step.Length, (step - way).Length);
            if (distance <= OwnPx * _scale)
                return distance;
            bool isSmeared = isFresh && (IsSmeared(track.LastShapePx, step) || IsSmeared(dot.ShapePx, step));

            // Of weak light that moves over a picture the colour is told wrong now and then.
            bool isOther = !isSmeared && dot.Color != LaserColor.Unknown && track.First.Color != LaserColor.Unknown && dot.Color != track.First.Color;
            if (dot.IsOnset && !isHeld)
                isOther |= frameIndex - track.LastFrame >= 2 || (distance > MaxSharpWayPx * _scale && !isSmeared && way.Length <= OwnPx * _scale);
            double radius = isSmeared ? MaxWayPx * _scale : Math.Max(_radiusPx * _scale, TurnShare * way.Length);
            return isOther || distance > radius ? double.PositiveInfinity : distance;
        }

        private static bool IsSmeared(in Covariance2D shape, Vector2D step) =>
            Math.Abs(Vector2D.Dot(DotStreak.From(shape, out _), step)) >= MinSmearShare * step.LengthSquared;
    }
}
