// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityStandIn;

namespace Unity.Jobs
{
    public static class IJobForExtensions
    {
        public static JobHandle ScheduleParallel<T>(this T jobData, int arrayLength, int innerloopBatchCount, JobHandle dependency) where T : struct, IJobFor
        {
            dependency.Complete();
            return new JobHandle(JobWorkers.Schedule(jobData, arrayLength, innerloopBatchCount));
        }

        /// <summary>In order, on the calling thread, at once.</summary>
        public static void Run<T>(this T jobData, int arrayLength) where T : struct, IJobFor => JobWorkers.Run(jobData, arrayLength);
    }
}
