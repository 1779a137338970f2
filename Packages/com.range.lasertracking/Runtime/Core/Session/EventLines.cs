using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Hands;

namespace LaserTracking.Session
{
    /// <summary>
    /// Each event as its line of events.jsonl: names, order and rounding of the fields. Fields are only ever added. Rounding is
    /// well below what can be measured: 0.0001 px, 10 µm, probabilities 0.0001.
    /// </summary>
    internal static class EventLines
    {
        private const int PixelDecimals = 4;
        private const int MetreDecimals = 5;
        private const int ProbabilityDecimals = 4;
        private const int DirectionDecimals = 6;

        public static void Header(Utf8JsonLineWriter json, SessionHeader header)
        {
            Begin(json, "header");
            Member(json, "v", 1);
            Member(json, "tool", "range");
            Member(json, "version", header.Version);
            json.Name("inputs");
            json.BeginArray();
            foreach (SessionInput input in header.Inputs)
            {
                json.BeginObject();
                Member(json, "path", input.Path);
                Member(json, "sha256", input.Sha256);
                json.EndObject();
            }

            json.EndArray();
            Member(json, "calibration", header.Calibration);
            Member(json, "detector", header.Detector);
            Member(json, "seed", header.Seed);
            End(json);
        }

        public static void End(Utf8JsonLineWriter json, in SessionEnd end)
        {
            Begin(json, "end");
            Member(json, "frames", end.Frames);
            Member(json, "dropped", end.Dropped);
            Member(json, "seconds_media", end.SecondsMedia, 6);
            Member(json, "seconds_wall", end.SecondsWall, 3);
            Member(json, "start_us", end.StartTimeUs);
            End(json);
        }

        public static void Shot(Utf8JsonLineWriter json, in ShotEvent e)
        {
            json.BeginObject();
            ShotMembers(json, e);
            End(json);
        }

        /// <summary>The members of a shot's object, its type first.</summary>
        public static void ShotMembers(Utf8JsonLineWriter json, in ShotEvent e)
        {
            Member(json, "type", "shot");
            Member(json, "id", e.Shot.Id);
            Member(json, "frame", e.Shot.FrameIndex);
            Member(json, "first_frame", e.Shot.FirstFrameIndex);
            Member(json, "last_frame", e.Shot.LastFrameIndex);
            Member(json, "time_us", e.Shot.TimeUs);
            Member(json, "time_sigma_us", e.Shot.TimeSigmaUs);
            Dot(json, e.Shot.Dot);
            json.Name("screen_m");
            if (e.HasScreenPosition)
                json.Vector(e.ScreenM, MetreDecimals);
            else
                json.Null();
            json.Name("screen_cov_mm2");
            if (e.HasScreenPosition)
                Covariance(json, e.ScreenCovarianceMm2, 4);
            else
                json.Null();
            Shooter(json, e.Shooter);
            json.Name("shooter_p");
            if (e.Shooter > 0)
                json.Number(e.ShooterProbability, ProbabilityDecimals);
            else
                json.Null();
            Hand(json, e.Hand);
            Muzzle(json, e);
            json.Name("hit");
            if (e.HasHit)
                Hit(json, e.Hit);
            else
                json.Null();
        }

        public static void Dot(Utf8JsonLineWriter json, in DotEvent e)
        {
            Begin(json, "dot");
            Member(json, "frame", e.FrameIndex);
            Member(json, "time_us", e.TimeUs);
            Member(json, "track", e.TrackId);
            Position(json, e.Dot.PositionPx);
            Member(json, "sigma_px", e.Dot.CovariancePx.Sigma, PixelDecimals);
            Member(json, "color", EventWords.Of(e.Dot.Color));
            Shooter(json, e.Shooter);
            End(json);
        }

        public static void Hand(Utf8JsonLineWriter json, in HandEvent e)
        {
            json.BeginObject();
            HandMembers(json, e);
            End(json);
        }

        /// <summary>The members of a hand's object, its type first.</summary>
        public static void HandMembers(Utf8JsonLineWriter json, in HandEvent e)
        {
            Member(json, "type", "hand");
            Member(json, "frame", e.FrameIndex);
            Member(json, "time_us", e.TimeUs);
            Hand(json, e.Side);
            json.Name("palm_m");
            json.Vector(e.PalmM, MetreDecimals);
            json.Name("palm_sigma_m");
            if (e.PalmSigmaM > 0)
                json.Number(e.PalmSigmaM, MetreDecimals);
            else
                json.Null();
            json.Name("muzzle_m");
            json.Vector(e.MuzzleM, MetreDecimals);
            Member(json, "depth_source", EventWords.Of(e.DepthSource));
            Member(json, "track", e.TrackId);
        }

