using System;
using System.Collections.Generic;
using System.Text.Json;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using LaserTracking.Session;

namespace LaserTracking.Host.Events
{
    /// <summary>
    /// Plays events.jsonl back into an <see cref="IEventSink"/>: a recorder for a report, a writer for a copy. Unknown types and fields
    /// are passed over; known fields must be there and of their type. A file without an end line is a session that was interrupted.
    /// </summary>
    internal static class EventReader
    {
        /// <exception cref="InputException">The file cannot be used; the message names line and field.</exception>
        public static void Read(string path, IEventSink sink)
        {
            bool begun = false, ended = false;
            foreach (EventLine line in EventLines.Read(path))
            {
                string type = line.Type;
                if (!begun && type != "header")
                    throw line.Wrong("type", "is \"" + type + "\" but the first line must be the header");
                if (ended || begun && type == "header")
                    throw line.Wrong("type", "is \"" + type + "\" where no such line may stand");
                begun = true;
                if (type == "header")
                    sink.Begin(Header(line));
                else if (type == "end")
                    sink.End(End(line, ref ended));
                else
                    Event(line, type, sink);
            }

            if (!begun)
                throw new InputException(path, "holds no events", "give a file that ./range replay --events wrote");
        }

        private static void Event(EventLine line, string type, IEventSink sink)
        {
            if (type is not ("shot" or "dot" or "hand" or "rejected" or "health"))
                return;
            sink.OnTimePassed(line.Long("time_us"));
            switch (type)
            {
                case "shot":
                    sink.OnShot(Shot(line));
                    break;
                case "dot":
                    sink.OnDot(new DotEvent
                    {
                        FrameIndex = line.Integer("frame"),
                        TimeUs = line.Long("time_us"),
                        TrackId = line.Integer("track"),
                        Shooter = (int)(line.OptionalLong("shooter") ?? 0),
                        Dot = new Dot { PositionPx = Position(line), CovariancePx = Covariance2D.Isotropic(line.Double("sigma_px")), Color = Color(line) },
                    });
                    break;
                case "hand":
                    sink.OnHand(Hand(line));
                    break;
                case "rejected":
                    sink.OnRejected(Rejected(line));
                    break;
                default:
                    sink.OnHealth(Health(line));
                    break;
            }
        }

        private static SessionHeader Header(EventLine line)
        {
            if (line.Integer("v") != 1)
                throw line.Wrong("v", "is a version this program does not know");
            var inputs = new List<SessionInput>();
            if (line.Root.TryGetProperty("inputs", out JsonElement list) && list.ValueKind == JsonValueKind.Array)
            {
                foreach (JsonElement input in list.EnumerateArray())
                {
                    if (input.ValueKind != JsonValueKind.Object)
                        throw line.Wrong("inputs", "holds something that is no object");
                    inputs.Add(new SessionInput(line.OptionalText(input, "path") ?? throw line.Wrong("path", "is missing"), line.OptionalText(input, "sha256")));
                }
            }

            return new SessionHeader(line.Text("version"), inputs, line.OptionalText("calibration"), line.Text("detector"), line.OptionalLong("seed"));
        }

        private static SessionEnd End(EventLine line, ref bool ended)
        {
            ended = true;
            return new SessionEnd
            {
                Frames = line.Integer("frames"),
                Dropped = line.Integer("dropped"),
                SecondsMedia = line.Double("seconds_media"),
                SecondsWall = line.Double("seconds_wall"),
                StartTimeUs = line.OptionalLong("start_us"),
            };
        }

