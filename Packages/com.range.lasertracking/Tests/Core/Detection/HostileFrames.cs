using System;
using LaserTracking.Capture;
using LaserTracking.Imaging;

namespace LaserTracking.Detection
{
    /// <summary>A seeded stream of frames as no camera should deliver them: sizes, formats, strides, contents and times that jump.</summary>
    internal sealed unsafe class HostileFrames
    {
        private static readonly int[] Sizes = { 1, 2, 3, 4, 5, 7, 8, 15, 16, 17, 31, 33, 64, 65, 100, 129, 130 };
        private static readonly int[] WideSizes = { 1101, 1102, 1200, 1303 };
        private static readonly PixelFormat[] Formats = { PixelFormat.Bgra32, PixelFormat.Nv12, PixelFormat.Yuy2, PixelFormat.Gray8 };
        private readonly Random _random;
        private PixelFormat _format;
        private int _width;
        private int _height;
        private int _padding;
        private int _index;
        private long _timeUs;
        private int _level;

        public HostileFrames(int seed)
        {
            _random = new Random(seed);
            Reshape();
        }

        /// <summary>Fills padding with this; what it is must not matter.</summary>
        public byte PaddingFill { get; set; } = 0xEE;

        public void Next(Frame frame)
        {
            if (_random.Next(12) == 0)
                Reshape();
            switch (_random.Next(20))
            {
                case 0: break;
                case 1: _timeUs -= 100_000; break;
                case 2: _timeUs += 10_000_000; break;
                case 3: _timeUs = _random.Next(2) == 0 ? long.MinValue / 4 : long.MaxValue / 4; break;
                case 4: _timeUs = 0; break;
                default: _timeUs += 33_333; break;
            }

            frame.Begin(_index++, _timeUs);
            if (_random.Next(25) == 0)
                return;
            frame.Color.Reset(_format, _width, _height, _timeUs, Image.TightStride(_format, _width) + _padding);
            Fill(frame.Color);
        }

        /// <summary>The same picture without padding.</summary>
        public static void CopyTight(Image source, Image target)
        {
            target.Reset(source.Format, source.Width, source.Height, source.TimeUs);
            int rows = source.SizeBytes / source.Stride;
            for (int y = 0; y < rows; y++)
                new ReadOnlySpan<byte>(source.Pixels + (long)y * source.Stride, target.Stride).CopyTo(new Span<byte>(target.Pixels + (long)y * target.Stride, target.Stride));
        }

        private void Reshape()
        {
            _format = Formats[_random.Next(Formats.Length)];
            bool isWide = _random.Next(6) == 0;
            _width = isWide ? WideSizes[_random.Next(WideSizes.Length)] : Sizes[_random.Next(Sizes.Length)];
            _height = Sizes[_random.Next(Sizes.Length)];
            if (_format == PixelFormat.Nv12 || _format == PixelFormat.Yuy2)
                _width += _width % 2;
            if (_format == PixelFormat.Nv12)
                _height += _height % 2;
            _padding = _random.Next(2) == 0 ? 0 : 4 * _random.Next(1, 20);
            _level = _random.Next(256);
        }

        private void Fill(Image image)
        {
            Span<byte> bytes = image.Bytes;
            switch (_random.Next(9))
            {
                case 0: bytes.Clear(); break;
                case 1: bytes.Fill(255); break;
                case 2: _random.NextBytes(bytes); break;
                case 3: Gradient(bytes); break;
                default: Quiet(image, bytes); break;
            }

            int tight = Image.TightStride(image.Format, image.Width), rows = image.SizeBytes / image.Stride;
            for (int y = 0; y < rows; y++)
                new Span<byte>(image.Pixels + (long)y * image.Stride + tight, image.Stride - tight).Fill(PaddingFill);
        }

        private static void Gradient(Span<byte> bytes)
        {
            for (int i = 0; i < bytes.Length; i++)
                bytes[i] = (byte)i;
        }

        /// <summary>A wall with a little noise; often a spot or a thousand on it.</summary>
        private void Quiet(Image image, Span<byte> bytes)
        {
            for (int i = 0; i < bytes.Length; i++)
                bytes[i] = (byte)Math.Min(255, _level + (i * 7919 + _index * 104729) % 5);
            int spots = _random.Next(3) == 0 ? 0 : _random.Next(10) == 0 ? 1000 : _random.Next(4);
            for (int n = 0; n < spots; n++)
            {
                int x = _random.Next(image.Width), y = _random.Next(image.Height), radius = _random.Next(1, 5);
                for (int py = Math.Max(0, y - radius); py <= Math.Min(image.Height - 1, y + radius); py++)
                {
                    int first = Image.TightStride(image.Format, Math.Max(0, x - radius)), last = Image.TightStride(image.Format, Math.Min(image.Width, x + radius));
                    new Span<byte>(image.Pixels + (long)py * image.Stride + first, Math.Max(0, last - first)).Fill(255);
                }
            }
        }
    }
}
