using System;
using LaserTracking.Detection;
using LaserTracking.Geometry;

namespace LaserTracking.Tracking
{
    /// <summary>
    /// From what the first frame shows of a flash to when and where its light began. The light may have begun at any moment since the
    /// exposure before ended, and the dot has moved since: unseen motion is part of the place's uncertainty.
    /// </summary>
    internal sealed class LightOrigin
    {
        /// <summary>Radius of the ellipse with 90 % of a plane normal distribution, in standard deviations.</summary>
        private const double Radius90 = 2.1459660262893472;

        /// <summary>Share of the frame interval that an unknown shutter is taken to be open.</summary>
        private const double UsualOpenShare = 0.5;

        /// <summary>No weapon sweeps its dot faster, px at 640 per second: 4 m/s on a screen 3.2 m wide.</summary>
        private const double MaxSweepPxPerS = 800;

        /// <summary>Of shorter streaks, px at 640, the ends are no surer than the middle: a faint first light is ragged.</summary>
        private const double MinShiftedPx = 8;

        /// <summary>Least way along the streak until the next frame, through its length.</summary>
        private const double MinWayShare = 0.6;

        /// <summary>Error of a streak's end through its length.</summary>
        private const double EndError = 0.2;

        /// <summary>Standard deviation across the way through its reach: hands do not draw straight lines.</summary>
        private const double Swerve = 0.1;

        private readonly CameraTimingSettings _timing;
        private readonly double _handSpeedPxPerS;

        public LightOrigin(CameraTimingSettings timing, double handSpeedPxPerS)
        {
            _timing = timing;
            _handSpeedPxPerS = handSpeedPxPerS;
        }

        /// <summary>Mid-exposure of the row in which the dot lies, µs on the camera's clock.</summary>
        public long RowTimeUs(Detections frame, in Dot dot)
        {
            double rows = dot.PositionPx.Y - (frame.ImageHeightPx - 1) * 0.5;
            return frame.TimeUs + (frame.ImageHeightPx > 0 ? (long)Math.Round(rows * _timing.RowUs) : 0);
        }

        /// <summary>
        /// Root mean square distance of the light's begin from mid-exposure, µs. It began between the end of the exposure before and
        /// the end of this one, at any moment alike: spread over T, its middle (T − E) / 2 early. T² / 6 for any E alike.
        /// </summary>
        public long SigmaUs(long intervalUs)
        {
            double interval = intervalUs;
            if (_timing.ExposureUs <= 0)
                return (long)Math.Round(interval / Math.Sqrt(6));
            double early = Math.Max(0, interval - _timing.ExposureUs) / 2;
            return (long)Math.Round(Math.Sqrt(interval * interval / 12 + early * early));
        }

        /// <summary>Moves the shot's dot to where the light began as far as that is known, and widens its covariance by the rest.</summary>
        /// <param name="dot">The dot of the first frame.</param>
        /// <param name="wayPx">Where it went in later frames; zero: not known.</param>
        /// <param name="intervalUs">Time since the frame before.</param>
        /// <param name="scale">Pixels per pixel of a picture 640 wide.</param>
        public void Place(ref Dot dot, Vector2D wayPx, long intervalUs, double scale)
        {
            double intervalS = Math.Max(1, intervalUs) * 1e-6;
            double openS = _timing.ExposureUs > 0 ? Math.Min(intervalS, _timing.ExposureUs * 1e-6) : UsualOpenShare * intervalS;
            double closedS = intervalS - openS;

            // What no shape shows: half of the light lies behind its middle, and before it the shutter may have been closed.
            double steady = _handSpeedPxPerS * scale * Math.Sqrt(openS * openS / 12 + closedS * intervalS / 3);
            Covariance2D covariance = Add(dot.CovariancePx, new Vector2D(1, 0), steady, steady);
            Vector2D way = DotStreak.From(dot.ShapePx, out _);
            double length = way.Length;
            if (length > 0)
            {
                // In nine of ten cases the light began no farther before the end than this.
                double speed = Math.Min(length / openS, MaxSweepPxPerS * scale);
                double before = speed * Math.Max(0, closedS - 0.1 * intervalS);
                double reach = length / 2 + before;
                if (dot.StreakPx.LengthSquared > 0 && wayPx.LengthSquared > 0)
                {
                    dot.StreakPx = Vector2D.Dot(way, wayPx) < 0 ? way * -1 : way;

                    // A dot that smears over a length in an exposure goes on by as much; what only spills over does not.
                    if (length >= MinShiftedPx * scale && Math.Abs(Vector2D.Dot(way, wayPx)) >= MinWayShare * length * length)
                    {
                        dot.PositionPx -= dot.StreakPx * 0.5;
                        reach = before + EndError * length;
                    }
                }

                covariance = Add(covariance, way * (1 / length), reach / Radius90, Swerve * reach);
            }

            dot.CovariancePx = covariance;
        }

        private static Covariance2D Add(in Covariance2D c, Vector2D along, double sigmaAlong, double sigmaAcross)
        {
            double a = sigmaAlong * sigmaAlong, b = sigmaAcross * sigmaAcross;
            return new Covariance2D(c.XX + a * along.X * along.X + b * along.Y * along.Y, c.XY + (a - b) * along.X * along.Y,
                c.YY + a * along.Y * along.Y + b * along.X * along.X);
        }
    }
}
