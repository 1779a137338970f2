using System;
using LaserTracking.Hands;
using LaserTracking.Hands.Model;
using LaserTracking.Imaging;
using LaserTracking.Kernels;

namespace LaserTracking.Burst
{
    /// <summary>Each kernel of the hands and of their model over random memory of a random, often odd, size.</summary>
    internal static unsafe class HandCases
    {
        private static readonly PixelFormat[] Formats = { PixelFormat.Bgra32, PixelFormat.Nv12, PixelFormat.Yuy2, PixelFormat.Gray8, PixelFormat.Infrared16 };

        public static void DepthGrid(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            using Image image = DetectionCases.RandomImage(random, PixelFormat.Depth16);
            Span<ushort> depths = System.Runtime.InteropServices.MemoryMarshal.Cast<byte, ushort>(image.Bytes);
            for (int i = 0; i < depths.Length; i++)
                depths[i] = (ushort)(random.Next(3) == 0 ? 0 : random.Next(200, 5000));
            int step = random.Next(1, Math.Min(6, Math.Min(image.Width, image.Height) + 1)), width = image.Width / step, height = image.Height / step;
            var work = new DepthGridBands
            {
                Source = image,
                Width = width,
                StepPx = step,
                FirstPx = step >= 4 ? step / 4 : 0,
                SecondPx = step >= 4 ? step - 1 - step / 4 : step - 1,
                NearMm = 400,
                FarMm = 4000,
                SurfaceStepMm = 60,
                Z = data.Floats(width * height, 0, 1),
                Lost = (bool*)data.Zeros<byte>(width * height),
            };
            kernels.Run(&work, height);
        }

        public static void Bridge(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int width = random.Next(1, 120), height = random.Next(1, 90);
            float* z = data.Floats(width * height, 1000, 1030);
            byte* lost = data.Zeros<byte>(width * height);
            for (int i = 0; i < width * height; i++)
            {
                if (random.Next(3) > 0)
                    continue;
                z[i] = 0;
                lost[i] = (byte)(random.Next(4) > 0 ? 1 : 0);
            }

            bool isRows = random.Next(2) == 1;
            var work = new BridgeBands
            {
                Z = z,
                Lost = (bool*)lost,
                Length = isRows ? width : height,
                Stride = isRows ? 1 : width,
                LineStride = isRows ? width : 1,
                Reach = random.Next(1000, 9000),
                SurfaceStepMm = 20,
            };
            kernels.Run(&work, isRows ? height : width);
        }

        public static void DepthLevel(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int width = random.Next(1, 120), height = random.Next(2, 90), cells = width * height;
            var work = new DepthLevelBands { Width = width, Z = data.Floats(cells, -500, 500), Levels = data.Take<byte>(cells), Before = data.Take<float>(cells) };
            kernels.Run(&work, height);
        }

        public static void Surface(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int width = random.Next(1, 100), height = random.Next(1, 80), cells = width * height;
            bool isListed = random.Next(2) == 1;
            var work = new SurfaceBands
            {
                Width = width,
                Height = height,
                StepMm = random.Next(1, 60),
                Level = 2,
                Seeds = isListed ? data.Indices(cells, cells) : null,
                SeedCount = cells,
                Z = data.Floats(cells, 2000, 2060),
                RayX = data.Floats(width, -1, 1),
                Before = data.Floats(cells, 0, 800),
                Levels = Levels(data, random, cells),
                Cells = data.Take<int>(cells),
            };
            double* known = data.Zeros<double>(5 * cells);
            for (int surface = 0; surface < cells; surface++)
            {
                kernels.Run(&work, 1);
                if (work.Count == 0)
                    break;
                new Span<double>(known + 5 * surface, 5).Clear();
                known[5 * surface] = work.Count;
                known[5 * surface + 1] = work.Area;
                known[5 * surface + 2] = work.SumX;
                known[5 * surface + 3] = work.NearestMm;
                known[5 * surface + 4] = work.ReachMm;
            }
        }

        public static void Torso(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int width = random.Next(1, 100), height = random.Next(1, 80), cells = width * height, count = random.Next(1, cells + 1), first = random.Next(cells - count + 1);
            int* list = data.Take<int>(count);
            for (int i = 0; i < count; i++)
                list[i] = first + i;
            TorsoColumn* columns = data.Zeros<TorsoColumn>(TorsoKernel.ColumnBins);
            for (int i = 0; i < TorsoKernel.ColumnBins; i++)
                columns[i].Top = float.MaxValue;
            double* slope = data.Take<double>(1);
            var work = new TorsoBands
            {
                Width = width,
                Z = data.Floats(cells, 900, 3900),
                RayX = data.Floats(width, -1, 1),
                RayY = data.Floats(height, -0.7f, 0.7f),
                Cells = list,
                CellCount = count,
                Reach = random.Next(1, 9),
                DepthBinMm = 30,
                Columns = columns,
                Histogram = data.Take<int>(TorsoKernel.ColumnBins * TorsoKernel.DepthBins),
                Window = data.Take<int>(TorsoKernel.DepthBins),
                ForwardMm = 120,
                NextLevel = 2,
                Levels = Levels(data, random, cells),
                Before = data.Take<float>(cells),
            };
            kernels.Run(&work, 1);
            *slope = work.Slope;
        }

