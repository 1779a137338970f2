using System;
using System.Collections.Generic;
using System.Net;

namespace LaserTracking.Remote
{
    /// <summary>
    /// Decides about each packet, cheapest test first: size, address, signature, text, message, age, counter, rate. With a key nothing
    /// that is not genuine gets as far as being parsed or as using up a genuine sender's share. One thread; the inbox is shared.
    /// </summary>
    internal sealed class RemoteGate : IDisposable
    {
        private const int MostSenders = 16;

        private readonly RemoteSettings _settings;
        private readonly RemoteInbox _inbox;
        private readonly PacketSignature? _signature;
        private readonly IPAddress[] _allowed;
        private readonly SenderRecord[] _senders = new SenderRecord[MostSenders];
        private readonly long _maximumAgeUs;

        /// <param name="settings">Valid; not changed any more.</param>
        /// <param name="inbox">Gets what is accepted, and the count of what is not.</param>
        public RemoteGate(RemoteSettings settings, RemoteInbox inbox)
        {
            _settings = settings;
            _inbox = inbox;
            _signature = settings.Key == null ? null : new PacketSignature(settings.Key);
            _allowed = new List<IPAddress>(settings.AllowedSenders).ToArray();
            _maximumAgeUs = (long)(settings.MaximumAgeMs * 1000);
            for (int i = 0; i < MostSenders; i++)
                _senders[i] = new SenderRecord(settings.MaximumPacketsPerSecond);
        }

        /// <summary>Takes in one packet or counts why not.</summary>
        public RemoteDrop Accept(ReadOnlySpan<byte> packet, IPEndPoint sender, long nowUs)
        {
            RemoteMessage message = default;
            RemoteDrop drop = CheckPacket(packet, sender.Address);
            if (drop == RemoteDrop.None)
                drop = RemoteMessageReader.Read(WithoutSignature(packet), out message);
            // Without a counter anybody could send a signed packet once more.
            if (drop == RemoteDrop.None && _signature != null && !message.HasHead)
                drop = RemoteDrop.WrongField;
            if (drop == RemoteDrop.None)
                drop = Admit(message, sender.GetHashCode(), nowUs, false);
            if (drop != RemoteDrop.None)
                _inbox.Count(drop, nowUs);
            return drop;
        }

        /// <summary>
        /// Takes in a message that lies in a file and may have been read there before; that is no replay and not counted as one.
        /// </summary>
        public RemoteDrop AcceptFromFile(in RemoteMessage message, long nowUs)
        {
            RemoteDrop drop = Admit(message, 0, nowUs, true);
            if (drop != RemoteDrop.None)
                _inbox.Count(drop, nowUs);
            return drop;
        }

        public void Dispose() => _signature?.Dispose();

        private RemoteDrop CheckPacket(ReadOnlySpan<byte> packet, IPAddress sender)
        {
            if (packet.Length > _settings.MaximumPacketBytes)
                return RemoteDrop.Oversized;
            if (_allowed.Length > 0 && Array.IndexOf(_allowed, sender) < 0)
                return RemoteDrop.NotAllowed;
            bool isSigned = PacketSignature.IsSigned(packet);
            if (_signature == null)
                return isSigned ? RemoteDrop.NoKey : RemoteDrop.None;
            return !isSigned ? RemoteDrop.Unsigned : _signature.IsGenuine(packet) ? RemoteDrop.None : RemoteDrop.Forged;
        }

        private ReadOnlySpan<byte> WithoutSignature(ReadOnlySpan<byte> packet) =>
            _signature == null ? packet : packet.Slice(0, packet.Length - PacketSignature.Length);

        private RemoteDrop Admit(in RemoteMessage message, int endPoint, long nowUs, bool mayBeOld)
        {
            long identity = message.HasHead ? message.Stream : endPoint;
            SenderRecord? sender = Find(identity, message.HasHead);
            if (message.HasHead)
            {
                if (sender != null && sender.Packets.HasSeen(message.Counter))
                    return mayBeOld ? RemoteDrop.None : RemoteDrop.Replayed;
                if (message.SentUs < nowUs - _maximumAgeUs || message.SentUs > nowUs + _maximumAgeUs)
                    return RemoteDrop.Stale;
            }

            sender ??= Add(identity, message.HasHead, nowUs);
            if (sender == null)
                return RemoteDrop.TooManySenders;
            if (!sender.Rate.TryTake(nowUs))
                return RemoteDrop.TooFast;
            sender.LastUs = nowUs;
            if (message.HasHead)
                sender.Packets.Mark(message.Counter);
            Deliver(message, sender, nowUs);
            return RemoteDrop.None;
        }

        private void Deliver(in RemoteMessage message, SenderRecord sender, long nowUs)
        {
            _inbox.CountAccepted();
            if (message.IsPose)
            {
                RemotePose pose = message.Pose;
                pose.ReceivedTimeUs = nowUs;
                _inbox.SetPose(pose);
            }

            int id = message.Shot.Event.Shot.Id;
            if (!message.IsShot || (id > 0 && sender.Shots.HasSeen(id)))
                return;
            RemoteShot shot = message.Shot;
            shot.ReceivedTimeUs = nowUs;
            shot.Aim.ReceivedTimeUs = nowUs;
            // A shot without room is not marked: when it is repeated there may be some.
            if (_inbox.TryAddShot(shot) && id > 0)
                sender.Shots.Mark(id);
        }

        private SenderRecord? Find(long identity, bool hasStream)
        {
            foreach (SenderRecord sender in _senders)
            {
                if (sender.IsUsed && sender.Identity == identity && sender.HasStream == hasStream)
                    return sender;
            }

            return null;
        }

        /// <summary>Null when every place belongs to a sender that may still be there, or whose packets could still be replayed.</summary>
        private SenderRecord? Add(long identity, bool hasStream, long nowUs)
        {
            long forgetUs = Math.Max(1_000_000, 4 * _maximumAgeUs);
            foreach (SenderRecord sender in _senders)
            {
                if (sender.IsUsed && nowUs - sender.LastUs < forgetUs)
                    continue;
                sender.Begin(identity, hasStream);
                return sender;
            }

            return null;
        }
    }
}
