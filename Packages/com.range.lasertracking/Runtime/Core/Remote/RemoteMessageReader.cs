using System;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Session;

namespace LaserTracking.Remote
{
    /// <summary>
    /// Reads one message: our own (with "v") or the published one (without). Tolerant to unknown fields, strict about everything
    /// that is used. Nothing a stranger sends becomes an object. Documentation~/remote.md describes both.
    /// </summary>
    internal static class RemoteMessageReader
    {
        private const int MaximumDepth = 8;
        private const long LargestInteger = 1L << 53; // what JSON's readers in every language can hold
        private const double MostPx = 1e5;
        private const double MostM = 100;
        private const double MostMm = 1e5;
        private const double MostTimestampS = 1e11;
        private const double UnitTolerance = 0.05;

        /// <param name="text">A packet without its signature.</param>
        /// <param name="message">Only complete when None is returned.</param>
        public static RemoteDrop Read(ReadOnlySpan<byte> text, out RemoteMessage message)
        {
            message = default;
            if (!Utf8JsonText.IsUtf8(text))
                return RemoteDrop.NotUtf8;
            if (!Utf8JsonText.IsObject(text, MaximumDepth))
                return RemoteDrop.NotJson;
            var fields = new MessageFields(text, stackalloc int[MessageFields.Room]);
            bool isOurs = fields.Has("v");
            ReadHead(ref fields, isOurs, ref message);
            if (isOurs)
                ReadOurs(ref fields, ref message);
            else
                ReadPublished(ref fields, ref message);
            return fields.Problem;
        }

        private static void ReadHead(ref MessageFields fields, bool isOurs, ref RemoteMessage message)
        {
            message.HasHead = isOurs || fields.Has("stream") || fields.Has("counter") || fields.Has("sent_us");
            if (!message.HasHead)
                return;
            message.Stream = fields.Integer("stream", 1, LargestInteger);
            message.Counter = fields.Integer("counter", 1, LargestInteger);
            message.SentUs = fields.Integer("sent_us", 0, LargestInteger);
        }

        private static void ReadOurs(ref MessageFields fields, ref RemoteMessage message)
        {
            if (fields.Integer("v", 0, LargestInteger) != 1)
                fields.Refuse(RemoteDrop.WrongField);
            ReadOnlySpan<byte> type = fields.Text("type");
            message.IsShot = Utf8JsonCursor.Is(type, "shot");
            message.IsPose = Utf8JsonCursor.Is(type, "hand");
            if (message.IsShot)
                ReadShot(ref fields, ref message.Shot.Event);
            else if (message.IsPose)
                ReadHand(ref fields, ref message.Pose);
            else
                fields.Refuse(type.Length == 0 ? RemoteDrop.WrongField : RemoteDrop.UnknownType);
            message.Shot.Aim = RemotePose.Unknown;
        }

        private static void ReadShot(ref MessageFields fields, ref ShotEvent e)
        {
            e.Shot.Id = (int)fields.Integer("id", 1, int.MaxValue);
            e.Shot.TimeUs = fields.Integer("time_us", -LargestInteger, LargestInteger);
            e.Shot.TimeSigmaUs = fields.Integer("time_sigma_us", 0, LargestInteger, 0);
            e.Shot.FrameIndex = (int)fields.Integer("frame", 0, int.MaxValue, 0);
            e.Shot.FirstFrameIndex = (int)fields.Integer("first_frame", 0, int.MaxValue, e.Shot.FrameIndex);
            e.Shot.LastFrameIndex = (int)fields.Integer("last_frame", 0, int.MaxValue, e.Shot.FrameIndex);
            ReadDot(ref fields, ref e.Shot.Dot);
            e.ScreenM = fields.Vector2("screen_m", MostM);
            e.HasScreenPosition = e.ScreenM.IsFinite;
            e.ScreenCovarianceMm2 = Covariance(ref fields, "screen_cov_mm2");
            if (!e.HasScreenPosition && !e.Shot.Dot.PositionPx.IsFinite)
                fields.Refuse(RemoteDrop.WrongField);
            e.Shooter = (int)fields.Integer("shooter", 1, 10000, 0);
            e.ShooterProbability = e.Shooter > 0 ? fields.Number("shooter_p", 0, 1, 0) : 0;
            e.Hand = Hand(ref fields);
            e.MuzzleM = fields.Vector3("muzzle_m", MostM);
            e.Direction = Direction(ref fields);
            e.HasMuzzle = e.MuzzleM.IsFinite && e.Direction.IsFinite;
            e.PairDeltaUs = fields.Integer("pair_dt_us", -LargestInteger, LargestInteger, 0);
        }

