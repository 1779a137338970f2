using System;

namespace LaserTracking.Imaging
{
    /// <summary>Codes blocks of one kind (luma or chroma): transform, quantisation, standard Huffman code.</summary>
    internal sealed unsafe class JpegBlockEncoder
    {
        private readonly ushort[] _dcCodes = new ushort[256];
        private readonly byte[] _dcLengths = new byte[256];
        private readonly ushort[] _acCodes = new ushort[256];
        private readonly byte[] _acLengths = new byte[256];
        private readonly int[] _half = new int[64];
        private readonly long[] _reciprocal = new long[64];

        /// <param name="baseQuantisation">Table of T.81 annex K, row by row.</param>
        /// <param name="quality">1…100, scaled as the Independent JPEG Group's library does.</param>
        /// <param name="dc">DHT content for DC.</param>
        /// <param name="ac">DHT content for AC.</param>
        public JpegBlockEncoder(byte[] baseQuantisation, int quality, byte[] dc, byte[] ac)
        {
            int scale = quality < 50 ? 5000 / quality : 200 - quality * 2;
            for (int i = 0; i < 64; i++)
            {
                Quantisation[i] = (byte)Math.Min(255, Math.Max(1, (baseQuantisation[i] * scale + 50) / 100));

                // The transform's factor of 8 is taken out here. Rounded up, this gives exact quotients below 2^20.
                int divisor = Quantisation[i] * 8;
                _half[i] = divisor / 2;
                _reciprocal[i] = ((1L << 32) + divisor - 1) / divisor;
            }

            AssignCodes(dc, _dcCodes, _dcLengths);
            AssignCodes(ac, _acCodes, _acLengths);
        }

        /// <summary>Row by row.</summary>
        public byte[] Quantisation { get; } = new byte[64];

        /// <param name="block">64 samples less 128, row by row; destroyed.</param>
        /// <param name="prediction">The component's last DC value; updated.</param>
        /// <param name="output">Receives the bits.</param>
        public void Encode(int* block, ref int prediction, JpegBitWriter output)
        {
            JpegForwardDct.Transform(block);
            int dc = Quantise(block[0], 0);
            WriteCoefficient(dc - prediction, 0, _dcCodes, _dcLengths, output);
            prediction = dc;
            int run = 0;
            for (int k = 1; k < 64; k++)
            {
                int position = JpegTables.ZigZag[k];
                int value = Quantise(block[position], position);
                if (value == 0)
                {
                    run++;
                    continue;
                }

                for (; run > 15; run -= 16)
                    output.Bits(_acCodes[0xF0], _acLengths[0xF0]);
                WriteCoefficient(value, run, _acCodes, _acLengths, output);
                run = 0;
            }

            if (run > 0)
                output.Bits(_acCodes[0], _acLengths[0]);
        }

        private int Quantise(int value, int position)
        {
            int magnitude = (int)((Math.Abs(value) + _half[position]) * _reciprocal[position] >> 32);
            return value < 0 ? -magnitude : magnitude;
        }

        private static void WriteCoefficient(int value, int run, ushort[] codes, byte[] lengths, JpegBitWriter output)
        {
            int size = 0;
            for (int magnitude = Math.Abs(value); magnitude > 0; magnitude >>= 1)
                size++;
            int symbol = run << 4 | size;
            int bits = (value < 0 ? value - 1 : value) & ((1 << size) - 1);
            output.Bits(codes[symbol] << size | bits, lengths[symbol] + size);
        }

        private static void AssignCodes(byte[] definition, ushort[] codes, byte[] lengths)
        {
            int code = 0;
            int next = 16;
            for (int length = 1; length <= 16; length++, code <<= 1)
            {
                for (int i = 0; i < definition[length - 1]; i++, next++, code++)
                {
                    codes[definition[next]] = (ushort)code;
                    lengths[definition[next]] = (byte)length;
                }
            }
        }
    }
}
