using System;
using System.Collections.Generic;

namespace LaserTracking.Session
{
    /// <summary>
    /// Writes the events of a session whose shots are scored later and elsewhere: a shot's line waits until <see cref="Score"/> brings
    /// its hit, and with it every line that belongs behind it. Any thread; nobody waits for anything but a line's copy. Header and end
    /// are the session's own, not the pipeline's.
    /// </summary>
    public sealed class ScoredLaterSink : IEventSink
    {
        private const int ShotsInHand = 512;

        private readonly JsonLinesSink _lines;
        private readonly Queue<ShotEvent> _waiting = new Queue<ShotEvent>(ShotsInHand);
        private readonly object _lock = new object();
        private SessionEnd? _end;
        private bool _isFinished;

        /// <param name="lines">Not begun yet; used by this alone from now on. Its stream must not make anybody wait.</param>
        /// <param name="header">Written at once.</param>
        public ScoredLaterSink(JsonLinesSink lines, SessionHeader header)
        {
            _lines = lines;
            _lines.Begin(header);
        }

        /// <summary>How the pipeline ended; null: it goes on.</summary>
        public SessionEnd? PipelineEnd
        {
            get
            {
                lock (_lock)
                    return _end;
            }
        }

        public void Begin(SessionHeader header)
        {
        }

        public void OnShot(in ShotEvent shot)
        {
            lock (_lock)
            {
                if (!_isFinished)
                    _waiting.Enqueue(shot);
            }
        }

        /// <summary>A shot with its hit, in the order of the shots; one that was passed over has none.</summary>
        public void Score(in ShotEvent shot)
        {
            lock (_lock)
            {
                while (!_isFinished && _waiting.Count > 0 && _waiting.Peek().Shot.Id <= shot.Shot.Id)
                {
                    ShotEvent oldest = _waiting.Dequeue();
                    _lines.OnShot(oldest.Shot.Id == shot.Shot.Id ? shot : oldest);
                }
            }
        }

        public void OnDot(in DotEvent dot)
        {
            lock (_lock)
            {
                if (!_isFinished)
                    _lines.OnDot(dot);
            }
        }

        public void OnHand(in HandEvent hand)
        {
            lock (_lock)
            {
                if (!_isFinished)
                    _lines.OnHand(hand);
            }
        }

        public void OnRejected(in RejectedEvent rejected)
        {
            lock (_lock)
            {
                if (!_isFinished)
                    _lines.OnRejected(rejected);
            }
        }

        public void OnHealth(in HealthEvent health)
        {
            lock (_lock)
            {
                if (!_isFinished)
                    _lines.OnHealth(health);
            }
        }

        public void OnTimePassed(long timeUs)
        {
            lock (_lock)
            {
                if (_isFinished)
                    return;
                foreach (ShotEvent shot in _waiting)
                    timeUs = Math.Min(timeUs, shot.Shot.TimeUs);
                _lines.OnTimePassed(timeUs);
            }
        }

        public void End(in SessionEnd end)
        {
            lock (_lock)
            {
                if (!_isFinished)
                    _end = end;
            }
        }

        /// <summary>Writes what waits and the last line; what comes later is not this session's.</summary>
        /// <param name="end">For the last line: the pipeline's, or the session's own where the pipeline goes on.</param>
        public void Finish(in SessionEnd end)
        {
            lock (_lock)
            {
                if (_isFinished)
                    return;
                while (_waiting.Count > 0)
                    _lines.OnShot(_waiting.Dequeue());
                _lines.End(end);
                _isFinished = true;
            }
        }
    }
}