        private static byte* Levels(Arena data, Random random, int cells)
        {
            byte* levels = data.Take<byte>(cells);
            for (int i = 0; i < cells; i++)
                levels[i] = (byte)(random.Next(5) == 0 ? 1 : 2);
            return levels;
        }

        public static void Crop(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            using Image image = DetectionCases.RandomImage(random, Formats[random.Next(5)]);
            int size = random.Next(1, 100);
            var region = new HandRegion(random.Next(-20, 180), random.Next(-20, 140), random.Next(1, 200), 6.28 * random.NextDouble());
            CropBands work = CropBands.Of(image, region, size, data.Floats(3 * size * size, 0, 1), data.Floats(size, 0, 1));
            kernels.Run(&work, size);
        }

        public static void Exposure(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int size = random.Next(1, 100);
            var work = new ExposureBands { Rgb = data.Floats(3 * size * size, 0, 4000), Width = size, Gain = 0.001f * random.NextSingle() };
            kernels.Run(&work, size);
        }

        public static void Convolution(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int side = random.Next(1, 4), stride = random.Next(1, 3), depth;
            var window = new SlidingWindow(random.Next(2) == 1, side, side, stride, stride);
            FeatureMap input = Map(data, random.Next(side, 20), random.Next(side, 20), random.Next(1, 20));
            FeatureMap output = Map(data, window.OutputHeight(input.Height), window.OutputWidth(input.Width), random.Next(1, 40));
            depth = side * side * input.Channels;
            bool isGathered = side > 1 || stride > 1;
            int bands = kernels.BandCount;
            var work = new ConvolutionBands
            {
                Input = input,
                Output = output,
                Window = window,
                Depth = depth,
                Weights = data.Floats(PointwiseKernel.PackedLength(output.Channels, depth), -1, 1),
                Bias = data.Floats(PointwiseKernel.PackedLength(output.Channels, 1), -1, 1),
                Low = 0,
                High = random.Next(2) == 1 ? 6 : float.PositiveInfinity,
                BandCount = bands,
                Columns = isGathered ? scratch.Take<float>(output.Width * depth * bands) : null,
            };
            kernels.Run(&work, bands);
        }

        public static void Depthwise(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int side = random.Next(1, 6), stride = random.Next(1, 3), bands = kernels.BandCount;
            var window = new SlidingWindow(random.Next(2) == 1, side, side, stride, stride);
            FeatureMap input = Map(data, random.Next(side, 24), random.Next(side, 24), random.Next(1, 20));
            FeatureMap output = Map(data, window.OutputHeight(input.Height), window.OutputWidth(input.Width), input.Channels);
            int rowLength = Math.Max(input.Width + window.PaddingLeft(input.Width), (output.Width - 1) * stride + side) * input.Channels;
            var work = new DepthwiseBands
            {
                Input = input,
                Output = output,
                Window = window,
                Weights = data.Floats(side * side * input.Channels, -1, 1),
                Bias = data.Floats(input.Channels, -1, 1),
                Low = 0,
                High = 6,
                BandCount = bands,
                RowLength = rowLength,
                Rings = scratch.Zeros<float>((side + 1) * rowLength * bands),
            };
            kernels.Run(&work, bands);
        }

        public static void Add(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int count = random.Next(1, 60_000);
            var work = new AddBands { First = data.Floats(count, -4, 4), Second = data.Floats(count, -4, 4), Sum = data.Floats(count, 0, 1), Count = count, Low = 0, High = 6 };
            kernels.Run(&work, work.BandCount);
        }

        public static void MaxPool(KernelRunner kernels, Arena data, Arena scratch, Random random)
        {
            int side = random.Next(1, 5), stride = random.Next(1, 3);
            var window = new SlidingWindow(random.Next(2) == 1, side, side, stride, stride);
            FeatureMap input = Map(data, random.Next(side, 24), random.Next(side, 24), random.Next(1, 20));
            FeatureMap output = Map(data, window.OutputHeight(input.Height), window.OutputWidth(input.Width), input.Channels);
            var work = new MaxPoolBands { Input = input, Output = output, Window = window, Low = float.NegativeInfinity, High = 0.5f };
            kernels.Run(&work, output.Height);
        }

        private static FeatureMap Map(Arena data, int height, int width, int channels) =>
            new FeatureMap(data.Floats(height * width * channels, -1, 1), height, width, channels);
    }
}