        private static void ReadDot(ref MessageFields fields, ref Dot dot)
        {
            dot.PositionPx = fields.Has("x_px") || fields.Has("y_px")
                ? new Vector2D(fields.Number("x_px", -MostPx, MostPx), fields.Number("y_px", -MostPx, MostPx))
                : new Vector2D(double.NaN, double.NaN);
            dot.CovariancePx = Covariance(ref fields, "cov_px");
            dot.Peak = (int)fields.Integer("peak", 0, 255, 0);
            dot.AreaPx = (int)fields.Integer("area_px", 0, int.MaxValue, 0);
            dot.Confidence = fields.Number("confidence", 0, 1);
            if (fields.Has("streak_px"))
                dot.StreakPx = fields.Vector2("streak_px", MostPx);
            if (!fields.Has("color"))
                return;
            ReadOnlySpan<byte> color = fields.Text("color");
            for (LaserColor known = LaserColor.Unknown; known <= LaserColor.Infrared; known++)
            {
                if (Utf8JsonCursor.Is(color, EventWords.Of(known)))
                {
                    dot.Color = known;
                    return;
                }
            }

            fields.Refuse(RemoteDrop.WrongField);
        }

        private static void ReadHand(ref MessageFields fields, ref RemotePose pose)
        {
            pose = RemotePose.Unknown;
            pose.Space = RemoteSpace.ScreenM;
            pose.TimeUs = fields.Integer("time_us", -LargestInteger, LargestInteger);
            pose.TrackId = (int)fields.Integer("track", 0, int.MaxValue, 0);
            pose.Hand = Hand(ref fields);
            pose.Palm = fields.Vector3("palm_m", MostM);
            pose.PalmSigmaM = fields.Number("palm_sigma_m", 0, MostM, 0);
            pose.Muzzle = fields.Vector3("muzzle_m", MostM);
            pose.Direction = Direction(ref fields);
            pose.Confidence = fields.Number("confidence", 0, 1, 1);
            if (!pose.Palm.IsFinite && !pose.Muzzle.IsFinite)
                fields.Refuse(RemoteDrop.WrongField);
        }

        /// <summary>v = target − muzzle, direction = v / |v|, unless the message brings its direction itself.</summary>
        private static void ReadPublished(ref MessageFields fields, ref RemoteMessage message)
        {
            RemotePose pose = RemotePose.Unknown;
            pose.Space = RemoteSpace.CameraMm;
            pose.TimeUs = (long)(fields.Number("timestamp", 0, MostTimestampS) * 1e6);
            pose.Muzzle = fields.Vector3("muzzle", MostMm);
            pose.Target = fields.Vector3("target", MostMm);
            pose.Direction = Direction(ref fields);
            pose.Confidence = fields.Number("confidence", 0, 1, 1);
            if (!pose.Direction.IsFinite && pose.Muzzle.IsFinite && pose.Target.IsFinite)
            {
                pose.Direction = (pose.Target - pose.Muzzle).Normalized;
                if (pose.Direction.LengthSquared == 0)
                    fields.Refuse(RemoteDrop.OutOfRange);
            }

            if (!pose.Target.IsFinite && !(pose.Muzzle.IsFinite && pose.Direction.IsFinite))
                fields.Refuse(RemoteDrop.WrongField);
            ReadOnlySpan<byte> shot = fields.Value("shot");
            message.IsShot = Utf8JsonCursor.Is(shot, "true");
            if (shot.Length > 0 && !message.IsShot && !Utf8JsonCursor.Is(shot, "false"))
                fields.Refuse(RemoteDrop.WrongField);
            message.IsPose = true;
            message.Pose = pose;
            message.Shot.Aim = pose;
            message.Shot.Event.Shot.TimeUs = pose.TimeUs;
            message.Shot.Event.Shot.Dot.Confidence = pose.Confidence;
        }

        /// <summary>A vector of length one, as nearly as rounding lets it be.</summary>
        private static Vector3D Direction(ref MessageFields fields)
        {
            Vector3D direction = fields.Vector3("direction", 1 + UnitTolerance);
            if (!direction.IsFinite)
                return direction;
            if (Math.Abs(direction.Length - 1) > UnitTolerance)
                fields.Refuse(RemoteDrop.OutOfRange);
            return direction.Normalized;
        }

        private static Covariance2D Covariance(ref MessageFields fields, string name)
        {
            Vector3D n = fields.Vector3(name, 1e8);
            // Rounded to decimals, a thin ellipse may come out a little beyond what a covariance can be.
            if (n.X < 0 || n.Z < 0 || n.Y * n.Y > n.X * n.Z * 1.01 + 1e-3)
                fields.Refuse(RemoteDrop.OutOfRange);
            return new Covariance2D(n.X, n.Y, n.Z);
        }

        private static HandSide Hand(ref MessageFields fields)
        {
            if (!fields.Has("hand"))
                return HandSide.Unknown;
            ReadOnlySpan<byte> word = fields.Text("hand");
            if (Utf8JsonCursor.Is(word, "left"))
                return HandSide.Left;
            if (!Utf8JsonCursor.Is(word, "right"))
                fields.Refuse(RemoteDrop.WrongField);
            return HandSide.Right;
        }
    }
}
