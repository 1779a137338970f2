using System;
using System.Diagnostics;
using System.Threading;

namespace LaserTracking.Host.Benchmarks
{
    /// <summary>
    /// One stage on fixed synthetic work. <see cref="Prepare"/> builds the work outside the measurement and returns the operation,
    /// which is given a running number. One thread; what is allocated is counted on that thread.
    /// </summary>
    internal sealed class Benchmark
    {
        private const int WarmUpOperations = 120;
        private const double MeasuredSeconds = 3;
        private const int MinimumOperations = 50;
        private const int MaximumOperations = 20_000;

        public Benchmark(string name, string what, Func<Action<int>> prepare)
        {
            Name = name;
            What = what;
            Prepare = prepare;
        }

        public string Name { get; }

        public string What { get; }

        public Func<Action<int>> Prepare { get; }

        /// <summary>Says what is not there that it needs; empty when it can run.</summary>
        public Func<string> Missing { get; init; } = () => string.Empty;

        public BenchmarkResult Run(CancellationToken interrupted)
        {
            Action<int> operation = Prepare();
            int number = 0;
            // Long enough for the runtime to replace the quick first compilation by the optimised one.
            var warmUp = Stopwatch.StartNew();
            while (number < WarmUpOperations || warmUp.Elapsed.TotalSeconds < 0.5)
            {
                operation(number++);
                interrupted.ThrowIfCancellationRequested();
            }

            var times = new double[MaximumOperations];
            int count = 0;
            long allocatedBefore = GC.GetAllocatedBytesForCurrentThread();
            long start = Stopwatch.GetTimestamp(), end = start + (long)(MeasuredSeconds * Stopwatch.Frequency);
            for (long now = start; count < MaximumOperations && (now < end || count < MinimumOperations); count++)
            {
                operation(number++);
                long after = Stopwatch.GetTimestamp();
                times[count] = (after - now) * 1e3 / Stopwatch.Frequency;
                now = after;
            }

            long allocated = (GC.GetAllocatedBytesForCurrentThread() - allocatedBefore) / count;
            interrupted.ThrowIfCancellationRequested();
            Array.Sort(times, 0, count);
            return new BenchmarkResult(Name, What, count, times[count / 2], times[(int)(0.95 * (count - 1))], allocated);
        }
    }
}
