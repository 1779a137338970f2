using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Host.Scoring;
using LaserTracking.Imaging;
using LaserTracking.Session;
using LaserTracking.Simulation;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Studies.Simulated
{
    /// <summary>One simulated session through detector and tracker, compared with its truth; also how far each shot really rose in the camera's picture.</summary>
    internal sealed class SimulatedRun
    {
        private readonly SimulatedRange _range;
        private readonly List<ReportedShot> _reported = new();
        private readonly double _reachPx;
        private readonly TruthClip _truth;
        private readonly (byte Largest, byte Smallest)[]?[] _before;
        private readonly double[] _rise;
        private readonly double[] _riseLevels;
        private readonly double[] _riseOfAll;
        private readonly int[] _bestFrame;

        public SimulatedRun(SimulatedRange range)
        {
            _range = range;
            _reachPx = Math.Max(2, 3 * range.Scenario.ColorCamera.Width / 640.0);
            TrueShot[] visible = range.Truth.Shots.Where(s => s.FirstFrame >= FirstFrames && IsInside(s)).ToArray();
            ILookup<int, TrueDot> dots = Dots(range.Truth).ToLookup(d => d.ShotId);
            _truth = new TruthClip("simulation", range.Scenario.ColorCamera.Width, visible.Select(s => Truth(s, dots[s.Id])).ToArray());
            PulseMs = visible.Select(s => s.PulseUs / 1000).ToArray();
            _before = new (byte, byte)[visible.Length][];
            _rise = new double[visible.Length];
            _riseLevels = new double[visible.Length];
            _riseOfAll = new double[visible.Length];
            _bestFrame = visible.Select(s => s.FirstFrame).ToArray();
        }

        /// <summary>What a camera shows at first the detector only learns.</summary>
        private const int FirstFrames = 5;

        private double[] PulseMs { get; }

        public SimulatedRange Range => _range;

        public List<TracedShot> Shots { get; } = new();

        /// <summary>Reports that no true shot takes, and lie where and when no true shot is.</summary>
        public List<ReportedShot> False { get; } = new();

        /// <summary>Reports beyond the first of one true shot.</summary>
        public List<ReportedShot> Doubles { get; } = new();

        public int Frames { get; private set; }

        public double Seconds { get; private set; }

        public void Process(CancellationToken interrupted)
        {
            var detector = new ShotDetector();
            var tracker = new ShotTracker();
            var detections = new Detections();
            using IFrameSource source = new PrefetchingFrameSource(_range.CreateColorSource());
            using var frame = new Frame();
            using var bgra = new Image();
            ILookup<int, int> firsts = Indices().ToLookup(i => _truth.Shots[i].FirstVisibleFrame - 1);
            var on = new List<int>();
            while (!interrupted.IsCancellationRequested && source.TryRead(frame))
            {
                detector.Process(frame, detections);
                tracker.Process(detections);
                foreach (Shot shot in tracker.Shots)
                    _reported.Add(new ReportedShot(shot.FrameIndex, shot.Dot.PositionPx, EventWords.Of(shot.Dot.Color)));
                Measure(frame, firsts[frame.Index].ToArray(), on, bgra);
                Frames++;
                Seconds = frame.TimeUs * 1e-6;
            }

            Compare();
        }

        private IEnumerable<int> Indices() => Enumerable.Range(0, _truth.Shots.Count);

        /// <summary>Each pixel near a shot against itself in the frame before its first, read off the picture.</summary>
        private void Measure(Frame frame, int[] next, List<int> on, Image bgra)
        {
            on.RemoveAll(i => frame.Index > _truth.Shots[i].LastVisibleFrame);
            if (next.Length == 0 && on.Count == 0)
                return;
            ColorConversion.ToBgra(frame.Color, bgra);
            foreach (int i in on)
            {
                (byte Largest, byte Smallest)[] now = Patch(bgra, _truth.Shots[i].PlacesPx[0]), before = _before[i]!;
                for (int p = 0; p < now.Length; p++)
                {
                    double levels = now[p].Largest - before[p].Largest, share = levels / (255 - before[p].Largest + 8);
                    double shareOfAll = (now[p].Smallest - before[p].Smallest) / (255.0 - before[p].Smallest + 8);
                    if ((share <= _rise[i] && shareOfAll <= _riseOfAll[i]) || !_truth.Shots[i].PlacesPx.Any(place => IsNear(p, _truth.Shots[i].PlacesPx[0], place)))
                        continue;
                    _riseOfAll[i] = Math.Max(_riseOfAll[i], shareOfAll);
                    if (share <= _rise[i])
                        continue;
                    _rise[i] = share;
                    _riseLevels[i] = levels;
                    _bestFrame[i] = frame.Index;
                }
            }

            foreach (int i in next)
            {
                _before[i] = Patch(bgra, _truth.Shots[i].PlacesPx[0]);
                on.Add(i);
            }
        }

        private int PatchRadius => (int)(8 * _reachPx);

        private bool IsNear(int pixel, Vector2D center, Vector2D place)
        {
            int side = 2 * PatchRadius + 1;
            return (new Vector2D((int)center.X - PatchRadius + pixel % side, (int)center.Y - PatchRadius + pixel / side) - place).LengthSquared <= _reachPx * _reachPx;
        }

        /// <summary>Strongest and weakest channel around a place; 0 outside the picture.</summary>
        private unsafe (byte Largest, byte Smallest)[] Patch(Image bgra, Vector2D center)
        {
            int radius = PatchRadius, side = 2 * radius + 1;
            var patch = new (byte Largest, byte Smallest)[side * side];
            for (int i = 0; i < patch.Length; i++)
            {
                int x = (int)center.X - radius + i % side, y = (int)center.Y - radius + i / side;
                if (x < 0 || y < 0 || x >= bgra.Width || y >= bgra.Height)
                    continue;
                byte* pixel = bgra.Pixels + (long)y * bgra.Stride + 4 * x;
                patch[i] = (Math.Max(pixel[0], Math.Max(pixel[1], pixel[2])), Math.Min(pixel[0], Math.Min(pixel[1], pixel[2])));
            }

            return patch;
        }

        private void Compare()
        {
            int[] match = ShotMatcher.Match(_truth, _reported);
            foreach (int i in Indices())
                Shots.Add(new TracedShot(_truth.Shots[i], _rise[i], _riseLevels[i], _riseOfAll[i], _bestFrame[i], PulseMs[i]) { IsFound = match.Contains(i) });
            double tolerance = 40.0 * _truth.Width / 640, settle = 0.25 * _range.Scenario.ColorCamera.FramesPerSecond + 3;
            for (int j = 0; j < _reported.Count; j++)
            {
                if (match[j] >= 0)
                    continue;

                // Shots that began before the first frames or at the picture's rim are no part of the truth, but not false either.
                bool isAny = _range.Truth.Shots.Any(s => s.FirstFrame >= 0 && _reported[j].Frame >= s.FirstFrame && _reported[j].Frame <= s.LastFrame + settle
                    && (s.FirstLightPx - _reported[j].PositionPx).Length <= tolerance);
                (isAny ? Doubles : False).Add(_reported[j]);
            }
        }

        private bool IsInside(TrueShot shot) =>
            shot.FirstLightPx.X > 2 && shot.FirstLightPx.Y > 2 && shot.FirstLightPx.X < _range.Scenario.ColorCamera.Width - 3 && shot.FirstLightPx.Y < _range.Scenario.ColorCamera.Height - 3;

        private static TruthShot Truth(TrueShot shot, IEnumerable<TrueDot> dots) =>
            new(FormattableString.Invariant($"{shot.Id}"), EventWords.Of(shot.Color), shot.FirstFrame, shot.LastFrame, dots.Select(d => d.PositionPx).Prepend(shot.FirstLightPx).ToArray());

        private static IEnumerable<TrueDot> Dots(SimulationTruth truth)
        {
            for (int frame = 0; frame < truth.ColorFrameCount; frame++)
            {
                foreach (TrueDot dot in truth.DotsOf(frame).ToArray())
                    yield return dot;
            }
        }
    }
}
