using System;
using System.Security.Cryptography;
using LaserTracking.Geometry;
using LaserTracking.Session;

namespace LaserTracking.Remote
{
    /// <summary>
    /// Writes messages: a line of events.jsonl with version, stream, counter and time of sending before its members; or the published
    /// message. One thread. What it returns is good until the next call. No allocation once warm.
    /// </summary>
    internal sealed class MessageWriter : IDisposable
    {
        private readonly Utf8JsonLineWriter _json = new Utf8JsonLineWriter(2048);
        private readonly PacketSignature? _signature;
        private readonly long _stream;
        private readonly bool _saysWho;
        private byte[] _packet = new byte[2048];
        private long _counter;

        /// <param name="key">Signs with it; null: does not sign.</param>
        /// <param name="isReadAgain">A reader may see a message more than once, so that each says which it is.</param>
        public MessageWriter(RemoteKey? key, bool isReadAgain = false)
        {
            _saysWho = key != null || isReadAgain;
            _signature = key == null ? null : new PacketSignature(key);
            var random = new byte[8];
            RandomNumberGenerator.Fill(random);
            _stream = 1 + (long)(BitConverter.ToUInt64(random, 0) >> 12);
        }

        /// <summary>Without its hit, which is judged where the scene is.</summary>
        public ReadOnlySpan<byte> Shot(in ShotEvent shot, long nowUs)
        {
            ShotEvent sent = shot;
            sent.HasHit = false;
            Begin(nowUs, true);
            EventLines.ShotMembers(_json, sent);
            return End();
        }

        public ReadOnlySpan<byte> Hand(in HandEvent hand, long nowUs)
        {
            Begin(nowUs, true);
            EventLines.HandMembers(_json, hand);
            return End();
        }

        /// <summary>The published message; signed ones and those of files also say who sent them and when.</summary>
        public ReadOnlySpan<byte> Published(in RemotePose pose, bool isShot, long nowUs)
        {
            Begin(nowUs, false);
            _json.Name("timestamp");
            _json.Number(pose.TimeUs * 1e-6, 6);
            Vector("muzzle", pose.Muzzle, 3);
            Vector("target", pose.Target, 3);
            Vector("direction", pose.Direction, 6);
            _json.Name("confidence");
            _json.Number(pose.Confidence, 4);
            if (isShot)
            {
                _json.Name("shot");
                _json.True();
            }

            return End();
        }

        public void Dispose() => _signature?.Dispose();

        private void Begin(long nowUs, bool isOurs)
        {
            _json.Clear();
            _json.BeginObject();
            if (isOurs)
                Member("v", 1);
            if (!isOurs && !_saysWho)
                return;
            Member("stream", _stream);
            Member("counter", ++_counter);
            Member("sent_us", nowUs);
        }

        private ReadOnlySpan<byte> End()
        {
            _json.EndObject();
            if (_signature == null)
                return _json.Written;
            int length = _json.Length + PacketSignature.Length;
            if (length > _packet.Length)
                _packet = new byte[2 * length];
            _json.Written.CopyTo(_packet);
            _signature.Write(_json.Written, new Span<byte>(_packet, _json.Length, PacketSignature.Length));
            return new ReadOnlySpan<byte>(_packet, 0, length);
        }

        private void Member(string name, long value)
        {
            _json.Name(name);
            _json.Number(value);
        }

        private void Vector(string name, Vector3D value, int decimals)
        {
            _json.Name(name);
            _json.Vector(value, decimals);
        }
    }
}
