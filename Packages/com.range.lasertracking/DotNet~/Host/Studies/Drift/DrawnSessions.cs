using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Geometry;

namespace LaserTracking.Host.Studies.Drift
{
    /// <summary>Drawn pictures that jump, scroll and pan, and cameras that are knocked, pan and creep, without a calibrated screen.</summary>
    internal static class DrawnSessions
    {
        public const string FullJumps = "picture fills the view and jumps", FullScrolls = "picture fills the view and scrolls", RoomJumps = "picture in a room jumps",
            RoomScrolls = "picture in a room scrolls", Knock = "camera knocked", Pan = "camera pans", Creep = "camera creeps", Early = "camera knocked in the first 2 s",
            Dark = "the same after a dark start";

        public static readonly string[] Rows = { FullJumps, FullScrolls, RoomJumps, RoomScrolls, Knock, Pan, Creep, Early, Dark };

        private const int FramesPerSecond = 15;

        /// <summary>From when on a moved camera must be noticed, px.</summary>
        private const double NoticeablePx = 2;

        public static DriftSession Create(string row, int seed)
        {
            var random = new Random(seed * 31 + Array.IndexOf(Rows, row));
            double Uniform(double low, double high) => low + (high - low) * random.NextDouble();
            Vector2D Way(double length)
            {
                double angle = Uniform(0, 2 * Math.PI);
                return new Vector2D(length * Math.Cos(angle), length * Math.Sin(angle));
            }

            Vector2D jump = Way(Uniform(1, 16)), speed = Way(Math.Exp(Uniform(Math.Log(0.15), Math.Log(30)))), moved;
            int targets = seed % 2 * 3;
            bool hasRoom = row != FullJumps && row != FullScrolls, endless = random.Next(2) == 0;
            double on = Uniform(2, 4), rest = Uniform(2.5, 4), pan = Uniform(1, 3), seconds = 14, from = double.PositiveInfinity, due = from, clear = 0;
            double Stepped(double t) => t < on ? 0 : t < on + rest ? 1 : t < on + 2 * rest ? 2.2 : 0;
            double Panned(double t) => endless ? t : Math.Clamp(t - on, 0, pan) - Math.Clamp(t - on - pan - rest, 0, pan);
            Func<double, Vector2D> picture = _ => default, camera = _ => default;
            switch (row)
            {
                case FullJumps:
                case RoomJumps:
                    picture = t => jump * Stepped(t);
                    break;
                case FullScrolls:
                case RoomScrolls:
                    picture = t => speed * Panned(t);
                    break;
                case Pan:
                    double rate = Math.Exp(Uniform(Math.Log(0.3), Math.Log(20)));
                    double takes = Math.Max(pan, NoticeablePx / rate);
                    (from, due, moved) = (3, 3 + NoticeablePx / rate, Way(rate * takes));
                    seconds = from + takes + 7;
                    camera = t => moved * Math.Clamp((t - from) / takes, 0, 1);
                    return Session();
                case Creep:
                    double creep = Uniform(0.1, 0.6), length = Uniform(2.5, 5);
                    (from, due, moved) = (3, 3 + NoticeablePx / creep, Way(length));
                    seconds = from + length / creep + 7;
                    camera = t => moved * Math.Clamp((t - from) * creep / length, 0, 1);
                    return Session();
                default:
                    // The picture rests, jumps to and fro, or scrolls.
                    int kind = seed % 3;
                    picture = t => kind == 0 ? default : kind == 1 ? jump * Stepped(t) : speed * t;
                    from = row == Knock ? Uniform(4, 6) : Uniform(0.05, 2);
                    clear = row == Dark ? Uniform(0.2, 1) : 0;
                    from += row == Dark ? clear + 0.4 : 0;
                    due = from;
                    Vector2D to = moved = Way(Uniform(2, 10));
                    camera = t => t < from ? default : t < from + 0.1 ? to * 0.6 : t < from + 0.2 ? to * 1.2 : to;
                    return Session();
            }

            moved = default;
            return Session();

            DriftSession Session() => new(FormattableString.Invariant($"{row}, seed {seed}"), Play(seed, hasRoom, targets, seconds, clear, picture, camera), [(row, null)], from, due, moved, row is Pan or Creep);
        }

        private static IEnumerable<Frame> Play(int seed, bool hasRoom, int targets, double seconds, double clear, Func<double, Vector2D> picture, Func<double, Vector2D> camera)
        {
            var view = new DrawnView(seed, hasRoom);
            using var frame = new Frame();
            for (int i = 0; i < seconds * FramesPerSecond; i++)
            {
                double t = i / (double)FramesPerSecond;
                frame.Begin(i, (long)(t * 1e6));
                view.Draw(frame.Color, picture(t), camera(t), i, targets, t >= clear ? 1 : 0.02 * (i % 2));
                frame.Color.TimeUs = frame.TimeUs;
                yield return frame;
            }
        }
    }
}
