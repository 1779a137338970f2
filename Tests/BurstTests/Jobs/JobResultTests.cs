using System;
using System.Collections.Generic;
using System.Linq;
using System.Reflection;
using System.Threading;
using LaserTracking.Kernels;
using NUnit.Framework;
using Unity.Jobs;
using UnityStandIn;

namespace LaserTracking.Burst
{
    /// <summary>Every job over random memory: what it leaves behind is, byte for byte, what the calling thread alone leaves in one band.</summary>
    public sealed class JobResultTests
    {
        private const int Seeds = 12;

        private static readonly Dictionary<string, KernelCase> Cases = new[] { typeof(DetectionCases), typeof(HandCases) }
            .SelectMany(type => type.GetMethods(BindingFlags.Static | BindingFlags.Public))
            .ToDictionary(method => method.Name, method => method.CreateDelegate<KernelCase>());

        private delegate void KernelCase(KernelRunner kernels, Arena data, Arena scratch, Random random);

        private static IEnumerable<string> Jobs => JobTypes.Select(type => type.Name.Substring(0, type.Name.Length - "Job".Length));

        private static IEnumerable<Type> JobTypes => typeof(BurstKernelRunner).Assembly.GetTypes().Where(type => typeof(IJobFor).IsAssignableFrom(type));

        [Test]
        public void Jobs_EachOfThem_HasItsCase()
        {
            Assert.That(Jobs, Is.EquivalentTo(Cases.Keys));
            Assert.That(Cases, Has.Count.EqualTo(24));
        }

        [Test]
        public void Job_AnyOrderOfItsBatches_LeavesTheSameBytes([ValueSource(nameof(Jobs))] string name, [Values] JobOrder order, [Values(1, 6)] int workers)
        {
            JobWorkers.Reset(order, workers);
            var kernels = new BurstKernelRunner();
            for (int seed = 1; seed <= Seeds; seed++)
                AssertSame(name, seed, kernels);
            Assert.That(JobWorkers.Runs, Contains.Key(name + "Job"), "ran as a job");
        }

        [Test]
        public void Job_CalledFromAnotherThread_RunsThereAndLeavesTheSameBytes([ValueSource(nameof(Jobs))] string name)
        {
            JobWorkers.Reset(JobOrder.Scrambled, 4);
            var kernels = new BurstKernelRunner();
            Exception? failure = null;
            var thread = new Thread(() =>
            {
                try
                {
                    for (int seed = 1; seed <= Seeds; seed++)
                        AssertSame(name, seed, kernels);
                }
                catch (Exception problem)
                {
                    failure = problem;
                }
            });
            thread.Start();
            thread.Join();
            Assert.That(failure, Is.Null);
            Assert.That(JobWorkers.Runs, Is.Empty, "only the main thread may schedule");
        }

        [Test]
        public void Run_Warm_AllocatesNothing([ValueSource(nameof(Jobs))] string name)
        {
            JobWorkers.Reset();
            var kernels = new BurstKernelRunner();
            using var data = new Arena(1);
            using var scratch = new Arena(2);
            long bytes = -1;
            Cases[name](new HookedRunner(kernels, run => bytes = Allocation.Of(run)), data, scratch, new Random(1));
            Assert.That(bytes, Is.Zero);
        }

        [Test]
        public void Case_WithoutItsKernel_LeavesOtherBytes([ValueSource(nameof(Jobs))] string name)
        {
            using Arena run = Play(name, 1, KernelRunner.Plain), notRun = Play(name, 1, new HookedRunner(KernelRunner.Plain, _ => { }));
            Assert.That(run.Bytes.SequenceEqual(notRun.Bytes), Is.False);
        }

        private static void AssertSame(string name, int seed, KernelRunner kernels)
        {
            using Arena plain = Play(name, seed, KernelRunner.Plain), jobs = Play(name, seed, kernels);
            if (!plain.Bytes.SequenceEqual(jobs.Bytes))
                Assert.Fail(name + ", seed " + seed + ": first difference at byte " + plain.Bytes.CommonPrefixLength(jobs.Bytes));
        }

        private static Arena Play(string name, int seed, KernelRunner kernels)
        {
            var data = new Arena(seed);
            using var scratch = new Arena(seed + 1000);
            Cases[name](kernels, data, scratch, new Random(seed));
            return data;
        }
    }
}
