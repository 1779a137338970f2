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

        public static void Raise(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int count = random.Next(1, 40_000);
            var work = new RaiseBands { Source = data.Take<uint>(count), Target = data.Take<uint>(count), Count = count, UseVectors = true };
            kernels.Run(&work, work.BandCount);
        }

        public static void Expectation(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int width = random.Next(5, 200), height = random.Next(1, 90), pixels = width * height;
            byte* tone = data.Take<byte>(ExpectationKernel.ToneBytes);
            for (int i = 0; i < ExpectationKernel.ToneBytes; i++)
                tone[i] &= 15;
            var work = new ExpectationBands
            {
                Width = width,
                Height = height,
                UseVectors = true,
                BandCount = kernels.BandCount,
                Brightest = data.Take<uint>(pixels),
                Screen = data.Take<uint>(pixels),
                Tone = tone,
                Gain = data.Take<uint>(pixels),
                Offset = data.Take<uint>(pixels),
                Pad = scratch.Zeros<uint>((width + 2 * ExpectationKernel.Reach) * kernels.BandCount),
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

        /// <summary>Random pixels in rows that may be padded; sizes as odd as the format can have them.</summary>
        internal static Image RandomImage(Random random, PixelFormat format)
        {
            int width = random.Next(1, 161), height = random.Next(1, 121);
            width += format == PixelFormat.Nv12 || format == PixelFormat.Yuy2 ? width % 2 : 0;
            height += format == PixelFormat.Nv12 ? height % 2 : 0;
            var image = new Image();
            image.Reset(format, width, height, 0, Image.TightStride(format, width) + 4 * random.Next(3));
            random.NextBytes(image.Bytes);
            return image;
        }
    }
}
