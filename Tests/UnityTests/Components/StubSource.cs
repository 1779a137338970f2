using System;
using System.Collections.Generic;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Imaging;

namespace LaserTracking.Unity
{
    /// <summary>A dim noisy picture, 30 frames a second, in which green dots flash at given frames.</summary>
    internal sealed class StubSource : IFrameSource
    {
        public const int Width = 640;
        public const int Height = 480;
        public const long FrameIntervalUs = 33333;

        private static readonly byte[] Noise = MakeNoise();
        private readonly int _frames;
        private readonly long _startUs;
        private readonly (int Frame, int X, int Y)[] _flashes;
        private readonly long[] _allocated = new long[1024];
        private int _next;

        public StubSource(int frames, long startUs, params (int Frame, int X, int Y)[] flashes)
        {
            _frames = frames;
            _startUs = startUs;
            _flashes = flashes;
        }

        public FrameSourceInfo Info { get; } = new FrameSourceInfo("stub", Width, Height, 30, null);

        public IReadOnlyList<FrameProblem> Problems { get; } = new List<FrameProblem>();

        public bool IsDisposed { get; private set; }

        /// <summary>The least that the reading thread allocated in any twenty frames from one to another, everything between two reads included.</summary>
        public long LeastAllocatedIn20Frames(int from, int to)
        {
            long least = long.MaxValue;
            for (int i = from; i + 20 <= to; i += 20)
                least = Math.Min(least, _allocated[i + 20] - _allocated[i]);
            return least;
        }

        /// <summary>The thread that reads.</summary>
        public Thread? Reader { get; private set; }

        /// <summary>A device that answers no more: the next read comes back when this is set.</summary>
        public ManualResetEventSlim? HangsUntil { get; set; }

        /// <summary>Frames after which it throws; 0: never.</summary>
        public int BreaksAfter { get; set; }

        /// <summary>Real milliseconds from frame to frame, as of a camera.</summary>
        public int PaceMs { get; set; }

        public bool TryRead(Frame frame)
        {
            Reader = Thread.CurrentThread;
            _allocated[_next % _allocated.Length] = GC.GetAllocatedBytesForCurrentThread();
            HangsUntil?.Wait();
            if (PaceMs > 0)
                Thread.Sleep(PaceMs);
            if (BreaksAfter > 0 && _next >= BreaksAfter)
                throw new InputException("stub", "breaks", "mend it");
            if (_next >= _frames || IsDisposed)
                return false;
            long timeUs = _startUs + _next * FrameIntervalUs;
            frame.Begin(_next, timeUs);
            frame.Color.Reset(PixelFormat.Bgra32, Width, Height, timeUs);
            Span<byte> pixels = frame.Color.Bytes;
            // The same noise from another place in every frame.
            new ReadOnlySpan<byte>(Noise, _next * 997 % 65536, pixels.Length).CopyTo(pixels);
            foreach ((int first, int x, int y) in _flashes)
            {
                if (_next >= first && _next < first + 2)
                    Draw(pixels, x, y);
            }

            _next++;
            return true;
        }

        public void Dispose() => IsDisposed = true;

        private static byte[] MakeNoise()
        {
            var random = new Random(1);
            var noise = new byte[Width * Height * 4 + 65536];
            for (int i = 0; i < noise.Length; i++)
                noise[i] = (byte)(30 + random.Next(4));
            return noise;
        }

        private static void Draw(Span<byte> pixels, int centerX, int centerY)
        {
            for (int y = centerY - 12; y <= centerY + 12; y++)
            for (int x = centerX - 12; x <= centerX + 12; x++)
            {
                double light = 900 * Math.Exp(-((x - centerX) * (x - centerX) + (y - centerY) * (y - centerY)) / 12.0);
                int at = (y * Width + x) * 4;
                pixels[at] = (byte)Math.Min(255, pixels[at] + light * 0.3);
                pixels[at + 1] = (byte)Math.Min(255, pixels[at + 1] + light);
                pixels[at + 2] = (byte)Math.Min(255, pixels[at + 2] + light * 0.25);
            }
        }
    }
}
