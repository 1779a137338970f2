using System;
using System.Collections.Generic;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Simulation
{
    public sealed class SimulatedRangeTests
    {
        [Test]
        public void SimulatedRange_SameSeed_GivesSameBytesWhateverTheOrder()
        {
            List<ulong> alone = Fingerprints(Busy().CreateColorSource()), depthAlone = Fingerprints(Busy().CreateDepthSource());
            SimulatedRange range = Busy();
            var color = new List<ulong>();
            var depth = new List<ulong>();
            using (IFrameSource a = range.CreateColorSource())
            using (IFrameSource b = range.CreateDepthSource())
            using (var frame = new Frame())
            {
                bool more = true;
                while (more)
                {
                    more = b.TryRead(frame);
                    if (more)
                        depth.Add(SimulationExamples.Fingerprint(frame.Depth));
                    if (a.TryRead(frame))
                        color.Add(SimulationExamples.Fingerprint(frame.Color));
                    if (more && b.TryRead(frame))
                        depth.Add(SimulationExamples.Fingerprint(frame.Depth));
                }

                while (a.TryRead(frame))
                    color.Add(SimulationExamples.Fingerprint(frame.Color));
            }

            Assert.That(alone.Count, Is.GreaterThan(8));
            Assert.That(color, Is.EqualTo(alone));
            Assert.That(depth, Is.EqualTo(depthAlone));
        }

        [Test]
        public void SimulatedRange_SourcesOnTwoThreads_GiveSameBytes()
        {
            SimulatedRange range = Busy();
            List<ulong> alone = Fingerprints(range.CreateColorSource());
            List<ulong>? first = null, second = null;
            var a = new Thread(() => first = Fingerprints(range.CreateColorSource()));
            var b = new Thread(() => second = Fingerprints(range.CreateColorSource()));
            a.Start();
            b.Start();
            a.Join();
            b.Join();
            Assert.That(first, Is.EqualTo(alone));
            Assert.That(second, Is.EqualTo(alone));
        }

        [Test]
        public void SimulatedRange_OtherSeed_GivesOtherFrames()
        {
            SimulationScenario other = BusyScenario();
            other.Seed++;
            var range = new SimulatedRange(other, SimulationScenes.Default());
            Assert.That(Fingerprints(range.CreateColorSource())[0], Is.Not.EqualTo(Fingerprints(Busy().CreateColorSource())[0]));
            Assert.That(Fingerprints(range.CreateDepthSource())[0], Is.Not.EqualTo(Fingerprints(Busy().CreateDepthSource())[0]));
        }

        [Test]
        public void SimulatedRange_WarmFrameLoop_AllocatesNothing()
        {
            foreach (PixelFormat format in new[] { PixelFormat.Bgra32, PixelFormat.Nv12, PixelFormat.Yuy2 })
            {
                SimulationScenario scenario = BusyScenario();
                scenario.ColorCamera.Format = format;
                scenario.ColorCamera.JpegQuality = format == PixelFormat.Yuy2 ? 85 : 0;
                var range = new SimulatedRange(scenario, SimulationScenes.Default());
                Assert.That(AllocatedAfterWarmUp(range.CreateColorSource()), Is.Zero, format.ToString());
                Assert.That(AllocatedAfterWarmUp(range.CreateDepthSource()), Is.Zero);
            }
        }

        [Test]
        public void SimulatedRange_ShotAtUnknownTarget_IsRefusedByName()
        {
            SimulationScenario scenario = SimulationExamples.Small();
            scenario.Shots.Add(new ShotSettings { TimeS = 0.1, Target = "Bear" });
            var e = Assert.Throws<InputException>(() => new SimulatedRange(scenario, SimulationScenes.Default()));
            Assert.That(e!.Message, Does.Contain("shot 1").And.Contain("\"Bear\"").And.Not.Contain("\n"));
        }

        [Test]
        public void SimulatedRange_SettingOutOfRange_IsRefusedByName()
        {
            SimulationScenario scenario = SimulationExamples.Small();
            scenario.ColorCamera.Gain = double.NaN;
            var e = Assert.Throws<ArgumentException>(() => new SimulatedRange(scenario, SimulationScenes.Default()));
            Assert.That(e!.Message, Does.Contain("color_camera.gain"));
        }

        [Test]
        public void SimulatedRange_DroppedFramesAndClocks_KeepIndicesAndCarryTheirOwnTime()
        {
            SimulationScenario scenario = SimulationExamples.Small(4);
            scenario.DepthCamera.DroppedShare = 0.3;
            scenario.DepthCamera.ClockOffsetUs = 70000;
            scenario.DepthCamera.ClockDriftPpm = 100;
            var range = new SimulatedRange(scenario, SimulationExamples.EmptyScene());
            using IFrameSource source = range.CreateDepthSource();
            using var frame = new Frame();
            int count = 0;
            while (source.TryRead(frame))
            {
                double time = range.Truth.DepthFrameTimeUs(count);
                Assert.That(frame.Index, Is.EqualTo(count));
                Assert.That(frame.TimeUs, Is.EqualTo((long)Math.Round(time * 1.0001 + 70000)));
                count++;
            }

            Assert.That(count, Is.EqualTo(range.Truth.DepthFrameCount).And.InRange(65, 103));
        }

        private static SimulatedRange Busy() => new SimulatedRange(BusyScenario(), SimulationScenes.Default());

        private static SimulationScenario BusyScenario()
        {
            SimulationScenario scenario = SimulationExamples.Small();
            scenario.Shooters[0] = new ShooterSettings { OffsetXM = -0.5 };
            scenario.Shooters.Add(new ShooterSettings { OffsetXM = 0.5, TwoHanded = true });
            scenario.Shots.Add(new ShotSettings { TimeS = 0.1, PulseMs = 60, Target = "Paper 1" });
            scenario.Shots.Add(new ShotSettings { TimeS = 0.1, PulseMs = 300, Shooter = 2, Target = "Paper 2" });
            scenario.Room.FlickerDepth = 0.2;
            scenario.ColorCamera.RollingShutterRowUs = 20;
            return scenario;
        }

        private static List<ulong> Fingerprints(IFrameSource source)
        {
            var result = new List<ulong>();
            using var frame = new Frame();
            while (source.TryRead(frame))
                result.Add(SimulationExamples.Fingerprint(frame.Color.IsPresent ? frame.Color : frame.Depth));
            source.Dispose();
            return result;
        }

        private static long AllocatedAfterWarmUp(IFrameSource source)
        {
            using var frame = new Frame();
            source.TryRead(frame);
            source.TryRead(frame);
            long allocated = Allocation.Of(() => source.TryRead(frame));
            source.Dispose();
            return allocated;
        }
    }
}
