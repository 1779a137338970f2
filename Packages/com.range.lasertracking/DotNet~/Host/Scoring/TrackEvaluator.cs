using System;
using System.Collections.Generic;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Host.Tracks;
using LaserTracking.Tracking;

namespace LaserTracking.Host.Scoring
{
    /// <summary>
    /// Compares tracks with the truth as py-motmetrics 1.4 does: frame by frame a true track keeps the number it was last found under
    /// while that is possible, the rest is assigned with the most pairs and among those the least distance.
    /// </summary>
    internal sealed class TrackEvaluator
    {
        /// <summary>Most boxes of a frame on either side.</summary>
        public const int MaximumBoxes = 1000;

        /// <summary>Most pairs of a true and a tracked number.</summary>
        public const int MaximumPairs = 16_000_000;

        private const double MaximumCentreDistancePx = 20;
        private const double MaximumIouDistance = 0.5;

        /// <summary>Above any sum of distances, so that the number of pairs counts first; small enough to leave them their digits.</summary>
        private const double NoPair = 1e6;

        private readonly TrackMatch _match;
        private readonly Dictionary<int, Life> _lives = new();
        private readonly Dictionary<int, int> _numbers = new();
        private readonly Dictionary<(int Life, int Number), int> _together = new();
        private readonly HungarianAssignment _assignment = new(MaximumBoxes);
        private int _matches;
        private int _switches;
        private double _distanceSum;

        private TrackEvaluator(TrackMatch match) => _match = match;

        /// <param name="truth">By frame, ids once a frame; not empty.</param>
        /// <param name="tracks">By frame, ids once a frame.</param>
        /// <param name="frames">Length of the sequence; at least the last frame.</param>
        /// <exception cref="InputException">More boxes in a frame, or more numbers, than can be compared.</exception>
        public static TrackMetrics Evaluate(IReadOnlyList<MotRow> truth, IReadOnlyList<MotRow> tracks, TrackMatch match, int frames)
        {
            var evaluator = new TrackEvaluator(match);
            ILookup<int, MotRow> tracksOfFrame = tracks.ToLookup(row => row.Frame);
            ILookup<int, MotRow> truthOfFrame = truth.ToLookup(row => row.Frame);
            foreach (int frame in truth.Concat(tracks).Select(row => row.Frame).Distinct().Order())
                evaluator.AddFrame(frame, truthOfFrame[frame].ToArray(), tracksOfFrame[frame].ToArray());
            return evaluator.Metrics(truth.Count, tracks.Count, frames);
        }

        private void AddFrame(int frame, MotRow[] truth, MotRow[] tracks)
        {
            if (Math.Max(truth.Length, tracks.Length) > MaximumBoxes)
                throw new InputException("score-tracks", FormattableString.Invariant($"frame {frame} holds {Math.Max(truth.Length, tracks.Length)} boxes, at most {MaximumBoxes} can be compared"), "leave the frame out of both files");
            var costs = new double[truth.Length * tracks.Length];
            for (int i = 0; i < truth.Length; i++)
            {
                for (int j = 0; j < tracks.Length; j++)
                {
                    double distance = Distance(truth[i].Box, tracks[j].Box);
                    costs[i * tracks.Length + j] = distance;
                    if (distance < NoPair)
                        _together[(truth[i].Id, tracks[j].Id)] = _together.GetValueOrDefault((truth[i].Id, tracks[j].Id)) + 1;
                }
            }

            foreach (MotRow track in tracks)
                _numbers[track.Id] = _numbers.GetValueOrDefault(track.Id) + 1;
            int[] found = Assign(truth, tracks, costs);
            for (int i = 0; i < truth.Length; i++)
            {
                Life life = LifeOf(truth[i].Id);
                int? number = found[i] < 0 ? null : tracks[found[i]].Id;
                if (number != null)
                {
                    bool isSwitch = life.LastNumber != null && life.LastNumber != number;
                    _switches += isSwitch ? 1 : 0;
                    _matches += isSwitch ? 0 : 1;
                    _distanceSum += costs[i * tracks.Length + found[i]];
                }

                life.Add(number);
            }
        }

