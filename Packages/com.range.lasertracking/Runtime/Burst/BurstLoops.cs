using LaserTracking.Detection;
using LaserTracking.Hands;
using LaserTracking.Hands.Model;
using Unity.Burst;

namespace LaserTracking.Burst
{
    /// <summary>
    /// All bands on the calling thread, whichever it is: Burst makes its own code of these and puts a call to it in their place. The
    /// pointers have no type because that code may not meet Core's internal ones.
    /// </summary>
    [BurstCompile]
    internal static unsafe class BurstLoops
    {
        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Plane(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((PlaneBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Dilation(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((DilationBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Paper(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((PaperBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Patch(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((PatchBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void PatchMatch(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((PatchMatchBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Ratio(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((RatioBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Histogram(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((HistogramBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Rescale(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((RescaleBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Rise(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((RiseBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Expectation(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((ExpectationBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Comparison(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((ComparisonBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void InfraredTile(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((InfraredTileBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void GreenTile(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((GreenTileBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void DepthGrid(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((DepthGridBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Bridge(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((BridgeBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void DepthLevel(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((DepthLevelBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Surface(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((SurfaceBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Torso(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((TorsoBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Crop(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((CropBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Exposure(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((ExposureBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Convolution(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((ConvolutionBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Depthwise(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((DepthwiseBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void Add(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((AddBands*)work)->Execute(band);
        }

        [BurstCompile(FloatPrecision.Standard, FloatMode.Strict)]
        public static void MaxPool(void* work, int count)
        {
            for (int band = 0; band < count; band++)
                ((MaxPoolBands*)work)->Execute(band);
        }
    }
}
