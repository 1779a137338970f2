using System;
using System.Collections.Generic;
using LaserTracking.Detection;

namespace LaserTracking.Session
{
    /// <summary>
    /// Keeps what a report needs of a session: every shot and health entry up to a bound, and counts of the rest. Dots and hands
    /// are only counted. Read it after the session's end or between two frames, on the pipeline's thread.
    /// </summary>
    public sealed class SessionRecorder : IEventSink
    {
        private readonly List<ShotEvent> _shots = new List<ShotEvent>(256);
        private readonly List<HealthEvent> _health = new List<HealthEvent>(64);
        private readonly int[] _rejectedByReason = new int[256];
        private readonly int[] _healthByKind = new int[256];
        private readonly int _maximumShots;
        private readonly int _maximumHealth;
        private long _firstEventUs = long.MaxValue;
        private SessionEnd _summary;

        /// <param name="maximumShots">Shots beyond are counted, not kept.</param>
        /// <param name="maximumHealth">Health entries beyond are counted, not kept.</param>
        public SessionRecorder(int maximumShots = 20000, int maximumHealth = 500)
        {
            _maximumShots = maximumShots;
            _maximumHealth = maximumHealth;
        }

        /// <summary>Null before the session begins.</summary>
        public SessionHeader? Header { get; private set; }

        /// <summary>False for a session that was interrupted; <see cref="Summary"/> means nothing then.</summary>
        public bool IsEnded { get; private set; }

        public SessionEnd Summary => _summary;

        /// <summary>In the order of reporting.</summary>
        public IReadOnlyList<ShotEvent> Shots => _shots;

        /// <summary>All shots, kept or not.</summary>
        public int ShotCount { get; private set; }

        /// <summary>The first ones, in the order of reporting.</summary>
        public IReadOnlyList<HealthEvent> Health => _health;

        /// <summary>All health entries, kept or not.</summary>
        public int HealthCount { get; private set; }

        public int RejectedCount { get; private set; }

        public int DotCount { get; private set; }

        public int HandCount { get; private set; }

        /// <summary>Filled by the pipeline's owner with <see cref="AddFrame"/>; empty for sessions read from a file.</summary>
        public FrameStatistics Frames { get; } = new FrameStatistics();

        /// <summary>When the screen was blind and how much of it; filled together with <see cref="Frames"/>.</summary>
        public BlindTimeline Blind { get; } = new BlindTimeline();

        /// <summary>Where the session's seconds begin: the first frame, or the first event when that is not known.</summary>
        public long StartTimeUs => _summary.StartTimeUs ?? (_firstEventUs == long.MaxValue ? 0 : _firstEventUs);

        /// <summary>Notes a frame: what it showed and cost.</summary>
        /// <param name="timeUs">Its time on the recording's clock.</param>
        /// <param name="blindShare">Share of the screen in which a dot could not be seen, 0…1.</param>
        /// <param name="processingMs">Frame in to events out, milliseconds; NaN when it was not measured.</param>
        public void AddFrame(long timeUs, double blindShare, double processingMs)
        {
            Frames.Add(blindShare, processingMs);
            Blind.Add(timeUs, blindShare);
        }

        public int CountOf(RejectionReason reason) => _rejectedByReason[(int)reason];

        public int CountOf(HealthKind kind) => _healthByKind[(int)kind];

        /// <summary>The shots by time, then number.</summary>
        public ShotEvent[] ShotsByTime()
        {
            ShotEvent[] shots = _shots.ToArray();
            Array.Sort(shots, (a, b) =>
                a.Shot.TimeUs != b.Shot.TimeUs ? a.Shot.TimeUs.CompareTo(b.Shot.TimeUs) : a.Shot.Id.CompareTo(b.Shot.Id));
            return shots;
        }

        public void Begin(SessionHeader header) => Header = header;

        public void OnShot(in ShotEvent shot)
        {
            NoteTime(shot.Shot.TimeUs);
            ShotCount++;
            if (_shots.Count < _maximumShots)
                _shots.Add(shot);
        }

        public void OnDot(in DotEvent dot)
        {
            NoteTime(dot.TimeUs);
            DotCount++;
        }

        public void OnHand(in HandEvent hand)
        {
            NoteTime(hand.TimeUs);
            HandCount++;
        }

        public void OnRejected(in RejectedEvent rejected)
        {
            NoteTime(rejected.TimeUs);
            RejectedCount++;
            _rejectedByReason[(int)rejected.Candidate.Reason]++;
        }

        public void OnHealth(in HealthEvent health)
        {
            HealthCount++;
            _healthByKind[(int)health.Kind]++;
            if (_health.Count < _maximumHealth)
                _health.Add(health);
        }

        public void OnTimePassed(long timeUs)
        {
        }

        public void End(in SessionEnd end)
        {
            _summary = end;
            IsEnded = true;
        }

        private void NoteTime(long timeUs) => _firstEventUs = Math.Min(_firstEventUs, timeUs);
    }
}
