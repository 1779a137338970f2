using System;

namespace LaserTracking.Imaging
{
    /// <summary>
    /// Reads everything in front of the entropy-coded data (ITU-T T.81 annex B). Used again for every picture, so that the tables of
    /// a camera are built once.
    /// </summary>
    internal sealed class JpegFrameHeader
    {
        private static readonly JpegHuffmanTable[] StandardDc =
        {
            new JpegHuffmanTable(JpegTables.LuminanceDc), new JpegHuffmanTable(JpegTables.ChrominanceDc),
        };

        private static readonly JpegHuffmanTable[] StandardAc =
        {
            new JpegHuffmanTable(JpegTables.LuminanceAc), new JpegHuffmanTable(JpegTables.ChrominanceAc),
        };

        private readonly JpegHuffmanTable[] _dc = { new JpegHuffmanTable(), new JpegHuffmanTable(), new JpegHuffmanTable(), new JpegHuffmanTable() };
        private readonly JpegHuffmanTable[] _ac = { new JpegHuffmanTable(), new JpegHuffmanTable(), new JpegHuffmanTable(), new JpegHuffmanTable() };
        private int _definedDc;
        private int _definedAc;
        private int _definedQuantisation;
        private bool _hasFrame;
        private int _adobeTransform;

        /// <summary>Four tables of 64 factors in zigzag order.</summary>
        public readonly ushort[] Quantisation = new ushort[4 * 64];

        public readonly JpegComponent[] Components = new JpegComponent[3];

        public int Width { get; private set; }

        public int Height { get; private set; }

        public int ComponentCount { get; private set; }

        public int MaxHorizontal { get; private set; }

        public int MaxVertical { get; private set; }

        /// <summary>Blocks in a unit (MCU), at most 10.</summary>
        public int BlocksPerUnit { get; private set; }

        /// <summary>Units between restart markers; 0 = none.</summary>
        public int RestartInterval { get; private set; }

        /// <summary>First byte of the entropy-coded data.</summary>
        public int DataOffset { get; private set; }

        /// <summary>The components are red, green and blue instead of luma and chroma.</summary>
        public bool IsRgb { get; private set; }

        public JpegHuffmanTable DcTable(int component)
        {
            int index = Components[component].DcTable;
            return (_definedDc >> index & 1) != 0 ? _dc[index] : StandardDc[index & 1];
        }

        public JpegHuffmanTable AcTable(int component)
        {
            int index = Components[component].AcTable;
            return (_definedAc >> index & 1) != 0 ? _ac[index] : StandardAc[index & 1];
        }

        public bool TryRead(ReadOnlySpan<byte> jpeg, out string problem)
        {
            _definedDc = _definedAc = _definedQuantisation = 0;
            _hasFrame = false;
            _adobeTransform = -1;
            RestartInterval = 0;
            if (jpeg.Length < 4 || jpeg[0] != 0xFF || jpeg[1] != 0xD8)
                return Fail(out problem, jpeg.IsEmpty ? "JPEG is empty" : "not a JPEG (its first bytes are not FF D8)");

            int at = 2;
            while (true)
            {
                if (at + 1 >= jpeg.Length)
                    return Fail(out problem, "JPEG ends early at byte " + jpeg.Length + ", in its header");
                if (jpeg[at] != 0xFF)
                    return Fail(out problem, "JPEG header damaged at byte " + at);
                int marker = jpeg[at + 1];
                if (marker == 0xFF)
                {
                    at++;
                    continue;
                }

                int start = at;
                at += 2;
                if (marker == 0x01 || (marker >= 0xD0 && marker <= 0xD7))
                    continue;
                if (marker == 0 || marker == 0xD8 || marker == 0xD9)
                    return Fail(out problem, "JPEG header damaged at byte " + start);
                if (at + 2 > jpeg.Length)
                    return Fail(out problem, "JPEG ends early at byte " + jpeg.Length + ", in its header");
                int length = jpeg[at] << 8 | jpeg[at + 1];
                if (length < 2)
                    return Fail(out problem, "JPEG header damaged at byte " + start);
                if (at + length > jpeg.Length)
                    return Fail(out problem, "JPEG ends early at byte " + jpeg.Length + ", in its header");
                ReadOnlySpan<byte> content = jpeg.Slice(at + 2, length - 2);
                at += length;

                if (marker == 0xDA)
                {
                    DataOffset = at;
                    return TryReadScan(content, start, out problem);
                }

                if (!TryReadSegment(marker, content, out string? reason))
                    return Fail(out problem, reason ?? "JPEG header damaged at byte " + start);
            }
        }

        private static bool Fail(out string problem, string what)
        {
            problem = what;
            return false;
        }

        /// <summary>On failure the reason, or null for plain damage.</summary>
        private bool TryReadSegment(int marker, ReadOnlySpan<byte> content, out string? reason)
        {
            reason = null;
            switch (marker)
            {
                case 0xC0:
                case 0xC1:
                    return TryReadFrame(content, out reason);
                case 0xC4:
                    return TryReadHuffman(content);
                case 0xDB:
                    return TryReadQuantisation(content);
                case 0xDD:
                    if (content.Length < 2)
                        return false;
                    RestartInterval = content[0] << 8 | content[1];
                    return true;
                case 0xEE:
                    if (content.Length >= 12 && content[0] == 'A' && content[1] == 'd' && content[2] == 'o')
                        _adobeTransform = content[11];
                    return true;
                case 0xC2:
                case 0xC6:
                    reason = "progressive JPEG is not supported, only baseline";
                    return false;
                case 0xC9:
                case 0xCA:
                case 0xCB:
                case 0xCC:
                case 0xCD:
                case 0xCE:
                case 0xCF:
                    reason = "JPEG with arithmetic coding is not supported, only baseline";
                    return false;
                case 0xC3:
                case 0xC5:
                case 0xC7:
                case 0xC8:
                    reason = "lossless or hierarchical JPEG is not supported, only baseline";
                    return false;
                default:
                    return true;
            }
        }