        /// <summary>Each true box's tracked one, or -1.</summary>
        private int[] Assign(MotRow[] truth, MotRow[] tracks, double[] costs)
        {
            int[] found = Enumerable.Repeat(-1, truth.Length).ToArray();
            var isTaken = new bool[tracks.Length];
            for (int i = 0; i < truth.Length; i++)
            {
                int? last = LifeOf(truth[i].Id).LastNumber;
                int j = last == null ? -1 : Array.FindIndex(tracks, track => track.Id == last);
                if (j < 0 || isTaken[j] || costs[i * tracks.Length + j] >= NoPair)
                    continue;
                found[i] = j;
                isTaken[j] = true;
            }

            int[] rows = Enumerable.Range(0, truth.Length).Where(i => found[i] < 0).ToArray();
            int[] columns = Enumerable.Range(0, tracks.Length).Where(j => !isTaken[j]).ToArray();
            var rest = new double[rows.Length * columns.Length];
            for (int r = 0; r < rows.Length; r++)
            {
                for (int c = 0; c < columns.Length; c++)
                    rest[r * columns.Length + c] = costs[rows[r] * tracks.Length + columns[c]];
            }

            var columnOfRow = new int[rows.Length];
            _assignment.Solve(rest, rows.Length, columns.Length, columnOfRow);
            for (int r = 0; r < rows.Length; r++)
            {
                if (columnOfRow[r] >= 0 && rest[r * columns.Length + columnOfRow[r]] < NoPair)
                    found[rows[r]] = columns[columnOfRow[r]];
            }

            return found;
        }

        private double Distance(in BoundingBox truth, in BoundingBox track)
        {
            double distance = _match == TrackMatch.Iou05
                ? 1 - BoundingBox.IntersectionOverUnion(truth, track)
                : new Vector2D(truth.CenterX - track.CenterX, truth.CenterY - track.CenterY).Length;
            return distance <= (_match == TrackMatch.Iou05 ? MaximumIouDistance : MaximumCentreDistancePx) ? distance : NoPair;
        }

        private Life LifeOf(int id)
        {
            if (!_lives.TryGetValue(id, out Life? life))
                _lives.Add(id, life = new Life());
            return life;
        }

        private TrackMetrics Metrics(int objects, int predictions, int frames) => new()
        {
            Frames = frames,
            Objects = objects,
            Predictions = predictions,
            Matches = _matches,
            Switches = _switches,
            DistanceSum = _distanceSum,
            Fragmentations = _lives.Values.Sum(life => life.Fragmentations),
            IdentityTruePositives = IdentityTruePositives(),
            MostlyTracked = _lives.Values.Count(life => life.Share >= 0.8),
            PartiallyTracked = _lives.Values.Count(life => life.Share >= 0.2 && life.Share < 0.8),
            MostlyLost = _lives.Values.Count(life => life.Share < 0.2),
        };

        /// <summary>The numbers that the true tracks get in the best assignment over the whole sequence; boxes they then have in common.</summary>
        private int IdentityTruePositives()
        {
            int[] ids = _lives.Keys.ToArray(), numbers = _numbers.Keys.ToArray();
            if ((long)ids.Length * numbers.Length > MaximumPairs)
                throw new InputException("score-tracks", FormattableString.Invariant($"{ids.Length} true and {numbers.Length} tracked ids are too many to compare"), "compare shorter pieces");
            var costs = new double[ids.Length * numbers.Length];
            for (int i = 0; i < ids.Length; i++)
            {
                for (int j = 0; j < numbers.Length; j++)
                    costs[i * numbers.Length + j] = -_together.GetValueOrDefault((ids[i], numbers[j]));
            }

            var assignment = new HungarianAssignment(Math.Max(1, Math.Max(ids.Length, numbers.Length)));
            return (int)-assignment.Solve(costs, ids.Length, numbers.Length, new int[ids.Length]);
        }

        /// <summary>What became of one true track.</summary>
        private sealed class Life
        {
            private int _frames;
            private int _found;
            private bool _isLost;

            public int? LastNumber { get; private set; }

            public int Fragmentations { get; private set; }

            public double Share => (double)_found / _frames;

            /// <param name="number">Found under this one; null: missed.</param>
            public void Add(int? number)
            {
                _frames++;
                if (number == null)
                {
                    _isLost = _found > 0;
                    return;
                }

                Fragmentations += _isLost ? 1 : 0;
                _isLost = false;
                _found++;
                LastNumber = number;
            }
        }
    }
}
