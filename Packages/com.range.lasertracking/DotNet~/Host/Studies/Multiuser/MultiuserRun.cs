using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Host.Scoring;
using LaserTracking.Host.Tracks;
using LaserTracking.Pipeline;
using LaserTracking.Session;
using LaserTracking.Simulation;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Studies.Multiuser
{
    /// <summary>One simulated session through the whole pipeline, and what it said beside the truth.</summary>
    internal sealed class MultiuserRun : IEventSink
    {
        private const double MatchRadiusM = 0.08;
        private const int FrameTolerance = 2;
        private const double DotPx = 6;

        /// <summary>Numbers of dots whose shooter is not known: apart from all shooters'.</summary>
        private const int NobodysTracks = 1000;

        private readonly SimulatedRange _range;
        private readonly bool _hasTrueDots;
        private readonly List<ShotEvent> _shots = new();
        private readonly List<HandEvent> _hands = new();
        private readonly List<MotRow> _dots = new();

        public MultiuserRun(MultiuserCase situation, int seed)
        {
            _range = new SimulatedRange(situation.Scenario(seed), SimulationScenes.Default());
            _hasTrueDots = situation.HasTrueDots;
        }

        public List<NamedShot> Shots { get; } = new();

        /// <summary>Per raised weapon hand in view and depth frame.</summary>
        public List<SaidPalm> Palms { get; } = new();

        /// <summary>How often the number of a hand whose palm was stated went over to another person's.</summary>
        public int Swaps { get; private set; }

        public List<HealthEvent> Health { get; } = new();

        public TrackMetrics Tracks { get; private set; } = new();

        /// <summary>By how much camera 1's clock was ahead at the end, ms, and what was said of that; null: nothing was.</summary>
        public double ClockOffsetMs { get; private set; }

        public double? ClockSaidMs { get; private set; }

        public void Process(CancellationToken interrupted)
        {
            var truth = new TrueDotDetector(_range);
            using IFrameSource screen = _hasTrueDots ? truth : new PrefetchingFrameSource(_range.CreateColorSource());
            using IFrameSource hands = new PrefetchingFrameSource(_range.CreateDepthSource());
            var pipeline = RangePipeline.CreateDefault(_hasTrueDots ? truth : new ShotDetector(), _range.Calibration, true, null, this);
            pipeline.Begin(new SessionHeader("study", Array.Empty<SessionInput>(), null, "shots", null));
            using var runner = new SessionRunner(pipeline, screen, hands, 0);
            runner.Run(interrupted);
            pipeline.End(0);
            double endUs = 1e6 * _range.Scenario.DurationS;
            ClockOffsetMs = (_range.Truth.DepthClockUs(endUs) - _range.Truth.ColorClockUs(endUs)) / 1e3;
            ClockSaidMs = pipeline.HandClockOffsetUs == 0 ? null : pipeline.HandClockOffsetUs / 1e3;
            CompareShots();
            ComparePalms();
            Tracks = TrackEvaluator.Evaluate(TrueTracks(), _dots, TrackMatch.Centre20, _range.Truth.ColorFrameCount);
        }

        public void OnShot(in ShotEvent shot) => _shots.Add(shot);

        public void OnHand(in HandEvent hand) => _hands.Add(hand);

        public void OnHealth(in HealthEvent health) => Health.Add(health);

        public void OnDot(in DotEvent dot) =>
            _dots.Add(Row(dot.FrameIndex, dot.Shooter > 0 ? dot.Shooter : NobodysTracks + dot.TrackId, dot.Dot.PositionPx));

        public void OnRejected(in RejectedEvent rejected)
        {
        }

        public void OnTimePassed(long timeUs)
        {
        }

        public void Begin(SessionHeader header)
        {
        }

        public void End(in SessionEnd end)
        {
        }

        private static MotRow Row(int frame, int id, Vector2D px) => new(frame + 1, id, new BoundingBox(px.X - DotPx / 2, px.Y - DotPx / 2, DotPx, DotPx), 1);

        /// <summary>Each shot said with the nearest true one of its frames; who was meant by a number is settled over the whole session.</summary>
        private void CompareShots()
        {
            List<TrueShot> free = _range.Truth.Shots.Where(s => s.FirstFrame >= 0).ToList();
            var pairs = new List<(ShotEvent Said, TrueShot Fired)>();
            foreach (ShotEvent said in _shots.OrderBy(s => s.Shot.TimeUs))
            {
                TrueShot? fired = free.Where(s => said.Shot.FirstFrameIndex >= s.FirstFrame - FrameTolerance && said.Shot.FirstFrameIndex <= s.LastFrame + FrameTolerance && (s.ScreenM - said.ScreenM).Length < MatchRadiusM)
                    .MinBy(s => (s.ScreenM - said.ScreenM).Length);
                if (fired == null)
                    continue;
                free.Remove(fired);
                pairs.Add((said, fired));
            }

            Dictionary<int, int> meant = Meant(pairs);
            var last = new Dictionary<int, int>();
            var right = new Dictionary<int, int>();
            foreach ((ShotEvent said, TrueShot fired) in pairs.OrderBy(p => p.Fired.SceneTimeUs))
            {
                bool isSwitch = said.Shooter > 0 && last.TryGetValue(fired.Shooter, out int before) && before != said.Shooter;
                if (said.Shooter > 0)
                    last[fired.Shooter] = said.Shooter;
                TrueHand hand = _range.Truth.HandAt(fired.Shooter, fired.SceneTimeUs);
                int person = meant.GetValueOrDefault(said.Shooter), known = right.GetValueOrDefault(fired.Shooter);
                bool isRight = said.Shooter > 0 && person == fired.Shooter, isArmSeen = IsInView(hand);
                right[fired.Shooter] = known + (isRight ? 1 : 0);
                Shots.Add(new NamedShot(said, fired, person, isSwitch, isArmSeen, isRight ? "" : MissReason.Of(_range, fired, isArmSeen, _hands, known)));
            }
        }

        /// <summary>Numbers to people, one to one, so that the most shots are right: somebody with two numbers is wrong under one of them.</summary>
        private Dictionary<int, int> Meant(List<(ShotEvent Said, TrueShot Fired)> pairs)
        {
            int[] numbers = pairs.Select(p => p.Said.Shooter).Where(n => n > 0).Distinct().Order().ToArray();
            int people = _range.Scenario.Shooters.Count;
            var costs = new double[numbers.Length * people];
            foreach ((ShotEvent said, TrueShot fired) in pairs.Where(p => p.Said.Shooter > 0))
                costs[Array.IndexOf(numbers, said.Shooter) * people + fired.Shooter - 1]--;
            var chosen = new int[numbers.Length];
            new HungarianAssignment(Math.Max(1, Math.Max(numbers.Length, people))).Solve(costs, numbers.Length, people, chosen);
            return numbers.Select((number, i) => (number, person: chosen[i] + 1)).Where(n => n.person > 0).ToDictionary(n => n.number, n => n.person);
        }

        private void ComparePalms()
        {
            ILookup<int, HandEvent> byFrame = _hands.ToLookup(h => h.FrameIndex);
            int[] firing = _range.Truth.Shots.Select(s => s.Shooter).Distinct().ToArray();
            var owners = new Dictionary<int, int>();
            for (int frame = 30; frame < _range.Truth.DepthFrameCount; frame += 3)
            {
                SaidPalm[] said = SaidPalm.Match(_range, frame, byFrame[frame].ToArray());
                foreach (int shooter in firing)
                {
                    TrueHand hand = _range.Truth.HandAt(shooter, _range.Truth.DepthFrameTimeUs(frame));
                    if (!IsInView(hand) || !IsRaised(hand))
                        continue;
                    SaidPalm palm = said[shooter - 1];
                    Palms.Add(palm);
                    if (palm.IsStated && owners.TryGetValue(palm.TrackId, out int before) && before != shooter)
                        Swaps++;
                    if (palm.IsStated)
                        owners[palm.TrackId] = shooter;
                }
            }
        }

        /// <summary>Camera 1 can see the arm from the elbow on: within its picture and its light, less a margin.</summary>
        private bool IsInView(in TrueHand hand) => IsInView(hand.ElbowM) && IsInView(hand.PalmM) && IsInView(hand.MuzzleM);

        private bool IsInView(Vector3D pointM)
        {
            HandCamera camera = _range.Calibration.HandCamera!;
            Vector3D mm = camera.ToCameraMm(pointM);
            const double margin = 0.03;
            double x = Math.Abs(mm.X / mm.Z) + margin, y = Math.Abs(mm.Y / mm.Z) + margin;
            return mm.Z > 500 && mm.Z < 3800 && x < 0.63 && y < 0.57 && x / 0.66 + 0.5 * (y / 0.60) <= 1.25;
        }

        private static bool IsRaised(in TrueHand hand) => hand.LightDirection.Y < 0.35;

        private List<MotRow> TrueTracks()
        {
            var rows = new List<MotRow>();
            for (int frame = 0; frame < _range.Truth.ColorFrameCount; frame++)
            {
                var seen = new HashSet<int>();
                foreach (TrueDot dot in _range.Truth.DotsOf(frame).ToArray())
                {
                    int shooter = _range.Truth.Shots[dot.ShotId - 1].Shooter;
                    if (seen.Add(shooter))
                        rows.Add(Row(frame, shooter, dot.PositionPx));
                }
            }

            return rows;
        }
    }
}
