using System;
using LaserTracking.Detection;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Burst
{
    /// <summary>Each kernel of detection over random memory of a random, often odd, size.</summary>
    internal static unsafe class DetectionCases
    {
        private static readonly PixelFormat[] Formats = { PixelFormat.Bgra32, PixelFormat.Nv12, PixelFormat.Yuy2, PixelFormat.Gray8 };

        public static void Plane(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            using Image image = RandomImage(random, Formats[random.Next(4)]);
            int factor = random.Next(1, 3), width = ReductionKernel.ReducedSize(image.Width, factor), height = ReductionKernel.ReducedSize(image.Height, factor);
            int pixels = width * height, tiles = TileGrid.Count(width) * TileGrid.Count(height), bands = Math.Min(kernels.BandCount, TileGrid.Count(height));
            bool isShifted = random.Next(2) == 1;
            var work = new PlaneBands
            {
                Source = image,
                Width = width,
                Height = height,
                Factor = factor,
                ShiftX = isShifted ? random.Next(-6, 7) : 0,
                ShiftY = isShifted ? random.Next(-6, 7) : 0,
                Decay = (byte)random.Next(8),
                IsSmooth = random.Next(2) == 1,
                IsDilated = random.Next(2) == 1,
                UseVectors = true,
                BandCount = bands,
                Picture = data.Take<uint>(pixels),
                OldSmallest = data.Take<byte>(pixels),
                NewSmallest = data.Take<byte>(pixels),
                OldLargest = data.Take<byte>(pixels),
                NewLargest = data.Take<byte>(pixels),
                DilatedSmallest = data.Take<byte>(pixels),
                DilatedLargest = data.Take<byte>(pixels),
                SmallestOnsets = data.Take<byte>(tiles),
                LargestOnsets = data.Take<byte>(tiles),
                Rows = scratch.Take<uint>(PlaneBands.RowsPerBand * width * bands),
                Columns = scratch.Take<byte>(PlaneBands.ColumnsPerPixel * width * bands),
            };
            kernels.Run(&work, bands);
        }

        public static void Dilation(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int width = random.Next(1, 150), height = random.Next(1, 90);
            var work = new DilationBands { Source = data.Take<byte>(width * height), Target = data.Take<byte>(width * height), Width = width, Height = height };
            kernels.Run(&work, height);
        }

        public static void Paper(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            using Image image = RandomImage(random, Formats[random.Next(4)]);
            int width = random.Next(1, image.Width + 1), height = random.Next(1, Math.Min(image.Height, 60) + 1), pixels = width * height;
            int bands = Math.Min(kernels.BandCount, height), sourceRows = image.Width * (image.Height / height + 2);
            int* edges = data.Take<int>(width + 1);
            for (int x = 0; x <= width; x++)
                edges[x] = (int)((long)x * image.Width / width);
            var work = new PaperBands
            {
                Source = image,
                Width = width,
                Height = height,
                HasBackground = random.Next(4) > 0,
                UseVectors = true,
                BandCount = bands,
                Alpha = 0.95f,
                Gamma = 0.88f,
                SpikeWeight = 0.6f,
                ExcessWeight = 0.4f,
                Edges = edges,
                Intensity = data.Floats(pixels, 0, 255),
                Background = data.Floats(pixels, 0, 255),
                NextBackground = data.Floats(pixels, 0, 255),
                Excess = data.Floats(pixels, 0, 255),
                Spike = data.Floats(pixels, 0, 255),
                Score = data.Floats(pixels, 0, 255),
                Rows = scratch.Take<float>(PaperBands.RowsPerBand * width * bands),
                SourceRows = scratch.Take<uint>(sourceRows * bands),
                SourceRowsLength = sourceRows,
            };
            kernels.Run(&work, bands);
        }

        public static void Expectation(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int width = random.Next(5, 200), height = random.Next(1, 90), pixels = width * height;
            byte* tone = data.Take<byte>(ExpectationKernel.ToneBytes);
            for (int i = 0; i < ExpectationKernel.ToneBytes; i++)
                tone[i] &= 15;
            int count = random.Next(1, 5);
            uint** pictures = stackalloc uint*[count];
            for (int i = 0; i < count; i++)
                pictures[i] = data.Take<uint>(pixels);
            var work = new ExpectationBands
            {
                Width = width,
                Height = height,
                UseVectors = true,
                BandCount = kernels.BandCount,
                PictureCount = count,
                Pictures = pictures,
                Screen = data.Take<uint>(pixels),
                Tone = tone,
                Gain = data.Take<uint>(pixels),
                Offset = data.Take<uint>(pixels),
                Scratch = scratch.Zeros<uint>(ExpectationBands.ScratchLength(width) * kernels.BandCount),
            };
            kernels.Run(&work, work.BandCount);
        }

        public static void Comparison(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int width = random.Next(1, 200), height = random.Next(1, 150), columns = (width + 1) / 2, screen = random.Next(1, 5000);
            var work = new ComparisonBands
            {
                Width = width,
                Height = height,
                BlockColumns = columns,
                UseVectors = true,
                BandCount = kernels.BandCount,
                Now = data.Take<uint>(width * height),
                Screen = data.Take<uint>(screen),
                Blocks = data.Indices(columns * ((height + 1) / 2), screen),
                Reference = data.Take<byte>(width * height),
                Onsets = data.Take<byte>(TileGrid.Count(width) * TileGrid.Count(height)),
                Row = scratch.Take<uint>(2 * columns * kernels.BandCount),
                Columns = scratch.Take<byte>(width * kernels.BandCount),
            };
            kernels.Run(&work, work.BandCount);
        }

        public static void InfraredTile(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            using Image image = RandomImage(random, PixelFormat.Infrared16);
            int rows = TileKernel.Count(image.Height);
            var work = new InfraredTileBands { Source = image, Tiles = data.Take<ushort>(TileKernel.Count(image.Width) * rows), UseVectors = true };
            kernels.Run(&work, rows);
        }

        public static void GreenTile(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            using Image image = RandomImage(random, Formats[random.Next(4)]);
            int rows = TileKernel.Count(image.Height), first = random.Next(4), step = random.Next(1, 6);
            var work = new GreenTileBands
            {
                Source = image,
                First = first,
                Step = step,
                Count = (rows - first + step - 1) / step,
                BandCount = kernels.BandCount,
                UseVectors = true,
                Tiles = data.Take<byte>(TileKernel.Count(image.Width) * rows),
                Rows = scratch.Take<uint>(TileKernel.Size * image.Width * kernels.BandCount),
            };
            kernels.Run(&work, work.BandCount);
        }

        public static void Patch(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            const int Window = PatchKernel.Window;
            int factor = random.Next(1, 3), width = random.Next(3 * Window, 4 * Window), height = random.Next(3 * Window, 4 * Window);
            using Image image = RandomImage(random, Formats[random.Next(4)], factor * width - random.Next(factor), factor * height - random.Next(factor));
            var work = new PatchBands
            {
                Source = image,
                Width = width,
                Height = height,
                Factor = factor,
                Patches = data.Take<byte>(PatchBands.Count * PatchBands.Area),
                Columns = data.Take<int>(PatchBands.Count * Window),
                Rows = data.Take<int>(PatchBands.Count * Window),
            };
            kernels.Run(&work, PatchBands.Count);
        }

        public static void PatchMatch(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            const int Window = PatchKernel.Window, Size = PatchKernel.Size;
            int shift = random.Next(-4, 5);
            var work = new PatchMatchBands
            {
                Gain = 0.5 + random.NextDouble(),
                Noise = random.NextDouble(),
                Columns = data.Indices(PatchBands.Count * Window, Size * 255),
                Rows = data.Indices(PatchBands.Count * Window, Size * 255),
                ColumnReference = data.Floats(PatchBands.Count * Size, -4000, 4000),
                RowReference = data.Floats(PatchBands.Count * Size, -4000, 4000),
                ShiftX = data.Zeros<double>(PatchBands.Count),
                ShiftY = data.Zeros<double>(PatchBands.Count),
            };
            // Every other patch has gone somewhere; of the rest there is no telling.
            for (int patch = 0; patch < PatchBands.Count; patch += 2)
            {
                for (int i = 0; i < Size; i++)
                    work.RowReference[patch * Size + i] = (float)(PatchKernel.Slope(work.Rows + patch * Window, i + PatchKernel.Reach + shift) / work.Gain) + random.Next(200);
            }

            kernels.Run(&work, PatchBands.Count);
        }

        public static void Ratio(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int length = random.Next(1, 20_000), bands = kernels.BandCount;
            ulong* reciprocals = data.Zeros<ulong>(256);
            for (int i = 1; i < 256; i++)
                reciprocals[i] = ((1UL << 32) + (ulong)i - 1) / (ulong)i;
            bool isCounting = random.Next(2) == 1;
            int* ratios = scratch.Zeros<int>(256 * bands);
            long* sums = scratch.Zeros<long>(3 * bands);
            var work = new RatioBands
            {
                Now = data.Take<byte>(length),
                Before = data.Take<byte>(length),
                Length = length,
                BandCount = bands,
                Middle = isCounting ? -1 : random.Next(20, 120),
                Width = random.Next(2, 30),
                Reciprocals = reciprocals,
                Ratios = ratios,
                Sums = sums,
            };
            kernels.Run(&work, bands);
            AddUp(ratios, data.Zeros<int>(256), 256, bands);
            long* total = data.Zeros<long>(3);
            for (int i = 0; i < 3 * bands; i++)
                total[i % 3] += sums[i];
        }

        public static void Histogram(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int bands = kernels.BandCount, width = random.Next(1, 150), height = random.Next(1, 120);
            int* histograms = scratch.Zeros<int>(HistogramBands.Levels * bands);
            var work = new HistogramBands
            {
                View = View(data, random, width, height),
                IsOfChange = random.Next(2) == 1,
                Step = random.Next(1, 12),
                BandCount = bands,
                Histograms = histograms,
            };
            kernels.Run(&work, bands);
            AddUp(histograms, data.Zeros<int>(HistogramBands.Levels), HistogramBands.Levels, bands);
        }

        public static void Rescale(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int width = random.Next(1, 150), height = random.Next(1, 120), pixels = width * height;
            var work = new RescaleBands { Width = width, Table = data.Take<byte>(256), Smallest = data.Take<byte>(pixels), Largest = data.Take<byte>(pixels), Picture = data.Take<uint>(pixels) };
            kernels.Run(&work, height);
        }

        public static void Rise(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int width = random.Next(1, 150), height = random.Next(1, 120), columns = TileGrid.Count(width), tiles = random.Next(2, 40);
            var work = new RiseBands
            {
                View = View(data, random, width, height),
                Plane = (DetectionPlane)random.Next(2),
                TileColumns = columns,
                Tiles = data.Indices(tiles, columns * TileGrid.Count(height)),
                Rises = data.Zeros<byte>(tiles * TileGrid.Size * TileGrid.Size),
                Peaks = data.Zeros<byte>(tiles * TileGrid.Size),
            };
            kernels.Run(&work, tiles);
        }

        private static FrameView View(Arena data, Random random, int width, int height)
        {
            int* reciprocal = data.Take<int>(256);
            for (int headroom = 0; headroom < 256; headroom++)
                reciprocal[headroom] = 255 * 256 / (headroom + 8);
            return new FrameView
            {
                Width = width,
                Height = height,
                IsBetweenPixels = random.Next(2) == 1,
                Now = data.Take<uint>(width * height),
                Before = data.Take<uint>(width * height),
                OldSmallest = data.Take<byte>(width * height),
                OldLargest = data.Take<byte>(width * height),
                Reciprocal = reciprocal,
            };
        }

        private static void AddUp(int* bands, int* total, int length, int count)
        {
            for (int i = 0; i < length * count; i++)
                total[i % length] += bands[i];
        }

        /// <summary>Random pixels in rows that may be padded; sizes as odd as the format can have them.</summary>
        internal static Image RandomImage(Random random, PixelFormat format)
        {
            return RandomImage(random, format, random.Next(1, 161), random.Next(1, 121));
        }

        private static Image RandomImage(Random random, PixelFormat format, int width, int height)
        {
            width += format == PixelFormat.Nv12 || format == PixelFormat.Yuy2 ? width % 2 : 0;
            height += format == PixelFormat.Nv12 ? height % 2 : 0;
            var image = new Image();
            image.Reset(format, width, height, 0, Image.TightStride(format, width) + 4 * random.Next(3));
            random.NextBytes(image.Bytes);
            return image;
        }
    }
}
