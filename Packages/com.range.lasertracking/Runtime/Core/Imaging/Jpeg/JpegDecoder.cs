using System;
using System.Runtime.CompilerServices;

namespace LaserTracking.Imaging
{
    /// <summary>
    /// Baseline JPEG to raw pixels, as cameras deliver it, with the same result to the last bit on every machine and in Unity as in
    /// .NET. Samplings keep their layout: 4:2:2 becomes <see cref="PixelFormat.Yuy2"/>, 4:2:0 <see cref="PixelFormat.Nv12"/>, grey
    /// <see cref="PixelFormat.Gray8"/>; everything else, and odd sizes that these cannot have, <see cref="PixelFormat.Bgra32"/>.
    /// Huffman tables may be missing (the standard ones are meant). Any damage refuses the picture: half a picture would look
    /// like motion. Not thread-safe; allocates nothing once warm.
    /// </summary>
    /// <remarks>
    /// The inner methods are compiled with full optimisation at once: a recording of seconds would be over before .NET had
    /// improved them step by step.
    /// </remarks>
    public sealed unsafe class JpegDecoder
    {
        private readonly JpegFrameHeader _header = new JpegFrameHeader();
        private readonly JpegHuffmanTable[] _blockDc = new JpegHuffmanTable[10];
        private readonly JpegHuffmanTable[] _blockAc = new JpegHuffmanTable[10];
        private readonly int[] _blockComponent = new int[10];
        private byte[] _interval = new byte[64 * 1024];

        /// <summary>
        /// Decodes one picture into <paramref name="target"/>. On failure the target is empty and <paramref name="problem"/> says in
        /// one line what is wrong; on success it is the empty string.
        /// </summary>
        /// <param name="jpeg">The whole JPEG; bytes after its end marker are ignored.</param>
        /// <param name="target">Takes the size that the JPEG declares.</param>
        /// <param name="timeUs">Device time for the picture, in microseconds.</param>
        /// <param name="problem">Empty, or what is wrong and at which byte.</param>
        public bool TryDecode(ReadOnlySpan<byte> jpeg, Image target, long timeUs, out string problem)
        {
            target.Clear();
            if (!_header.TryRead(jpeg, out problem))
                return false;

            int unitWidth = 8 * _header.MaxHorizontal;
            int unitHeight = 8 * _header.MaxVertical;
            int unitsAcross = (_header.Width + unitWidth - 1) / unitWidth;
            int unitsDown = (_header.Height + unitHeight - 1) / unitHeight;

            // Each block takes at least two bits. Asking before making room keeps a damaged size from costing memory.
            long leastBytes = (long)unitsAcross * unitsDown * _header.BlocksPerUnit / 4;
            if (jpeg.Length - _header.DataOffset < leastBytes)
            {
                problem = "JPEG ends early at byte " + jpeg.Length;
                return false;
            }

            PixelFormat format = ChooseFormat();
            long size = Image.TightSize(format, _header.Width, _header.Height);
            if (size > int.MaxValue / 2)
            {
                problem = "JPEG of " + _header.Width + "×" + _header.Height + " pixels is too large";
                return false;
            }

            PrepareBlocks();
            target.Reset(format, _header.Width, _header.Height, timeUs);
            if (TryDecodeUnits(jpeg, target, unitsAcross, unitsAcross * unitsDown, out problem))
                return true;
            target.Clear();
            return false;
        }

        private PixelFormat ChooseFormat()
        {
            if (_header.ComponentCount == 1)
                return PixelFormat.Gray8;
            JpegComponent[] c = _header.Components;
            if (_header.IsRgb || c[0].Horizontal != 2 || c[1].Horizontal != 1 || c[2].Horizontal != 1 || _header.Width % 2 != 0)
                return PixelFormat.Bgra32;

            // Some encoders state 4:2:2 as 2×2, 1×2, 1×2: two units on top of each other.
            if (c[0].Vertical <= 2 && c[1].Vertical == c[0].Vertical && c[2].Vertical == c[0].Vertical)
                return PixelFormat.Yuy2;
            if (c[0].Vertical == 2 && c[1].Vertical == 1 && c[2].Vertical == 1 && _header.Height % 2 == 0)
                return PixelFormat.Nv12;
            return PixelFormat.Bgra32;
        }

        private void PrepareBlocks()
        {
            int block = 0;
            for (int i = 0; i < _header.ComponentCount; i++)
            {
                int count = _header.Components[i].Horizontal * _header.Components[i].Vertical;
                for (int k = 0; k < count; k++, block++)
                {
                    _blockComponent[block] = i;
                    _blockDc[block] = _header.DcTable(i);
                    _blockAc[block] = _header.AcTable(i);
                }
            }
        }