        public static void Rejected(Utf8JsonLineWriter json, in RejectedEvent e)
        {
            Begin(json, "rejected");
            Member(json, "frame", e.FrameIndex);
            Member(json, "time_us", e.TimeUs);
            Position(json, e.Candidate.PositionPx);
            Member(json, "reason", EventWords.Of(e.Candidate.Reason));
            Member(json, "value", e.Candidate.Value, 5);
            Member(json, "limit", e.Candidate.Limit, 5);
            End(json);
        }

        public static void Health(Utf8JsonLineWriter json, in HealthEvent e)
        {
            Begin(json, "health");
            Member(json, "frame", e.FrameIndex);
            Member(json, "time_us", e.TimeUs);
            Member(json, "kind", EventWords.Of(e.Kind));
            Member(json, "value", e.Value, 5);
            Member(json, "text", e.Text);
            End(json);
        }

        private static void Dot(Utf8JsonLineWriter json, in Dot dot)
        {
            Position(json, dot.PositionPx);
            Member(json, "sigma_px", dot.CovariancePx.Sigma, PixelDecimals);
            json.Name("cov_px");
            Covariance(json, dot.CovariancePx, 7);
            Member(json, "peak", dot.Peak);
            Member(json, "area_px", dot.AreaPx);
            Member(json, "color", EventWords.Of(dot.Color));
            Member(json, "confidence", dot.Confidence, ProbabilityDecimals);
            json.Name("factors");
            json.BeginObject();
            Member(json, "peak", dot.Factors.Peak, ProbabilityDecimals);
            Member(json, "contrast", dot.Factors.Contrast, ProbabilityDecimals);
            Member(json, "center", dot.Factors.Center, ProbabilityDecimals);
            Member(json, "stability", dot.Factors.Stability, ProbabilityDecimals);
            json.EndObject();
            json.Name("streak_px");
            json.Vector(dot.StreakPx, PixelDecimals);
        }

        private static void Muzzle(Utf8JsonLineWriter json, in ShotEvent e)
        {
            json.Name("muzzle_m");
            if (e.HasMuzzle)
                json.Vector(e.MuzzleM, MetreDecimals);
            else
                json.Null();
            json.Name("direction");
            if (e.HasMuzzle)
                json.Vector(e.Direction, DirectionDecimals);
            else
                json.Null();
            json.Name("pair_dt_us");
            if (e.HasMuzzle)
                json.Number(e.PairDeltaUs);
            else
                json.Null();
        }

        private static void Hit(Utf8JsonLineWriter json, in ScoredHit hit)
        {
            json.BeginObject();
            Member(json, "target", hit.Target);
            Member(json, "zone", hit.Zone);
            Member(json, "points", hit.Points);
            json.Name("point_m");
            json.Vector(hit.PointM, MetreDecimals);
            Member(json, "distance_m", hit.DistanceM, MetreDecimals);
            Member(json, "p_zone", hit.ZoneProbability, ProbabilityDecimals);
            Member(json, "score", hit.Score, ProbabilityDecimals);
            json.Name("local_m");
            json.Vector(hit.LocalPointM, MetreDecimals);
            json.EndObject();
        }

        private static void Begin(Utf8JsonLineWriter json, string type)
        {
            json.BeginObject();
            Member(json, "type", type);
        }

        private static void End(Utf8JsonLineWriter json)
        {
            json.EndObject();
            json.EndLine();
        }

        private static void Position(Utf8JsonLineWriter json, Vector2D positionPx)
        {
            Member(json, "x_px", positionPx.X, PixelDecimals);
            Member(json, "y_px", positionPx.Y, PixelDecimals);
        }

        private static void Covariance(Utf8JsonLineWriter json, in Covariance2D covariance, int decimals) =>
            json.Vector(new Vector3D(covariance.XX, covariance.XY, covariance.YY), decimals);

        private static void Shooter(Utf8JsonLineWriter json, int shooter)
        {
            json.Name("shooter");
            if (shooter > 0)
                json.Number(shooter);
            else
                json.Null();
        }

        private static void Hand(Utf8JsonLineWriter json, HandSide side) =>
            Member(json, "hand", side == HandSide.Unknown ? null : EventWords.Of(side));

        private static void Member(Utf8JsonLineWriter json, string name, long? value)
        {
            json.Name(name);
            if (value.HasValue)
                json.Number(value.Value);
            else
                json.Null();
        }

        private static void Member(Utf8JsonLineWriter json, string name, double value, int decimals)
        {
            json.Name(name);
            json.Number(value, decimals);
        }

        private static void Member(Utf8JsonLineWriter json, string name, string? value)
        {
            json.Name(name);
            json.Text(value);
        }
    }
}
