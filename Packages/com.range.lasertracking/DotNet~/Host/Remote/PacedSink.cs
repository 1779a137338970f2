using System;
using System.Diagnostics;
using System.Threading;
using LaserTracking.Session;

namespace LaserTracking.Host.Remote
{
    /// <summary>Lets shots and hands through at the speed of their own clock, and counts them. After an interruption nothing more.</summary>
    internal sealed class PacedSink : IEventSink
    {
        private readonly IEventSink _sink;
        private readonly double _speed;
        private readonly CancellationToken _interrupted;
        private readonly Stopwatch _watch = new();
        private long _firstUs;

        /// <param name="sink">Gets them.</param>
        /// <param name="speed">1: as fast as they happened.</param>
        /// <param name="interrupted">Ends waiting.</param>
        public PacedSink(IEventSink sink, double speed, CancellationToken interrupted)
        {
            _sink = sink;
            _speed = speed;
            _interrupted = interrupted;
        }

        public int Shots { get; private set; }

        public int Hands { get; private set; }

        public void OnShot(in ShotEvent shot)
        {
            if (!WaitFor(shot.Shot.TimeUs))
                return;
            _sink.OnShot(shot);
            Shots++;
        }

        public void OnHand(in HandEvent hand)
        {
            if (!WaitFor(hand.TimeUs))
                return;
            _sink.OnHand(hand);
            Hands++;
        }

        public void Begin(SessionHeader header)
        {
        }

        public void OnDot(in DotEvent dot)
        {
        }

        public void OnRejected(in RejectedEvent rejected)
        {
        }

        public void OnHealth(in HealthEvent health)
        {
        }

        public void OnTimePassed(long timeUs)
        {
        }

        public void End(in SessionEnd end)
        {
        }

        private bool WaitFor(long timeUs)
        {
            if (!_watch.IsRunning)
            {
                _firstUs = timeUs;
                _watch.Start();
            }

            double aheadMs = (timeUs - _firstUs) / 1000.0 / _speed - _watch.Elapsed.TotalMilliseconds;
            // In steps: a wait may be longer than the runtime can count.
            while (aheadMs > 0 && !_interrupted.WaitHandle.WaitOne((int)Math.Min(Math.Ceiling(aheadMs), 60_000)))
                aheadMs = (timeUs - _firstUs) / 1000.0 / _speed - _watch.Elapsed.TotalMilliseconds;
            return !_interrupted.IsCancellationRequested;
        }
    }
}
