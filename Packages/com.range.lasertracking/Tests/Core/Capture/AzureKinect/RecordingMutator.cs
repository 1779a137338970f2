using System;
using System.Collections.Generic;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>Damages a recording in one to four ways that depend on a seed alone; knows where elements begin, so that heads suffer most.</summary>
    internal sealed class RecordingMutator
    {
        private static readonly byte[][] Ids =
        {
            new byte[] { 0x1A, 0x45, 0xDF, 0xA3 }, new byte[] { 0x18, 0x53, 0x80, 0x67 }, new byte[] { 0x1F, 0x43, 0xB6, 0x75 },
            new byte[] { 0x16, 0x54, 0xAE, 0x6B }, new byte[] { 0x1C, 0x53, 0xBB, 0x6B }, new byte[] { 0x12, 0x54, 0xC3, 0x67 },
            new byte[] { 0x19, 0x41, 0xA4, 0x69 }, new byte[] { 0x2A, 0xD7, 0xB1 }, new byte[] { 0x63, 0xA2 }, new byte[] { 0x46, 0x5C },
            new byte[] { 0xA3 }, new byte[] { 0xA0 }, new byte[] { 0xA1 }, new byte[] { 0xE7 }, new byte[] { 0xD7 }, new byte[] { 0xAE }, new byte[] { 0xBB },
        };

        private readonly byte[] _original;
        private readonly List<int> _sizeFields = new List<int>();

        public RecordingMutator(byte[] original)
        {
            _original = original;
            foreach (byte[] id in Ids)
            {
                int found = 0;
                for (int at = original.AsSpan().IndexOf(id); at >= 0 && found < 200; found++)
                {
                    _sizeFields.Add(at + id.Length);
                    int next = original.AsSpan(at + 1).IndexOf(id);
                    at = next < 0 ? -1 : at + 1 + next;
                }
            }
        }

        public byte[] Mutate(int seed)
        {
            var random = new Random(seed);
            byte[] bytes = (byte[])_original.Clone();
            for (int i = random.Next(4); i >= 0 && bytes.Length > 0; i--)
                bytes = MutateOnce(bytes, random);
            return bytes;
        }

        private byte[] MutateOnce(byte[] bytes, Random random)
        {
            int at = random.Next(bytes.Length);
            int length = Math.Min(1 + random.Next(1 << random.Next(1, 12)), bytes.Length - at);
            switch (random.Next(9))
            {
                case 0:
                    bytes[at] ^= (byte)(1 << random.Next(8));
                    return bytes;
                case 1:
                    random.NextBytes(bytes.AsSpan(at, Math.Min(length, 16)));
                    return bytes;
                case 2:
                    bytes.AsSpan(at, length).Fill(random.Next(2) == 0 ? (byte)0 : (byte)0xFF);
                    return bytes;
                case 3:
                    return bytes.AsSpan(0, at).ToArray();
                case 4:
                    return Join(bytes.AsSpan(0, at), default, bytes.AsSpan(at + length));
                case 5:
                    return Join(bytes.AsSpan(0, at), bytes.AsSpan(at, length), bytes.AsSpan(at));
                case 6:
                    int source = random.Next(bytes.Length - length + 1);
                    bytes.AsSpan(source, length).ToArray().CopyTo(bytes, at);
                    return bytes;
                default:
                    MutateSize(bytes, _sizeFields[random.Next(_sizeFields.Count)], random);
                    return bytes;
            }
        }

        /// <summary>Puts a size field of a chosen length: huge, unknown, zero, small, invalid.</summary>
        private static void MutateSize(byte[] bytes, int at, Random random)
        {
            byte[] field;
            switch (random.Next(7))
            {
                case 0: field = new byte[] { 0x01, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFE }; break;
                case 1: field = new byte[] { 0x01, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF }; break;
                case 2: field = new byte[] { 0x01, 0x10, 0, 0, 0, 0, 0, 0 }; break;
                case 3: field = new byte[] { 0x80 }; break;
                case 4: field = new byte[] { 0x00 }; break;
                case 5: field = new byte[] { 0x10, (byte)random.Next(256), (byte)random.Next(256), (byte)random.Next(256) }; break;
                default: field = new[] { (byte)random.Next(256) }; break;
            }

            if (at + field.Length <= bytes.Length)
                field.CopyTo(bytes, at);
        }

        private static byte[] Join(ReadOnlySpan<byte> first, ReadOnlySpan<byte> second, ReadOnlySpan<byte> third)
        {
            var joined = new byte[first.Length + second.Length + third.Length];
            first.CopyTo(joined);
            second.CopyTo(joined.AsSpan(first.Length));
            third.CopyTo(joined.AsSpan(first.Length + second.Length));
            return joined;
        }
    }
}
