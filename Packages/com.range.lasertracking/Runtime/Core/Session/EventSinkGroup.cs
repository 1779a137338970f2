using System.Collections.Generic;

namespace LaserTracking.Session
{
    /// <summary>Hands every event to several sinks, in their order.</summary>
    public sealed class EventSinkGroup : IEventSink
    {
        private readonly IEventSink[] _sinks;

        public EventSinkGroup(IReadOnlyCollection<IEventSink> sinks)
        {
            _sinks = new IEventSink[sinks.Count];
            int count = 0;
            foreach (IEventSink sink in sinks)
                _sinks[count++] = sink;
        }

        public void Begin(SessionHeader header)
        {
            foreach (IEventSink sink in _sinks)
                sink.Begin(header);
        }

        public void OnShot(in ShotEvent shot)
        {
            foreach (IEventSink sink in _sinks)
                sink.OnShot(shot);
        }

        public void OnDot(in DotEvent dot)
        {
            foreach (IEventSink sink in _sinks)
                sink.OnDot(dot);
        }

        public void OnHand(in HandEvent hand)
        {
            foreach (IEventSink sink in _sinks)
                sink.OnHand(hand);
        }

        public void OnRejected(in RejectedEvent rejected)
        {
            foreach (IEventSink sink in _sinks)
                sink.OnRejected(rejected);
        }

        public void OnHealth(in HealthEvent health)
        {
            foreach (IEventSink sink in _sinks)
                sink.OnHealth(health);
        }

        public void OnTimePassed(long timeUs)
        {
            foreach (IEventSink sink in _sinks)
                sink.OnTimePassed(timeUs);
        }

        public void End(in SessionEnd end)
        {
            foreach (IEventSink sink in _sinks)
                sink.End(end);
        }
    }
}
