using System;
using LaserTracking.Detection;
using LaserTracking.Hands;
using LaserTracking.Hands.Model;
using LaserTracking.Kernels;
using Unity.Jobs;
using Unity.Jobs.LowLevel.Unsafe;

namespace LaserTracking.Burst
{
    /// <summary>
    /// Runs the kernels as Burst jobs on all workers when the main thread asks, and as Burst code on the calling thread when another
    /// one does: Unity lets only the main thread schedule jobs. A kernel that knows one band only is a job on the main thread itself.
    /// Either way the call returns when all is done, with the same results.
    /// </summary>
    public sealed unsafe class BurstKernelRunner : KernelRunner
    {
        private const int MaxBands = 16;
        private const int BatchesPerWorker = 4;

        private readonly int _mainThread = Environment.CurrentManagedThreadId;

        /// <summary>Made on the main thread.</summary>
        public BurstKernelRunner() => BandCount = Math.Max(1, Math.Min(MaxBands, JobsUtility.JobWorkerCount + 1));

        internal override int BandCount { get; }

        internal override void Run(PlaneBands* work, int count)
        {
            if (IsParallel(count))
                new PlaneJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.Plane(work, count);
        }

        internal override void Run(DilationBands* work, int count)
        {
            if (IsParallel(count))
                new DilationJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.Dilation(work, count);
        }

        internal override void Run(PaperBands* work, int count)
        {
            if (IsParallel(count))
                new PaperJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.Paper(work, count);
        }

        internal override void Run(PatchBands* work, int count)
        {
            if (IsParallel(count))
                new PatchJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.Patch(work, count);
        }

        internal override void Run(PatchMatchBands* work, int count)
        {
            if (IsParallel(count))
                new PatchMatchJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.PatchMatch(work, count);
        }

        internal override void Run(RatioBands* work, int count)
        {
            if (IsParallel(count))
                new RatioJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.Ratio(work, count);
        }

        internal override void Run(HistogramBands* work, int count)
        {
            if (IsParallel(count))
                new HistogramJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.Histogram(work, count);
        }

        internal override void Run(RescaleBands* work, int count)
        {
            if (IsParallel(count))
                new RescaleJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.Rescale(work, count);
        }

        internal override void Run(RiseBands* work, int count)
        {
            if (IsParallel(count))
                new RiseJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.Rise(work, count);
        }

        internal override void Run(ExpectationBands* work, int count)
        {
            if (IsParallel(count))
                new ExpectationJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.Expectation(work, count);
        }

        internal override void Run(ComparisonBands* work, int count)
        {
            if (IsParallel(count))
                new ComparisonJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.Comparison(work, count);
        }

        internal override void Run(InfraredTileBands* work, int count)
        {
            if (IsParallel(count))
                new InfraredTileJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.InfraredTile(work, count);
        }

        internal override void Run(GreenTileBands* work, int count)
        {
            if (IsParallel(count))
                new GreenTileJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.GreenTile(work, count);
        }

        internal override void Run(DepthGridBands* work, int count)
        {
            if (IsParallel(count))
                new DepthGridJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.DepthGrid(work, count);
        }

        internal override void Run(BridgeBands* work, int count)
        {
            if (IsParallel(count))
                new BridgeJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.Bridge(work, count);
        }

        internal override void Run(DepthLevelBands* work, int count)
        {
            if (IsParallel(count))
                new DepthLevelJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.DepthLevel(work, count);
        }

        internal override void Run(SurfaceBands* work, int count)
        {
            if (IsOnMainThread)
                new SurfaceJob { Work = work }.Run(count);
            else
                BurstLoops.Surface(work, count);
        }

        internal override void Run(TorsoBands* work, int count)
        {
            if (IsOnMainThread)
                new TorsoJob { Work = work }.Run(count);
            else
                BurstLoops.Torso(work, count);
        }

        internal override void Run(CropBands* work, int count)
        {
            if (IsParallel(count))
                new CropJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.Crop(work, count);
        }

        internal override void Run(ExposureBands* work, int count)
        {
            if (IsParallel(count))
                new ExposureJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.Exposure(work, count);
        }

        internal override void Run(ConvolutionBands* work, int count)
        {
            if (IsParallel(count))
                new ConvolutionJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.Convolution(work, count);
        }

        internal override void Run(DepthwiseBands* work, int count)
        {
            if (IsParallel(count))
                new DepthwiseJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.Depthwise(work, count);
        }

        internal override void Run(AddBands* work, int count)
        {
            if (IsParallel(count))
                new AddJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.Add(work, count);
        }

        internal override void Run(MaxPoolBands* work, int count)
        {
            if (IsParallel(count))
                new MaxPoolJob { Work = work }.ScheduleParallel(count, Batch(count), default).Complete();
            else
                BurstLoops.MaxPool(work, count);
        }

        private bool IsOnMainThread => Environment.CurrentManagedThreadId == _mainThread;

        private bool IsParallel(int count) => count > 1 && IsOnMainThread;

        private int Batch(int count) => Math.Max(1, count / (BatchesPerWorker * BandCount));
    }
}
