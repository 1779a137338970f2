using System;
using LaserTracking.Session;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Carries events from the detector's thread to Unity's. Shots and health wait in order until they are taken, and what does not fit
    /// is counted; of dots and hands only the newest frame's count. Nothing is allocated after construction.
    /// </summary>
    internal sealed class EventInbox : IEventSink
    {
        /// <summary>Eight trainees with fifteen shots a second each fill it when Unity's thread stands still for four seconds.</summary>
        public const int ShotCapacity = 512;

        public const int HealthCapacity = 64;

        /// <summary>Dots or hands in one frame.</summary>
        public const int LatestCapacity = 32;

        private readonly object _lock = new object();
        private readonly Ring<ShotEvent> _shots = new Ring<ShotEvent>(ShotCapacity);
        private readonly Ring<HealthEvent> _health = new Ring<HealthEvent>(HealthCapacity);
        private readonly DotEvent[] _dots = new DotEvent[LatestCapacity];
        private readonly HandEvent[] _hands = new HandEvent[LatestCapacity];
        private int _dotCount;
        private int _dotFrame;
        private int _handCount;
        private int _handFrame;
        private int _toldOverflow;

        /// <summary>Shots and health lines that found no room.</summary>
        public int Overflow
        {
            get
            {
                lock (_lock)
                    return _shots.Lost + _health.Lost;
            }
        }

        public bool HasShots
        {
            get
            {
                lock (_lock)
                    return _shots.Count > 0;
            }
        }

        public bool TryTakeShot(out ShotEvent shot)
        {
            lock (_lock)
                return _shots.TryTake(out shot);
        }

        /// <summary>What was lost for want of room is told last, once for each time that it grew.</summary>
        public bool TryTakeHealth(out HealthEvent health)
        {
            lock (_lock)
            {
                if (_health.TryTake(out health))
                    return true;
                int lost = _shots.Lost + _health.Lost;
                if (lost == _toldOverflow)
                    return false;
                _toldOverflow = lost;
                health.Kind = HealthKind.Overflow;
                health.Value = lost;
                health.Text = FormattableString.Invariant($"Unity's thread stood still so long that {_shots.Lost} shots and {_health.Lost} messages were lost; find in the Profiler what holds it up");
                return true;
            }
        }

        /// <summary>The dots of the newest frame since the last call; returns how many.</summary>
        /// <param name="dots">Room for <see cref="LatestCapacity"/>.</param>
        public int TakeDots(DotEvent[] dots)
        {
            lock (_lock)
            {
                int count = _dotCount;
                Array.Copy(_dots, dots, count);
                _dotCount = 0;
                return count;
            }
        }

        /// <summary>The same for the hands of camera 1.</summary>
        public int TakeHands(HandEvent[] hands)
        {
            lock (_lock)
            {
                int count = _handCount;
                Array.Copy(_hands, hands, count);
                _handCount = 0;
                return count;
            }
        }

        public void OnShot(in ShotEvent shot)
        {
            lock (_lock)
                _shots.Add(shot);
        }

        public void OnHealth(in HealthEvent health)
        {
            lock (_lock)
                _health.Add(health);
        }

        public void OnDot(in DotEvent dot)
        {
            lock (_lock)
            {
                if (dot.FrameIndex != _dotFrame)
                    _dotCount = 0;
                _dotFrame = dot.FrameIndex;
                if (_dotCount < LatestCapacity)
                    _dots[_dotCount++] = dot;
            }
        }

        public void OnHand(in HandEvent hand)
        {
            lock (_lock)
            {
                if (hand.FrameIndex != _handFrame)
                    _handCount = 0;
                _handFrame = hand.FrameIndex;
                if (_handCount < LatestCapacity)
                    _hands[_handCount++] = hand;
            }
        }

        public void Begin(SessionHeader header)
        {
        }

        public void OnRejected(in RejectedEvent rejected)
        {
        }

        public void OnTimePassed(long timeUs)
        {
        }

        public void End(in SessionEnd end)
        {
        }

        private sealed class Ring<T>
        {
            private readonly T[] _items;
            private int _first;
            private int _count;

            public int Count => _count;

            public Ring(int capacity) => _items = new T[capacity];

            public int Lost { get; private set; }

            public void Add(in T item)
            {
                if (_count == _items.Length)
                    Lost++;
                else
                    _items[(_first + _count++) % _items.Length] = item;
            }

            public bool TryTake(out T item)
            {
                item = default!;
                if (_count == 0)
                    return false;
                item = _items[_first];
                _items[_first] = default!;
                _first = (_first + 1) % _items.Length;
                _count--;
                return true;
            }
        }
    }
}
