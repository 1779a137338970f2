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

            // Half of the light seen lies behind its middle; before, the shutter may have been closed.
            double length = dot.StreakPx.Length;
            if (length <= 0)
            {
                double unseen = _handSpeedPxPerS * scale * Math.Sqrt(openS * openS / 12 + closedS * intervalS / 3);
                dot.CovariancePx = Add(dot.CovariancePx, new Vector2D(1, 0), unseen, unseen);
                return;
            }

            Vector2D along = dot.StreakPx * (1 / length);
            double before = closedS / intervalS <= 0.1 ? 0 : length * closedS / openS * (1 - 0.1 * intervalS / closedS);
            double reach = length / 2 + before;
            if (wayPx.LengthSquared > 0)
            {
                if (Vector2D.Dot(along, wayPx) < 0)
                    along = along * -1;
                dot.StreakPx = along * length;
                dot.PositionPx -= dot.StreakPx * 0.5;
                reach = before + 0.2 * length;
            }

            dot.CovariancePx = Add(dot.CovariancePx, along, reach / Radius90, 0.05 * length);
        }

        private static Covariance2D Add(in Covariance2D c, Vector2D along, double sigmaAlong, double sigmaAcross)
        {
            double a = sigmaAlong * sigmaAlong, b = sigmaAcross * sigmaAcross;
            return new Covariance2D(c.XX + a * along.X * along.X + b * along.Y * along.Y, c.XY + (a - b) * along.X * along.Y,
                c.YY + a * along.Y * along.Y + b * along.X * along.X);
        }
    }
}
