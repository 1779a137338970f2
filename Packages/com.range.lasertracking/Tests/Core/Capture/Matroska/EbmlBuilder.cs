using System;
using System.Collections.Generic;
using System.Text;

namespace LaserTracking.Capture.Matroska
{
    /// <summary>Makes EBML elements for tests, right ones and wrong ones.</summary>
    public static class EbmlBuilder
    {
        public static byte[] Element(uint id, params byte[][] content) => Element(id, SizeField.Right, content);

        public static byte[] Element(uint id, SizeField size, params byte[][] content)
        {
            byte[] data = Join(content);
            switch (size)
            {
                case SizeField.Unknown: return Join(Id(id), new byte[] { 0x01, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF, 0xFF }, data);
                case SizeField.Zero: return Join(Id(id), Size(0, 8), data);
                case SizeField.TooLarge: return Join(Id(id), Size(data.Length + 100000, 8), data);
                case SizeField.Huge: return Join(Id(id), Size((1L << 56) - 2, 8), data);
                default: return Join(Id(id), Size(data.Length, data.Length < 100 ? 1 : 8), data);
            }
        }

        public static byte[] Unsigned(uint id, ulong value)
        {
            var bytes = new List<byte>();
            do
            {
                bytes.Insert(0, (byte)value);
                value >>= 8;
            }
            while (value != 0);
            return Element(id, bytes.ToArray());
        }

        public static byte[] Text(uint id, string text) => Element(id, Encoding.UTF8.GetBytes(text));

        public static byte[] Size(long value, int length)
        {
            var bytes = new byte[length];
            for (int i = length - 1; i >= 0; i--)
            {
                bytes[i] = (byte)value;
                value >>= 8;
            }

            bytes[0] |= (byte)(0x80 >> (length - 1));
            return bytes;
        }

        public static byte[] Join(params byte[][] parts)
        {
            var all = new List<byte>();
            foreach (byte[] part in parts)
                all.AddRange(part);
            return all.ToArray();
        }

        private static byte[] Id(uint id)
        {
            int length = id > 0xFFFFFF ? 4 : id > 0xFFFF ? 3 : id > 0xFF ? 2 : 1;
            var bytes = new byte[length];
            for (int i = length - 1; i >= 0; i--)
            {
                bytes[i] = (byte)id;
                id >>= 8;
            }

            return bytes;
        }

        /// <summary>What the size field of an element says.</summary>
        public enum SizeField
        {
            Right,
            Unknown,
            Zero,
            TooLarge,
            Huge,
        }
    }
}
