using System.Collections.Generic;
using LaserTracking.Session;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Holds shots until the pipeline is done with the frame: a listener that throws must not stop the pipeline half-way. What the
    /// operator should know goes to the Console.
    /// </summary>
    internal sealed class ShotQueue : IEventSink
    {
        private readonly Queue<ShotEvent> _shots = new Queue<ShotEvent>();
        private readonly Object _context;

        /// <param name="context">Object that the Console shows beside a message.</param>
        public ShotQueue(Object context)
        {
            _context = context;
        }

        public bool TryTake(out ShotEvent shot)
        {
            bool any = _shots.Count > 0;
            shot = any ? _shots.Dequeue() : default;
            return any;
        }

        public void OnShot(in ShotEvent shot) => _shots.Enqueue(shot);

        public void OnHealth(in HealthEvent health) => Debug.LogWarning("Laser range, frame " + health.FrameIndex + ": " + health.Text, _context);

        public void Begin(SessionHeader header)
        {
        }

        public void OnDot(in DotEvent dot)
        {
        }

        public void OnHand(in HandEvent hand)
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
    }
}
