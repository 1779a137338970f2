using System;
using LaserTracking.Session;

namespace LaserTracking.Remote
{
    /// <summary>Takes shots and hands to another process: over UDP or through a file. Calls come from any thread and never wait.</summary>
    public interface IRemoteSender : IDisposable
    {
        /// <summary>Shots that were given up.</summary>
        long LostShots { get; }

        /// <summary>Times that the network or the disk refused.</summary>
        long Failures { get; }

        /// <summary>Queues a shot. Its id must be 1 or more and grow within this sender's life.</summary>
        void SendShot(in ShotEvent shot);

        /// <summary>Sends a hand; a newer one of the same hand may take its place.</summary>
        void SendHand(in HandEvent hand);

        /// <summary>Sends the published message; a pose may be left out.</summary>
        void SendPublished(in RemotePose pose, bool isShot);
    }
}
