using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Host.Scoring;
using LaserTracking.Host.Studies.Clips;

namespace LaserTracking.Host.Studies.Evidence
{
    /// <summary>Labelled candidates of the recorded clips as they are and stressed, of dots pasted into them, and of simulated ranges.</summary>
    internal sealed class CandidateSet
    {
        public const string SimulationCase = "simulated";

        private readonly StudyOptions _options;
        private readonly CancellationToken _interrupted;
        private readonly List<string> _cases = new();
        private readonly List<WeighedCandidate> _candidates = new();

        private CandidateSet(StudyOptions options, CancellationToken interrupted)
        {
            _options = options;
            _interrupted = interrupted;
        }

        public IReadOnlyList<string> Cases => _cases;

        public IReadOnlyList<WeighedCandidate> Candidates => _candidates;

        /// <summary>What the features are called and are reasons for, in the order of <see cref="DotFeature"/>.</summary>
        public TestOutcome[] Measures { get; private set; } = [];

        /// <summary>The reference data were there.</summary>
        public bool HasClips { get; private set; }

        public static CandidateSet Collect(StudyOptions options, CancellationToken interrupted)
        {
            var set = new CandidateSet(options, interrupted);
            if (ClipSet.TryOpen() is { } clips)
            {
                set.HasClips = true;
                set.AddStressed(clips);
                set.AddPasted(clips);
            }

            if (options.Includes(SimulationCase))
                set.AddSimulated();
            return set;
        }

        private void AddStressed(ClipSet clips)
        {
            PictureStress[] cases = PictureStress.All().Where(c => _options.Includes(c.Name)).ToArray();
            int firstCase = _cases.Count;
            _cases.AddRange(cases.Select(c => c.Name));
            for (int group = 0; group < clips.Clips.Count && cases.Length > 0; group++)
            {
                TruthClip clip = clips.Clips[group];
                CandidateCollector[] collectors = cases.Select(_ => new CandidateCollector()).ToArray();
                StressedClip.Play(clips, clip, cases, _options, (i, frame, shiftPx) => collectors[i].Process(frame, shiftPx), _interrupted);
                for (int i = 0; i < cases.Length; i++)
                    Add(collectors[i], firstCase + i, group, clip.Shots, []);
            }
        }

        private void AddPasted(ClipSet clips)
        {
            PastedCase[] cases = PastedCase.All().Where(c => _options.Includes(c.Name)).ToArray();
            if (cases.Length == 0)
                return;
            List<DotTemplate> templates = DotTemplate.CutAll(clips, _options.Progress.Show);
            foreach (PastedCase pasted in cases)
            {
                var random = new Random(_options.FirstSeed);
                for (int group = 0; group < clips.Clips.Count; group++)
                {
                    TruthClip clip = clips.Clips[group];
                    _options.Progress.Show(pasted.Name + ", " + clip.File);
                    var collector = new CandidateCollector();
                    TruthClip truth = pasted.Play(clips, clip, templates, random, frame => collector.Process(frame, default), _interrupted);
                    Add(collector, _cases.Count, group, truth.Shots.Concat(clip.Shots).ToArray(), []);
                }

                _cases.Add(pasted.Name);
            }
        }

        private void AddSimulated()
        {
            int firstGroup = 1 + _candidates.Select(c => c.Group).DefaultIfEmpty(-1).Max();
            for (int seed = _options.FirstSeed; seed <= _options.LastSeed && !_interrupted.IsCancellationRequested; seed++)
            {
                _options.Progress.Show(FormattableString.Invariant($"simulated range, seed {seed}"));
                var random = new RandomRange(seed);
                var collector = new CandidateCollector();
                using IFrameSource source = new PrefetchingFrameSource(random.Range.CreateColorSource());
                using var frame = new Frame();
                while (!_interrupted.IsCancellationRequested && source.TryRead(frame))
                    collector.Process(frame, default(Vector2D));
                Add(collector, _cases.Count, firstGroup + seed - _options.FirstSeed, random.Shots, random.WeakShots);
            }

            _cases.Add(SimulationCase);
        }

        private void Add(CandidateCollector collector, int caseIndex, int group, IReadOnlyList<TruthShot> shots, IReadOnlyList<TruthShot> neither)
        {
            _candidates.AddRange(collector.Label(caseIndex, group, shots, neither));
            if (Measures.Length == 0)
                Measures = collector.Measures;
        }
    }
}