        private static ShotEvent Shot(EventLine line)
        {
            ShotEvent e = default;
            e.Shot.Id = line.Integer("id");
            e.Shot.FrameIndex = line.Integer("frame");
            e.Shot.FirstFrameIndex = line.Integer("first_frame");
            e.Shot.LastFrameIndex = line.Integer("last_frame");
            e.Shot.TimeUs = line.Long("time_us");
            e.Shot.TimeSigmaUs = line.Long("time_sigma_us");
            e.Shot.Dot.PositionPx = Position(line);
            e.Shot.Dot.CovariancePx = Covariance(line, "cov_px");
            e.Shot.Dot.Peak = line.Integer("peak");
            e.Shot.Dot.AreaPx = line.Integer("area_px");
            e.Shot.Dot.Color = Color(line);
            e.Shot.Dot.Confidence = line.Double("confidence");
            if (line.TryObject("factors", out JsonElement factors))
                e.Shot.Dot.Factors = new ConfidenceFactors(line.Double(factors, "peak"), line.Double(factors, "contrast"),
                    line.Double(factors, "center"), line.Double(factors, "stability"));
            e.Shot.Dot.StreakPx = line.Vector2(line.Root, "streak_px");
            e.ScreenM = line.Vector2(line.Root, "screen_m");
            e.HasScreenPosition = e.ScreenM.IsFinite;
            e.ScreenCovarianceMm2 = Covariance(line, "screen_cov_mm2");
            e.Shooter = (int)(line.OptionalLong("shooter") ?? 0);
            e.ShooterProbability = e.Shooter > 0 ? line.Double("shooter_p") : 0;
            e.Hand = Side(line);
            e.MuzzleM = line.Vector3(line.Root, "muzzle_m");
            e.HasMuzzle = e.MuzzleM.IsFinite;
            e.Direction = line.Vector3(line.Root, "direction");
            e.PairDeltaUs = line.OptionalLong("pair_dt_us") ?? 0;
            e.HasHit = line.TryObject("hit", out JsonElement hit);
            if (e.HasHit)
                e.Hit = Hit(line, hit);
            return e;
        }

        private static ScoredHit Hit(EventLine line, JsonElement hit) => new ScoredHit
        {
            Target = line.OptionalText(hit, "target") ?? throw line.Wrong("target", "is missing"),
            Zone = line.OptionalText(hit, "zone") ?? throw line.Wrong("zone", "is missing"),
            Points = line.Integer(hit, "points"),
            PointM = line.Vector3(hit, "point_m"),
            DistanceM = line.Double(hit, "distance_m"),
            ZoneProbability = line.Double(hit, "p_zone"),
            Score = hit.TryGetProperty("score", out _) ? line.Double(hit, "score") : line.Integer(hit, "points"),
            LocalPointM = line.Vector2(hit, "local_m"),
        };

        private static HandEvent Hand(EventLine line)
        {
            if (!EventWords.TryParse(line.Text("depth_source"), out DepthSource source))
                throw line.Wrong("depth_source", "is no word of the format");
            return new HandEvent
            {
                FrameIndex = line.Integer("frame"),
                TimeUs = line.Long("time_us"),
                TrackId = (int)(line.OptionalLong("track") ?? 0),
                Side = Side(line),
                PalmM = line.Vector3(line.Root, "palm_m"),
                PalmSigmaM = line.OptionalDouble("palm_sigma_m") ?? 0,
                MuzzleM = line.Vector3(line.Root, "muzzle_m"),
                DepthSource = source,
            };
        }

        private static RejectedEvent Rejected(EventLine line)
        {
            if (!EventWords.TryParse(line.Text("reason"), out RejectionReason reason))
                throw line.Wrong("reason", "is no word of the format");
            return new RejectedEvent
            {
                FrameIndex = line.Integer("frame"),
                TimeUs = line.Long("time_us"),
                Candidate = new RejectedCandidate { PositionPx = Position(line), Reason = reason, Value = line.Double("value"), Limit = line.Double("limit") },
            };
        }

        private static HealthEvent Health(EventLine line)
        {
            if (!EventWords.TryParse(line.Text("kind"), out HealthKind kind))
                throw line.Wrong("kind", "is no word of the format");
            return new HealthEvent
            {
                FrameIndex = line.Integer("frame"),
                TimeUs = line.Long("time_us"),
                Kind = kind,
                Value = line.Double("value"),
                Text = line.Text("text"),
            };
        }

        private static Vector2D Position(EventLine line) => new Vector2D(line.Double("x_px"), line.Double("y_px"));

        private static Covariance2D Covariance(EventLine line, string name)
        {
            Span<double> n = stackalloc double[3];
            return line.TryNumbers(line.Root, name, n) ? new Covariance2D(n[0], n[1], n[2]) : new Covariance2D(double.NaN, double.NaN, double.NaN);
        }

        private static LaserColor Color(EventLine line) =>
            EventWords.TryParse(line.Text("color"), out LaserColor color) ? color : throw line.Wrong("color", "is no word of the format");

        private static HandSide Side(EventLine line)
        {
            HandSide side = HandSide.Unknown;
            if (line.OptionalText("hand") is string word && !EventWords.TryParse(word, out side))
                throw line.Wrong("hand", "is no word of the format");
            return side;
        }
    }
}
