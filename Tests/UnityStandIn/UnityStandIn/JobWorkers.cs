// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading.Tasks;
using Unity.Jobs;

namespace UnityStandIn
{
    /// <summary>
    /// The job system in the hands of a test: batches in the order chosen, each on a copy of the job, as on Unity's workers. A job runs
    /// when it is completed; only in forward order, where nobody can tell and nothing may be allocated, when it is scheduled. Like
    /// Unity, it lets one thread only schedule, and refuses jobs with fields that it cannot copy.
    /// </summary>
    public static class JobWorkers
    {
        private static readonly List<Action> Scheduled = new List<Action>();
        private static readonly Dictionary<string, int> RunCounts = new Dictionary<string, int>();
        private static Random _random = new Random(1);
        private static int? _mainThread;

        public static int Count { get; set; } = 3;

        public static JobOrder Order { get; private set; }

        /// <summary>Completed jobs, by the name of their type.</summary>
        public static IReadOnlyDictionary<string, int> Runs => RunCounts;

        /// <summary>The calling thread is the main thread from now on; forgets all jobs.</summary>
        public static void Reset(JobOrder order = JobOrder.Forward, int count = 3)
        {
            _mainThread = Environment.CurrentManagedThreadId;
            _random = new Random(1);
            Order = order;
            Count = count;
            Scheduled.Clear();
            RunCounts.Clear();
        }

        internal static int Schedule<T>(T job, int length, int batch) where T : struct, IJobFor
        {
            Admit<T>();
            batch = Math.Max(1, batch);
            if (Order != JobOrder.Forward)
                return Defer(job, length, batch);
            for (int first = 0; first < length; first += batch)
                RunBatch(job, first, Math.Min(length, first + batch));
            return 0;
        }

        internal static void Run<T>(T job, int length) where T : struct, IJobFor
        {
            Admit<T>();
            RunBatch(job, 0, length);
        }

        private static void Admit<T>() where T : struct, IJobFor
        {
            if (_mainThread != null && _mainThread != Environment.CurrentManagedThreadId)
                throw new InvalidOperationException("only the main thread may schedule jobs");
            if (JobFields<T>.Problem != null)
                throw new InvalidOperationException(JobFields<T>.Problem);
            RunCounts.TryGetValue(JobFields<T>.Name, out int before);
            RunCounts[JobFields<T>.Name] = before + 1;
        }

        internal static void Complete(int number)
        {
            if (number == 0 || Scheduled[number - 1] == null)
                return;
            Action run = Scheduled[number - 1];
            Scheduled[number - 1] = null;
            if (Scheduled.All(job => job == null))
                Scheduled.Clear();
            run();
        }

        private static int Defer<T>(T job, int length, int batch) where T : struct, IJobFor
        {
            Scheduled.Add(() => Run(job, length, batch));
            return Scheduled.Count;
        }

        private static void Run<T>(T job, int length, int batch) where T : struct, IJobFor
        {
            int[] batches = Enumerable.Range(0, (length + batch - 1) / batch).ToArray();
            if (Order == JobOrder.Backward)
                Array.Reverse(batches);
            if (Order == JobOrder.Scrambled)
                batches = batches.OrderBy(_ => _random.Next()).ToArray();
            if (Order == JobOrder.Parallel)
                Parallel.ForEach(batches, number => RunBatch(job, number * batch, Math.Min(length, (number + 1) * batch)));
            else
                Array.ForEach(batches, number => RunBatch(job, number * batch, Math.Min(length, (number + 1) * batch)));
        }

        private static void RunBatch<T>(T copy, int first, int end) where T : struct, IJobFor
        {
            for (int i = first; i < end; i++)
                copy.Execute(i);
        }
    }
}
