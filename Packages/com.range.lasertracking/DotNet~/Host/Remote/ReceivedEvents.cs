using System;
using System.Collections.Generic;
using LaserTracking.Remote;
using LaserTracking.Session;

namespace LaserTracking.Host.Remote
{
    /// <summary>Takes what lies in a remote inbox and passes it on as a session's events.</summary>
    internal sealed class ReceivedEvents
    {
        private readonly RemoteInbox _inbox;
        private readonly IEventSink _sink;
        private readonly RemotePose[] _poses = new RemotePose[RemoteInbox.PoseCapacity];
        private readonly Dictionary<(RemoteSpace, int), long> _seenUs = new();

        public ReceivedEvents(RemoteInbox inbox, IEventSink sink)
        {
            _inbox = inbox;
            _sink = sink;
        }

        public int Shots { get; private set; }

        /// <summary>Poses of our own message; of those that came between two looks only the newest.</summary>
        public int Hands { get; private set; }

        /// <summary>Published rays: they stand in camera 0's space and become hits in a scene, so they have no line of their own.</summary>
        public int Rays { get; private set; }

        /// <summary>Passes on what came since the last call.</summary>
        public void Drain()
        {
            while (_inbox.TryTakeShot(out RemoteShot shot))
            {
                Shots++;
                _sink.OnShot(shot.Event);
            }

            int count = _inbox.CopyPoses(_poses);
            for (int i = 0; i < count; i++)
            {
                RemotePose pose = _poses[i];
                if (_seenUs.TryGetValue((pose.Space, pose.TrackId), out long seenUs) && seenUs == pose.ReceivedTimeUs)
                    continue;
                _seenUs[(pose.Space, pose.TrackId)] = pose.ReceivedTimeUs;
                Pass(pose);
            }

            while (_inbox.TryTakeHealth(out HealthEvent health))
                Console.Error.WriteLine("range: " + health.Text);

            // Clocks of several senders have no common order: in order of arrival.
            _sink.OnTimePassed(long.MaxValue);
        }

        private void Pass(in RemotePose pose)
        {
            if (pose.Space == RemoteSpace.CameraMm)
            {
                Rays++;
                return;
            }

            Hands++;
            _sink.OnHand(new HandEvent { FrameIndex = -1, TimeUs = pose.TimeUs, TrackId = pose.TrackId, Side = pose.Hand, PalmM = pose.Palm, PalmSigmaM = pose.PalmSigmaM, MuzzleM = pose.Muzzle });
        }
    }
}
