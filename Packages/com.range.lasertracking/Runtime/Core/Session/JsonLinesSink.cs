using System;
using System.IO;
using LaserTracking.Detection;

namespace LaserTracking.Session
{
    /// <summary>
    /// Writes a session as events.jsonl: header first, end last, in between one line an event in order of time (Documentation~/events.md).
    /// Lines are held back until <see cref="OnTimePassed"/> says that no earlier one can follow. The same events give the same bytes
    /// on every machine and in every culture, but for seconds_wall. No allocation per event once warm. Does not close the stream;
    /// what the stream throws passes through.
    /// </summary>
    public sealed class JsonLinesSink : IEventSink
    {
        /// <summary>Room for lines held back unless told otherwise, bytes: some ten frames full of rejected candidates.</summary>
        public const int DefaultMaximumHeldBytes = 4 << 20;

        private readonly Stream _stream;
        private readonly EventTypes _types;
        private readonly LineQueue _queue;
        private readonly Utf8JsonLineWriter _json = new Utf8JsonLineWriter();
        private HealthEvent _overflow;
        private int _overflowCount;
        private bool _shotWaits;
        private State _state;

        /// <param name="stream">Writable; stays the caller's.</param>
        /// <param name="types">Which types to write; header and end always are.</param>
        /// <param name="maximumHeldBytes">
        /// Room for lines held back. When it is full, dots and rejected candidates are left out and a health line counts them; other
        /// lines always find room.
        /// </param>
        public JsonLinesSink(Stream stream, EventTypes types = EventTypes.Default, int maximumHeldBytes = DefaultMaximumHeldBytes)
        {
            _stream = stream;
            _types = types;
            _queue = new LineQueue(Math.Max(maximumHeldBytes, 1024));
        }

        /// <summary>
        /// Leaves out the rejected candidates that every moving edge makes by the hundred: too faint, too small or not compact. Set before Begin.
        /// </summary>
        public bool SkipsOrdinaryRejected { get; set; }

        private static bool IsOrdinary(RejectionReason reason) =>
            reason == RejectionReason.TooFaint || reason == RejectionReason.TooSmall || reason == RejectionReason.NotCompact;

        private enum State
        {
            New,
            Open,
            Ended,
        }

        public void Begin(SessionHeader header)
        {
            if (_state != State.New)
                throw new InvalidOperationException("a session's events begin once");
            _state = State.Open;
            EventLines.Header(_json, header);
            WriteLine();
            _stream.Flush();
        }

        public void OnShot(in ShotEvent shot)
        {
            if (!Wants(EventTypes.Shots))
                return;
            EventLines.Shot(_json, shot);
            Hold(shot.Shot.TimeUs, EventTypes.Shots);
            _shotWaits = true;
        }

        public void OnDot(in DotEvent dot)
        {
            if (!Wants(EventTypes.Dots))
                return;
            EventLines.Dot(_json, dot);
            if (!Hold(dot.TimeUs, EventTypes.Dots))
                CountOverflow(dot.FrameIndex, dot.TimeUs);
        }

        public void OnHand(in HandEvent hand)
        {
            if (!Wants(EventTypes.Hands))
                return;
            EventLines.Hand(_json, hand);
            Hold(hand.TimeUs, EventTypes.Hands);
        }

        public void OnRejected(in RejectedEvent rejected)
        {
            if (!Wants(EventTypes.Rejected) || (SkipsOrdinaryRejected && IsOrdinary(rejected.Candidate.Reason)))
                return;
            EventLines.Rejected(_json, rejected);
            if (!Hold(rejected.TimeUs, EventTypes.Rejected))
                CountOverflow(rejected.FrameIndex, rejected.TimeUs);
        }

        public void OnHealth(in HealthEvent health)
        {
            if (!Wants(EventTypes.Health))
                return;
            EventLines.Health(_json, health);
            Hold(health.TimeUs, EventTypes.Health);
        }

        /// <summary>Writes what was held back with an earlier time; a stream with a reader at its end sees a shot at once.</summary>
        public void OnTimePassed(long timeUs)
        {
            if (_state != State.Open)
                return;
            HoldOverflow();
            if (_queue.WriteBefore(timeUs, _stream) == 0 || !_shotWaits)
                return;
            _stream.Flush();
            _shotWaits = _queue.Count > 0;
        }

        public void End(in SessionEnd end)
        {
            if (_state != State.Open)
                throw new InvalidOperationException("a session's events end once, after they began");
            _state = State.Ended;
            HoldOverflow();
            _queue.WriteAll(_stream);
            EventLines.End(_json, end);
            WriteLine();
            _stream.Flush();
        }

        private bool Wants(EventTypes type)
        {
            if (_state != State.Open)
                throw new InvalidOperationException("events belong between a session's begin and end");
            return (_types & type) != 0;
        }

        private bool Hold(long timeUs, EventTypes type)
        {
            bool held = _queue.TryAdd(timeUs, (int)type, _json.Written, type == EventTypes.Dots || type == EventTypes.Rejected);
            _json.Clear();
            return held;
        }

        private void CountOverflow(int frameIndex, long timeUs)
        {
            _overflowCount++;
            _overflow.FrameIndex = Math.Max(frameIndex, _overflow.FrameIndex);
            _overflow.TimeUs = _overflowCount == 1 ? timeUs : Math.Max(timeUs, _overflow.TimeUs);
        }

        private void HoldOverflow()
        {
            if (_overflowCount == 0)
                return;
            _overflow.Kind = HealthKind.Overflow;
            _overflow.Value = _overflowCount;
            _overflow.Text = "more lines waited for their turn than there is room for: dots or rejected candidates were left out";
            EventLines.Health(_json, _overflow);
            Hold(_overflow.TimeUs, EventTypes.Health);
            _overflow = default;
            _overflowCount = 0;
        }

        private void WriteLine()
        {
            _stream.Write(_json.Written);
            _json.Clear();
        }
    }
}
