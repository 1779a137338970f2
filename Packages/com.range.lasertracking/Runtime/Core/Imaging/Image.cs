using System;
using System.Runtime.InteropServices;

namespace LaserTracking.Imaging
{
    /// <summary>
    /// One raw picture in native memory that its owner uses again for every frame. Not thread-safe; whoever fills it must not run
    /// while somebody reads it. Memory grows on demand and is never given back before <see cref="Dispose"/>, so a warm frame loop
    /// allocates nothing.
    /// </summary>
    public sealed unsafe class Image : IDisposable
    {
        private const int Alignment = 64;

        private IntPtr _memory;
        private long _capacity;

        ~Image() => Free();

        public PixelFormat Format { get; private set; }

        /// <summary>Width in pixels; 0 when no picture is present.</summary>
        public int Width { get; private set; }

        /// <summary>Height in pixels; 0 when no picture is present.</summary>
        public int Height { get; private set; }

        /// <summary>Bytes from one row to the next.</summary>
        public int Stride { get; private set; }

        /// <summary>Mid-exposure time on the device's clock, in microseconds.</summary>
        public long TimeUs { get; set; }

        /// <summary>First byte of the top row, aligned to 64 bytes. Valid until the next <see cref="Reset(PixelFormat, int, int, long)"/> or <see cref="Dispose"/>.</summary>
        public byte* Pixels { get; private set; }

        /// <summary>Size of the picture in bytes, over all planes.</summary>
        public int SizeBytes { get; private set; }

        /// <summary>False when this frame has no such picture (the camera does not deliver it, or it was damaged).</summary>
        public bool IsPresent => SizeBytes > 0;

        public Span<byte> Bytes => new Span<byte>(Pixels, SizeBytes);

        /// <summary>Bytes of a picture without row padding, or 0 for a combination that cannot exist.</summary>
        public static long TightSize(PixelFormat format, int width, int height)
        {
            if (width <= 0 || height <= 0)
                return 0;
            long pixels = (long)width * height;
            switch (format)
            {
                case PixelFormat.Bgra32: return pixels * 4;
                case PixelFormat.Nv12: return width % 2 == 0 && height % 2 == 0 ? pixels * 3 / 2 : 0;
                case PixelFormat.Yuy2: return width % 2 == 0 ? pixels * 2 : 0;
                case PixelFormat.Gray8: return pixels;
                case PixelFormat.Depth16:
                case PixelFormat.Infrared16: return pixels * 2;
                default: return 0;
            }
        }

        /// <summary>Bytes of one row without padding.</summary>
        public static int TightStride(PixelFormat format, int width)
        {
            switch (format)
            {
                case PixelFormat.Bgra32: return width * 4;
                case PixelFormat.Yuy2:
                case PixelFormat.Depth16:
                case PixelFormat.Infrared16: return width * 2;
                default: return width;
            }
        }

        /// <summary>Makes room for a picture of this shape, rows without padding; the content is undefined until written.</summary>
        /// <exception cref="ArgumentException">The format cannot have this size, or it is over 2 GiB.</exception>
        public void Reset(PixelFormat format, int width, int height, long timeUs) => Reset(format, width, height, timeUs, TightStride(format, width));

        /// <summary>The same with rows that are padded, as some cameras deliver them; stride in bytes, that of the chroma plane too.</summary>
        /// <exception cref="ArgumentException">The format cannot have this size or stride, or it is over 2 GiB.</exception>
        public void Reset(PixelFormat format, int width, int height, long timeUs, int stride)
        {
            long size = TightSize(format, width, height);
            if (size <= 0 || size > int.MaxValue - Alignment)
                throw new ArgumentException($"no picture of format {format} can be {width}×{height}");
            int tight = TightStride(format, width);
            size = size / tight * stride;
            if (stride < tight || size > int.MaxValue - Alignment || (format == PixelFormat.Bgra32 && stride % 4 != 0))
                throw new ArgumentException($"no picture of format {format}, {width}×{height}, can have rows of {stride} bytes");
            if (size > _capacity)
            {
                Free();
                _memory = Marshal.AllocHGlobal(new IntPtr(size + Alignment));
                _capacity = size;
                long address = _memory.ToInt64();
                Pixels = (byte*)((address + Alignment - 1) / Alignment * Alignment);
            }

            Format = format;
            Width = width;
            Height = height;
            Stride = stride;
            SizeBytes = (int)size;
            TimeUs = timeUs;
        }

        /// <summary>Says that this frame has no such picture. Keeps the memory.</summary>
        public void Clear()
        {
            Format = PixelFormat.None;
            Width = Height = Stride = SizeBytes = 0;
            TimeUs = 0;
        }

        public void CopyFrom(Image other)
        {
            if (!other.IsPresent)
            {
                Clear();
                return;
            }

            Reset(other.Format, other.Width, other.Height, other.TimeUs, other.Stride);
            other.Bytes.CopyTo(Bytes);
        }

        /// <summary>The same without the padding that rows may have.</summary>
        public void CopyTightFrom(Image other)
        {
            if (!other.IsPresent)
            {
                Clear();
                return;
            }

            Reset(other.Format, other.Width, other.Height, other.TimeUs);
            for (int row = 0; row < SizeBytes / Stride; row++)
                other.Bytes.Slice(row * other.Stride, Stride).CopyTo(Bytes.Slice(row * Stride));
        }

        public void Dispose()
        {
            Free();
            GC.SuppressFinalize(this);
        }

        private void Free()
        {
            if (_memory != IntPtr.Zero)
                Marshal.FreeHGlobal(_memory);
            _memory = IntPtr.Zero;
            _capacity = 0;
            Pixels = null;
            Width = Height = Stride = SizeBytes = 0;
            Format = PixelFormat.None;
        }
    }
}