        [MethodImpl(JitOptions.OptimizeAtOnce)]
        private bool TryDecodeUnits(ReadOnlySpan<byte> jpeg, Image target, int unitsAcross, int unitCount, out string problem)
        {
            byte* samples = stackalloc byte[10 * 64];
            int* predictions = stackalloc int[3];
            int offset = _header.DataOffset;
            int interval = _header.RestartInterval == 0 ? unitCount : _header.RestartInterval;
            for (int unit = 0, restart = 0; unit < unitCount; restart++)
            {
                int next = JpegInterval.Extract(jpeg, offset, ref _interval, out int length, out int marker);
                int end = Math.Min(unit + interval, unitCount);
                predictions[0] = predictions[1] = predictions[2] = 0;
                fixed (byte* data = _interval)
                {
                    var reader = new JpegBitReader(data, length);
                    for (; unit < end; unit++)
                    {
                        if (TryDecodeBlocks(ref reader, predictions, samples) && !reader.IsOverrun)
                        {
                            Write(target, samples, unit % unitsAcross, unit / unitsAcross);
                            continue;
                        }

                        bool cut = marker < 0 && reader.IsOverrun;
                        problem = cut
                            ? "JPEG ends early at byte " + jpeg.Length
                            : "JPEG damaged at byte " + JpegInterval.FileOffset(jpeg, offset, (int)(reader.Position - data));
                        return false;
                    }

                    // What a damaged code leaves over is damage, too. Cameras may pad the very end with zeros.
                    int rest = length - (int)(reader.Position - data);
                    bool more = unit < unitCount;
                    bool isPadding = !more && IsZero(reader.Position, rest);
                    if ((rest > 1 && !isPadding) || (more && marker >= 0 && marker != 0xD0 + (restart & 7)))
                    {
                        problem = "JPEG damaged at byte " + JpegInterval.FileOffset(jpeg, offset, length - rest);
                        return false;
                    }
                }

                if (unit < unitCount && marker < 0)
                {
                    problem = "JPEG ends early at byte " + jpeg.Length;
                    return false;
                }

                offset = next;
            }

            problem = string.Empty;
            return true;
        }

        private static bool IsZero(byte* bytes, int count)
        {
            for (int i = 0; i < count; i++)
            {
                if (bytes[i] != 0)
                    return false;
            }

            return true;
        }

        [MethodImpl(JitOptions.OptimizeAtOnce)]
        private bool TryDecodeBlocks(ref JpegBitReader reader, int* predictions, byte* samples)
        {
            short* coefficients = stackalloc short[64];
            new Span<short>(coefficients, 64).Clear();
            fixed (ushort* quantisation = _header.Quantisation)
            {
                for (int block = 0; block < _header.BlocksPerUnit; block++, samples += 64)
                {
                    int component = _blockComponent[block];
                    ushort* factors = quantisation + 64 * _header.Components[component].QuantisationTable;
                    int last = reader.DecodeBlock(_blockDc[block], _blockAc[block], factors, ref predictions[component], coefficients);
                    if (last == 0)
                    {
                        JpegInverseDct.TransformDcOnly(coefficients[0], samples);
                    }
                    else if (last > 0)
                    {
                        JpegInverseDct.Transform(coefficients, samples);
                        new Span<short>(coefficients, 64).Clear();
                    }
                    else
                    {
                        return false;
                    }
                }
            }

            return true;
        }

        [MethodImpl(JitOptions.OptimizeAtOnce)]
        private void Write(Image target, byte* samples, int unitX, int unitY)
        {
            int unitWidth = 8 * _header.MaxHorizontal;
            int unitHeight = 8 * _header.MaxVertical;
            int x = unitX * unitWidth;
            int y = unitY * unitHeight;
            int width = Math.Min(unitWidth, target.Width - x);
            int height = Math.Min(unitHeight, target.Height - y);
            int stride = target.Stride;
            byte* row = target.Pixels + (long)y * stride;
            if (target.Format == PixelFormat.Bgra32)
            {
                JpegBlockWriter.WriteBgra(_header, samples, row + x * 4, stride, width, height);
                return;
            }

            bool whole = width == unitWidth && height == unitHeight;
            int bytesPerPixel = target.Format == PixelFormat.Yuy2 ? 2 : 1;
            byte* corner = row + x * bytesPerPixel;
            byte* chroma = target.Pixels + (long)(target.Height + y / 2) * stride + x;
            byte* scratch = stackalloc byte[16 * 16 * 2];
            byte* luma = whole ? corner : scratch;
            int lumaStride = whole ? stride : unitWidth * bytesPerPixel;
            switch (target.Format)
            {
                case PixelFormat.Yuy2:
                    for (int v = 0; v < _header.MaxVertical; v++)
                    {
                        byte* u = samples + 64 * (_header.Components[1].FirstBlock + v);
                        JpegBlockWriter.WriteYuy2(
                            samples + v * 128, u, u + 64 * _header.MaxVertical, luma + v * 8 * lumaStride, lumaStride);
                    }

                    break;
                case PixelFormat.Nv12:
                    JpegBlockWriter.WriteNv12(samples, luma, whole ? chroma : scratch + 256, lumaStride);
                    break;
                default:
                    JpegBlockWriter.WriteGray(samples, luma, lumaStride);
                    break;
            }

            if (whole)
                return;
            CopyRows(scratch, lumaStride, corner, stride, width * bytesPerPixel, height);
            if (target.Format == PixelFormat.Nv12)
                CopyRows(scratch + 256, lumaStride, chroma, stride, width, height / 2);
        }

        private static void CopyRows(byte* source, int sourceStride, byte* target, int targetStride, int bytes, int rows)
        {
            for (int y = 0; y < rows; y++)
                Buffer.MemoryCopy(source + y * sourceStride, target + (long)y * targetStride, bytes, bytes);
        }
    }
}
