using System;

namespace LaserTracking.Tracking
{
    /// <summary>
    /// SORT (Bewley, Ge, Ott, Ramos, Upcroft 2016), with the same boxes as the authors' program: every frame is one step, detections
    /// go to predicted boxes by intersection over union. One thread at a time; allocates nothing once constructed. Work per frame is
    /// bounded by <see cref="MaxDetections"/> and <see cref="MaxTracks"/>.
    /// </summary>
    public sealed class SortTracker
    {
        /// <summary>More usable detections in a frame are ignored, the last ones first.</summary>
        public const int MaxDetections = 256;

        /// <summary>No more tracks than this live at a time; detections that would begin another are ignored.</summary>
        public const int MaxTracks = 1024;

        private readonly SortTrackerSettings _settings;
        private readonly HungarianAssignment _assignment = new HungarianAssignment(MaxTracks);
        private readonly BoundingBox[] _detections = new BoundingBox[MaxDetections];
        private readonly SortTrack[] _tracks = new SortTrack[MaxTracks];
        private readonly BoundingBox[] _predicted = new BoundingBox[MaxTracks];
        private readonly double[] _costs = new double[MaxDetections * MaxTracks];
        private readonly int[] _trackOfDetection = new int[MaxDetections];
        private readonly bool[] _isTaken = new bool[MaxTracks];
        private readonly TrackedBox[] _boxes = new TrackedBox[MaxTracks];
        private int _detectionCount;
        private int _trackCount;
        private int _boxCount;
        private int _frames;
        private int _lastId;

        /// <param name="settings">Defaults when absent. Copied.</param>
        /// <exception cref="ArgumentException">A setting is outside its range.</exception>
        public SortTracker(SortTrackerSettings? settings = null)
        {
            _settings = settings?.Clone() ?? new SortTrackerSettings();
            _settings.Validate();
        }

        /// <summary>What the last call reports, youngest track first, as the authors' program writes it.</summary>
        public ReadOnlySpan<TrackedBox> Boxes => new ReadOnlySpan<TrackedBox>(_boxes, 0, _boxCount);

        /// <summary>All tracks after the last call, those not reported too.</summary>
        public ReadOnlySpan<SortTrack> Tracks => new ReadOnlySpan<SortTrack>(_tracks, 0, _trackCount);

        /// <summary>Detections of the last call that were not used: not finite, without area, or too many.</summary>
        public int IgnoredDetections { get; private set; }

        /// <summary>Forgets everything and starts to count from 1 again.</summary>
        public void Reset() => _trackCount = _boxCount = _frames = _lastId = IgnoredDetections = 0;

        /// <summary>Takes the detections of the next frame; also the empty ones must be given.</summary>
        public void Process(ReadOnlySpan<BoundingBox> detections)
        {
            _frames++;
            Take(detections);
            PredictTracks();
            Assign();
            int predicted = _trackCount;
            for (int d = 0; d < _detectionCount; d++)
            {
                int track = _trackOfDetection[d];
                if (track >= 0 && -_costs[d * predicted + track] >= _settings.IouThreshold)
                    _tracks[track].Update(_detections[d]);
                else
                    Begin(_detections[d]);
            }

            Report();
        }

        private void Take(ReadOnlySpan<BoundingBox> detections)
        {
            _detectionCount = 0;
            foreach (BoundingBox box in detections)
            {
                if (_detectionCount == MaxDetections)
                    break;
                if (box.IsUsable)
                    _detections[_detectionCount++] = box;
            }

            IgnoredDetections = detections.Length - _detectionCount;
        }

        private void PredictTracks()
        {
            int kept = 0;
            for (int i = 0; i < _trackCount; i++)
            {
                _tracks[i].Predict();
                BoundingBox box = _tracks[i].Box;
                if (!box.IsUsable)
                    continue;
                _predicted[kept] = box;
                _tracks[kept++] = _tracks[i];
            }

            _trackCount = kept;
        }

        /// <summary>
        /// Costs are negative intersections over union. Where those above the threshold pair off by themselves they stand; otherwise
        /// the sum over all pairs is minimised and the threshold applies afterwards, which may pull good pairs apart. So does the original.
        /// </summary>
        private void Assign()
        {
            Array.Clear(_isTaken, 0, _trackCount);
            bool isUnique = true, isAny = false;
            for (int d = 0; d < _detectionCount; d++)
            {
                _trackOfDetection[d] = -1;
                for (int t = 0; t < _trackCount; t++)
                {
                    double iou = BoundingBox.IntersectionOverUnion(_detections[d], _predicted[t]);
                    _costs[d * _trackCount + t] = -iou;
                    if (!(iou > _settings.IouThreshold))
                        continue;
                    isUnique &= _trackOfDetection[d] < 0 && !_isTaken[t];
                    isAny = true;
                    _isTaken[t] = true;
                    _trackOfDetection[d] = t;
                }
            }

            if (!(isUnique && isAny))
                _assignment.Solve(new ReadOnlySpan<double>(_costs, 0, _detectionCount * _trackCount), _detectionCount, _trackCount, _trackOfDetection);
        }

        private void Begin(in BoundingBox box)
        {
            if (_trackCount < MaxTracks)
                _tracks[_trackCount++] = new SortTrack(++_lastId, box);
            else
                IgnoredDetections++;
        }

        private void Report()
        {
            _boxCount = 0;
            for (int i = _trackCount - 1; i >= 0; i--)
            {
                if (_tracks[i].TimeSinceUpdate < 1 && (_tracks[i].HitStreak >= _settings.MinHits || _frames <= _settings.MinHits))
                    _boxes[_boxCount++] = new TrackedBox(_tracks[i].Id, _tracks[i].Box);
            }

            int kept = 0;
            for (int i = 0; i < _trackCount; i++)
            {
                if (_tracks[i].TimeSinceUpdate <= _settings.MaxAge)
                    _tracks[kept++] = _tracks[i];
            }

            _trackCount = kept;
        }
    }
}