        private bool TryReadFrame(ReadOnlySpan<byte> content, out string? reason)
        {
            reason = null;
            if (_hasFrame || content.Length < 6)
                return false;
            if (content[0] != 8)
            {
                reason = "JPEG with " + content[0] + " bits a sample is not supported, only 8";
                return false;
            }

            Height = content[1] << 8 | content[2];
            Width = content[3] << 8 | content[4];
            ComponentCount = content[5];
            if (Width == 0 || Height == 0)
            {
                reason = "JPEG without a size is not supported";
                return false;
            }

            if (ComponentCount != 1 && ComponentCount != 3)
            {
                reason = "JPEG with " + ComponentCount + " components is not supported, only grey and colour";
                return false;
            }

            if (content.Length < 6 + 3 * ComponentCount)
                return false;
            MaxHorizontal = MaxVertical = 1;
            BlocksPerUnit = 0;
            for (int i = 0; i < ComponentCount; i++)
            {
                ref JpegComponent component = ref Components[i];
                component.Id = content[6 + 3 * i];
                // A lone component is coded block by block, whatever its factors say.
                component.Horizontal = ComponentCount == 1 ? 1 : content[7 + 3 * i] >> 4;
                component.Vertical = ComponentCount == 1 ? 1 : content[7 + 3 * i] & 15;
                component.QuantisationTable = content[8 + 3 * i];
                component.FirstBlock = BlocksPerUnit;
                if (component.Horizontal < 1 || component.Horizontal > 4 || component.Vertical < 1 || component.Vertical > 4)
                    return false;
                if (component.QuantisationTable > 3)
                    return false;
                BlocksPerUnit += component.Horizontal * component.Vertical;
                MaxHorizontal = Math.Max(MaxHorizontal, component.Horizontal);
                MaxVertical = Math.Max(MaxVertical, component.Vertical);
            }

            _hasFrame = BlocksPerUnit <= 10;
            return _hasFrame;
        }

        private bool TryReadScan(ReadOnlySpan<byte> content, int start, out string problem)
        {
            if (!_hasFrame || content.Length < 1)
                return Fail(out problem, "JPEG header damaged at byte " + start);
            if (content[0] != ComponentCount)
                return Fail(out problem, "JPEG with its components in several scans is not supported");
            if (content.Length < 4 + 2 * ComponentCount)
                return Fail(out problem, "JPEG header damaged at byte " + start);
            for (int i = 0; i < ComponentCount; i++)
            {
                ref JpegComponent component = ref Components[i];
                int tables = content[2 + 2 * i];
                component.DcTable = tables >> 4;
                component.AcTable = tables & 15;
                if (content[1 + 2 * i] != component.Id || component.DcTable > 3 || component.AcTable > 3)
                    return Fail(out problem, "JPEG header damaged at byte " + start);
                if ((_definedQuantisation >> component.QuantisationTable & 1) == 0)
                    return Fail(out problem, "JPEG lacks quantisation table " + component.QuantisationTable);
            }

            IsRgb = ComponentCount == 3 && (_adobeTransform == 0
                || (_adobeTransform < 0 && Components[0].Id == 'R' && Components[1].Id == 'G' && Components[2].Id == 'B'));
            problem = string.Empty;
            return true;
        }

        private bool TryReadQuantisation(ReadOnlySpan<byte> content)
        {
            while (!content.IsEmpty)
            {
                int precision = content[0] >> 4;
                int index = content[0] & 15;
                int size = 64 * (precision + 1);
                if (precision > 1 || index > 3 || content.Length < 1 + size)
                    return false;
                for (int i = 0; i < 64; i++)
                {
                    Quantisation[index * 64 + i] =
                        precision == 0 ? content[1 + i] : (ushort)(content[1 + 2 * i] << 8 | content[2 + 2 * i]);
                }

                _definedQuantisation |= 1 << index;
                content = content.Slice(1 + size);
            }

            return true;
        }

        private bool TryReadHuffman(ReadOnlySpan<byte> content)
        {
            while (!content.IsEmpty)
            {
                bool isAc = content[0] >> 4 == 1;
                int index = content[0] & 15;
                if (content[0] >> 4 > 1 || index > 3 || content.Length < 17)
                    return false;
                int symbols = 0;
                for (int i = 1; i <= 16; i++)
                    symbols += content[i];
                if (symbols > 256 || content.Length < 17 + symbols)
                    return false;
                if (!isAc)
                {
                    // The difference of two DC values has at most 11 bits.
                    for (int i = 0; i < symbols; i++)
                    {
                        if (content[17 + i] > 11)
                            return false;
                    }
                }

                if (!(isAc ? _ac : _dc)[index].TryBuild(content.Slice(1, 16 + symbols)))
                    return false;
                if (isAc)
                    _definedAc |= 1 << index;
                else
                    _definedDc |= 1 << index;
                content = content.Slice(17 + symbols);
            }

            return true;
        }
    }
}
