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

        /// <param name="baseQuantisation">Table of T.81 annex K, row by row.</param>
        /// <param name="quality">1…100, scaled as the Independent JPEG Group's library does.</param>
        /// <param name="dc">DHT content for DC.</param>
        /// <param name="ac">DHT content for AC.</param>
        public JpegBlockEncoder(byte[] baseQuantisation, int quality, byte[] dc, byte[] ac)
        {
            int scale = quality < 50 ? 5000 / quality : 200 - quality * 2;
            for (int i = 0; i < 64; i++)
                Quantisation[i] = (byte)Math.Min(255, Math.Max(1, (baseQuantisation[i] * scale + 50) / 100));
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
            int dc = Quantise(block[0], Quantisation[0] * 8);
            WriteCoefficient(dc - prediction, 0, _dcCodes, _dcLengths, output);
            prediction = dc;
            int run = 0;
            for (int k = 1; k < 64; k++)
            {
                int position = JpegTables.ZigZag[k];
                int value = Quantise(block[position], Quantisation[position] * 8);
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

        private static int Quantise(int value, int divisor) =>
            value < 0 ? -((divisor / 2 - value) / divisor) : (divisor / 2 + value) / divisor;

        private static void WriteCoefficient(int value, int run, ushort[] codes, byte[] lengths, JpegBitWriter output)
        {
            int size = 0;
            for (int magnitude = Math.Abs(value); magnitude > 0; magnitude >>= 1)
                size++;
            int symbol = run << 4 | size;
            output.Bits(codes[symbol], lengths[symbol]);
            output.Bits(value < 0 ? value - 1 : value, size);
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
