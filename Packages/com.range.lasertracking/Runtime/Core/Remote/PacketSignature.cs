using System;
using System.Security.Cryptography;

namespace LaserTracking.Remote
{
    /// <summary>
    /// HMAC-SHA256 (RFC 2104) behind a packet: message, line feed, 64 lower-case hexadecimal digits. The code covers the message's
    /// bytes as they are, so that nobody has to agree on how JSON is written. One thread.
    /// </summary>
    internal sealed class PacketSignature : IDisposable
    {
        /// <summary>Line feed and digits.</summary>
        public const int Length = 1 + 2 * HashBytes;

        private const int HashBytes = 32;
        private const string Hex = "0123456789abcdef";

        private readonly HMACSHA256 _hash;

        public PacketSignature(RemoteKey key)
        {
            _hash = new HMACSHA256(key.ToArray());
        }

        /// <summary>True when the packet ends like a signed one.</summary>
        public static bool IsSigned(ReadOnlySpan<byte> packet)
        {
            if (packet.Length <= Length || packet[packet.Length - Length] != '\n')
                return false;
            foreach (byte digit in packet.Slice(packet.Length - Length + 1))
            {
                if (Hex.IndexOf((char)digit) < 0)
                    return false;
            }

            return true;
        }

        /// <summary>Compares in a time that does not depend on where they differ.</summary>
        public bool IsGenuine(ReadOnlySpan<byte> signedPacket)
        {
            Span<byte> expected = stackalloc byte[Length];
            Write(signedPacket.Slice(0, signedPacket.Length - Length), expected);
            return CryptographicOperations.FixedTimeEquals(expected, signedPacket.Slice(signedPacket.Length - Length));
        }

        /// <param name="message">What is signed.</param>
        /// <param name="signature">Gets <see cref="Length"/> bytes.</param>
        public void Write(ReadOnlySpan<byte> message, Span<byte> signature)
        {
            Span<byte> hash = stackalloc byte[HashBytes];
            _hash.TryComputeHash(message, hash, out _);
            signature[0] = (byte)'\n';
            for (int i = 0; i < HashBytes; i++)
            {
                signature[1 + 2 * i] = (byte)Hex[hash[i] >> 4];
                signature[2 + 2 * i] = (byte)Hex[hash[i] & 15];
            }
        }

        public void Dispose() => _hash.Dispose();
    }
}
