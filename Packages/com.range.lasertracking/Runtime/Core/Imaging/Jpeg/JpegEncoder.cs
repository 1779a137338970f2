using System;

namespace LaserTracking.Imaging
{
    /// <summary>
    /// Raw pixels to baseline JPEG, for simulated cameras and tests; the same bytes on every machine. <see cref="PixelFormat.Yuy2"/>
    /// and <see cref="PixelFormat.Bgra32"/> become 4:2:2, <see cref="PixelFormat.Nv12"/> 4:2:0, <see cref="PixelFormat.Gray8"/> grey.
    /// Not thread-safe; allocates nothing once warm.
    /// </summary>
    public sealed unsafe class JpegEncoder
    {
        private readonly JpegBlockEncoder _luma;
        private readonly JpegBlockEncoder _chroma;
        private readonly int _restartInterval;
        private readonly bool _writeHuffmanTables;
        private readonly JpegBitWriter _output = new JpegBitWriter();

        /// <param name="quality">1 (worst) … 100, on the scale of the Independent JPEG Group.</param>
        /// <param name="restartInterval">Units (16×8, 16×16 or 8×8 pixels) between restart markers, 0…65535; 0 = none.</param>
        /// <param name="writeHuffmanTables">False leaves the standard tables out, as many webcams do.</param>
        public JpegEncoder(int quality = 90, int restartInterval = 0, bool writeHuffmanTables = true)
        {
            if (quality < 1 || quality > 100)
                throw new ArgumentOutOfRangeException(nameof(quality), "1…100");
            if (restartInterval < 0 || restartInterval > 0xFFFF)
                throw new ArgumentOutOfRangeException(nameof(restartInterval), "0…65535");
            _luma = new JpegBlockEncoder(JpegTables.LuminanceQuantisation, quality, JpegTables.LuminanceDc, JpegTables.LuminanceAc);
            _chroma = new JpegBlockEncoder(JpegTables.ChrominanceQuantisation, quality, JpegTables.ChrominanceDc, JpegTables.ChrominanceAc);
            _restartInterval = restartInterval;
            _writeHuffmanTables = writeHuffmanTables;
        }

        /// <summary>The JPEG of a colour or grey picture of at most 65535×65535 pixels; valid until the next call.</summary>
        /// <exception cref="ArgumentException">No picture, or depth or infrared.</exception>
        public ReadOnlySpan<byte> Encode(Image source)
        {
            if (source.Format == PixelFormat.None || source.Format > PixelFormat.Gray8 || source.Width > 0xFFFF || source.Height > 0xFFFF)
                throw new ArgumentException($"a picture of format {source.Format} cannot become a JPEG", nameof(source));
            bool isGray = source.Format == PixelFormat.Gray8;
            int vertical = source.Format == PixelFormat.Nv12 ? 2 : 1;
            _output.Clear();
            WriteHeader(source, isGray, vertical);

            int* block = stackalloc int[64];
            int* predictions = stackalloc int[3];
            int unitWidth = isGray ? 8 : 16;
            int unitHeight = 8 * vertical;
            int unit = 0;
            for (int y = 0; y < source.Height; y += unitHeight)
            {
                for (int x = 0; x < source.Width; x += unitWidth, unit++)
                {
                    if (_restartInterval > 0 && unit > 0 && unit % _restartInterval == 0)
                    {
                        _output.Flush();
                        _output.BigEndian16(0xFFD0 + (unit / _restartInterval - 1) % 8);
                        predictions[0] = predictions[1] = predictions[2] = 0;
                    }

                    for (int dy = 0; dy < unitHeight; dy += 8)
                    {
                        for (int dx = 0; dx < unitWidth; dx += 8)
                        {
                            JpegBlockReader.ReadLuma(source, x + dx, y + dy, block);
                            _luma.Encode(block, ref predictions[0], _output);
                        }
                    }

                    for (int component = 1; !isGray && component <= 2; component++)
                    {
                        JpegBlockReader.ReadChroma(source, x / 2, y / vertical, component, block);
                        _chroma.Encode(block, ref predictions[component], _output);
                    }
                }
            }

            _output.Flush();
            _output.BigEndian16(0xFFD9);
            return _output.Written;
        }

        private void WriteHeader(Image source, bool isGray, int vertical)
        {
            _output.BigEndian16(0xFFD8);
            int components = isGray ? 1 : 3;
            WriteQuantisation(0, _luma);
            if (!isGray)
                WriteQuantisation(1, _chroma);

            _output.BigEndian16(0xFFC0);
            _output.BigEndian16(8 + 3 * components);
            _output.Byte(8);
            _output.BigEndian16(source.Height);
            _output.BigEndian16(source.Width);
            _output.Byte(components);
            for (int i = 0; i < components; i++)
            {
                _output.Byte(i + 1);
                _output.Byte(i > 0 || isGray ? 0x11 : 0x20 | vertical);
                _output.Byte(Math.Min(i, 1));
            }

            if (_writeHuffmanTables)
            {
                WriteHuffman(0x00, JpegTables.LuminanceDc);
                WriteHuffman(0x10, JpegTables.LuminanceAc);
                if (!isGray)
                {
                    WriteHuffman(0x01, JpegTables.ChrominanceDc);
                    WriteHuffman(0x11, JpegTables.ChrominanceAc);
                }
            }

            if (_restartInterval > 0)
            {
                _output.BigEndian16(0xFFDD);
                _output.BigEndian16(4);
                _output.BigEndian16(_restartInterval);
            }

            _output.BigEndian16(0xFFDA);
            _output.BigEndian16(6 + 2 * components);
            _output.Byte(components);
            for (int i = 0; i < components; i++)
            {
                _output.Byte(i + 1);
                _output.Byte(i == 0 ? 0x00 : 0x11);
            }

            _output.Byte(0);
            _output.Byte(63);
            _output.Byte(0);
        }

        private void WriteQuantisation(int index, JpegBlockEncoder encoder)
        {
            _output.BigEndian16(0xFFDB);
            _output.BigEndian16(67);
            _output.Byte(index);
            for (int k = 0; k < 64; k++)
                _output.Byte(encoder.Quantisation[JpegTables.ZigZag[k]]);
        }

        private void WriteHuffman(int kind, byte[] definition)
        {
            _output.BigEndian16(0xFFC4);
            _output.BigEndian16(3 + definition.Length);
            _output.Byte(kind);
            _output.Bytes(definition);
        }
    }
}
