using System;
using System.Collections.Generic;
using System.Net;
using LaserTracking.Detection;

namespace LaserTracking.Remote
{
    /// <summary>How remote input listens and whom it believes. Checked when a receiver is made from it.</summary>
    public sealed class RemoteSettings
    {
        /// <summary>The published system's port.</summary>
        public const int DefaultPort = 9997;

        /// <summary>Where it listens. Anything but this machine itself (127.0.0.1, ::1) needs a key and a list of senders.</summary>
        public IPAddress Address { get; set; } = IPAddress.Loopback;

        /// <summary>UDP port, 0…65535; 0: any free one.</summary>
        public int Port { get; set; } = DefaultPort;

        /// <summary>Secret shared with the senders; null: packets are not signed, which only this machine may do.</summary>
        public RemoteKey? Key { get; set; }

        /// <summary>Addresses that may send; empty: any, which only this machine's own may be.</summary>
        public IReadOnlyList<IPAddress> AllowedSenders { get; set; } = Array.Empty<IPAddress>();

        /// <summary>Oldest packet that counts, and how far ahead a sender's clock may be, milliseconds, 10…10000.</summary>
        public double MaximumAgeMs { get; set; } = 250;

        /// <summary>Packets a second that one sender may send, 1…10000, in any second.</summary>
        public int MaximumPacketsPerSecond { get; set; } = 500;

        /// <summary>Longest packet, bytes, 256…65507.</summary>
        public int MaximumPacketBytes { get; set; } = 2048;

        /// <summary>Shots that wait for the consumer, 16…65536: two seconds of the fastest sender.</summary>
        public int ShotCapacity { get; set; } = 1024;

        /// <exception cref="ArgumentException">A value is outside its range; the message names it.</exception>
        /// <exception cref="InputException">It would listen to the network without a key or a list of senders.</exception>
        public void Validate()
        {
            SettingCheck.InRange(nameof(Port), Port, 0, 65535);
            SettingCheck.InRange(nameof(MaximumAgeMs), MaximumAgeMs, 10, 10000);
            SettingCheck.InRange(nameof(MaximumPacketsPerSecond), MaximumPacketsPerSecond, 1, 10000);
            SettingCheck.InRange(nameof(MaximumPacketBytes), MaximumPacketBytes, 256, 65507);
            SettingCheck.InRange(nameof(ShotCapacity), ShotCapacity, 16, 65536);
            if (IPAddress.IsLoopback(Address))
                return;
            if (Key == null)
                throw new InputException("remote input on " + Address, "anybody on the network could send shots", "give it a key, or let it listen on 127.0.0.1");
            if (AllowedSenders.Count == 0)
                throw new InputException("remote input on " + Address, "the list of senders is empty", "name the addresses that may send");
        }
    }
}
