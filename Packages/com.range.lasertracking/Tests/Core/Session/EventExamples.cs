using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands;

namespace LaserTracking.Session
{
    /// <summary>Hand-made events that tests write, read and draw.</summary>
    internal static class EventExamples
    {
        public static SessionHeader Header(long? seed = null) => new SessionHeader("0.1.0",
            new[] { new SessionInput("range.mkv", "ab12"), new SessionInput("hand.mkv", null) }, "screen.json", "shots", seed);

        /// <summary>The shot of contract.md, every field filled.</summary>
        public static ShotEvent FullShot()
        {
            ShotEvent e = PlainShot(7, 13733333);
            e.Shot.FrameIndex = 412;
            e.Shot.FirstFrameIndex = 411;
            e.Shot.LastFrameIndex = 413;
            e.HasScreenPosition = true;
            e.ScreenM = new Vector2D(1.204, 0.871);
            e.ScreenCovarianceMm2 = new Covariance2D(1.9, 0.1, 2.3);
            e.Shooter = 2;
            e.ShooterProbability = 0.97;
            e.Hand = HandSide.Right;
            e.HasMuzzle = true;
            e.MuzzleM = new Vector3D(1.1, 1.3, -2.75);
            e.Direction = new Vector3D(0.0367, -0.1515, 0.98777);
            e.PairDeltaUs = -8300;
            e.HasHit = true;
            e.Hit = new ScoredHit
            {
                Target = "Popper 3",
                Zone = "A",
                Points = 5,
                Score = 4.41,
                PointM = new Vector3D(0.5, 1.25, 7.2),
                LocalPointM = new Vector2D(0.031, -0.02),
                DistanceM = 7.2,
                ZoneProbability = 0.93,
            };
            return e;
        }

        /// <summary>A shot without calibration, hand or hit.</summary>
        public static ShotEvent PlainShot(int id, long timeUs)
        {
            ShotEvent e = default;
            e.Shot.Id = id;
            e.Shot.FrameIndex = e.Shot.FirstFrameIndex = e.Shot.LastFrameIndex = id;
            e.Shot.TimeUs = timeUs;
            e.Shot.TimeSigmaUs = 16667;
            e.Shot.Dot.PositionPx = new Vector2D(301.42, 288.1);
            e.Shot.Dot.CovariancePx = new Covariance2D(0.0121, 0.0004, 0.0121);
            e.Shot.Dot.Peak = 255;
            e.Shot.Dot.AreaPx = 31;
            e.Shot.Dot.Color = LaserColor.Green;
            e.Shot.Dot.Confidence = 0.91;
            e.Shot.Dot.Factors = new ConfidenceFactors(0.38, 0.27, 0.17, 0.09);
            e.Shot.Dot.StreakPx = new Vector2D(3.5, -1.25);
            return e;
        }

        public static DotEvent Dot(int frame, long timeUs)
        {
            DotEvent e = default;
            e.FrameIndex = frame;
            e.TimeUs = timeUs;
            e.TrackId = 3;
            e.Dot = PlainShot(1, timeUs).Shot.Dot;
            e.Shooter = 1;
            return e;
        }

        public static HandEvent Hand(int frame, long timeUs)
        {
            HandEvent e = default;
            e.FrameIndex = frame;
            e.TimeUs = timeUs;
            e.TrackId = 2;
            e.Side = HandSide.Left;
            e.PalmM = new Vector3D(1, 1.25, -2.5);
            e.PalmSigmaM = 0.0123;
            e.MuzzleM = new Vector3D(1.1, 1.2, -2.3);
            e.DepthSource = DepthSource.Bridged;
            return e;
        }

        public static RejectedEvent Rejected(int frame, long timeUs)
        {
            RejectedEvent e = default;
            e.FrameIndex = frame;
            e.TimeUs = timeUs;
            e.Candidate.PositionPx = new Vector2D(12.5, 40);
            e.Candidate.Reason = RejectionReason.NotIsolated;
            e.Candidate.Value = 0.31;
            e.Candidate.Limit = 0.2;
            return e;
        }

        public static HealthEvent Health(int frame, long timeUs)
        {
            HealthEvent e = default;
            e.FrameIndex = frame;
            e.TimeUs = timeUs;
            e.Kind = HealthKind.FrameGap;
            e.Value = 2;
            e.Text = "two frames are missing: check the USB cable";
            return e;
        }

        public static SessionEnd End(double secondsWall = 1.25)
        {
            SessionEnd e = default;
            e.Frames = 450;
            e.Dropped = 2;
            e.SecondsMedia = 15.0005;
            e.SecondsWall = secondsWall;
            e.StartTimeUs = 33333;
            return e;
        }
    }
}
