using System;
using System.Collections.Generic;
using NUnit.Framework;

namespace LaserTracking.Capture.Live
{
    public sealed class DeviceClockTests
    {
        private const long IntervalUs = 33_333;

        [Test]
        public void Map_SteadyArrivals_GivesTheTimeOfTheLight()
        {
            var clock = new DeviceClock(60);
            for (long i = 0; i < 300; i++)
                Assert.That(clock.Map(7_000_000 + i * IntervalUs, 90_000_000 + i * IntervalUs + 60_000), Is.EqualTo(90_000_000 + i * IntervalUs).Within(1));
        }

        [Test]
        public void Map_ArrivalsThatJitter_KeepsTheDevicesIntervals()
        {
            var clock = new DeviceClock(0);
            var random = new Random(3);
            long last = 0;
            for (long i = 0; i < 3000; i++)
            {
                long now = clock.Map(i * IntervalUs, 5_000_000 + i * IntervalUs + (long)(random.NextDouble() * random.NextDouble() * 30_000));
                if (i > 300)
                {
                    Assert.That(now - last, Is.EqualTo(IntervalUs).Within(IntervalUs * 250e-6));
                    Assert.That(now - 5_000_000 - i * IntervalUs, Is.InRange(-1, 3000), "the quickest arrivals count");
                }

                last = now;
            }
        }

        [TestCase(40e-6)]
        [TestCase(-40e-6)]
        public void Map_ClockThatDrifts_IsFollowedForHours(double drift)
        {
            var clock = new DeviceClock(0);
            var random = new Random(5);
            for (long i = 0; i < 30 * 3600 * 2; i++)
            {
                long trueUs = i * IntervalUs;
                long now = clock.Map((long)(trueUs * (1 + drift)), trueUs + (long)(random.NextDouble() * 10_000));
                if (i > 3000)
                    Assert.That(now - trueUs, Is.InRange(-1000, 3000));
            }
        }

        [Test]
        public void Map_DeviceThatStartsAnew_NeverRunsBack()
        {
            var clock = new DeviceClock(10);
            var times = new List<long>();
            long arrival = 50_000_000;
            for (int life = 0; life < 5; life++)
            {
                for (int i = 0; i < 60; i++, arrival += IntervalUs)
                    times.Add(clock.Map(i * IntervalUs + life * 100, arrival));
                clock.Restart();
                arrival += life * 700_000;
            }

            Assert.That(times, Is.Ordered.Ascending);
            Assert.That(times, Is.Unique);
            Assert.That(times[times.Count - 1], Is.EqualTo(arrival - 4 * 700_000 - IntervalUs - 10_000).Within(1000));
        }

        [Test]
        public void Map_TimesOfAFemto_AreMicrosecondsSince1970()
        {
            var clock = new DeviceClock(0);
            clock.Map(1_730_796_756_988_167, 3_000_000);
            Assert.That(clock.Map(1_730_796_757_021_500, 3_033_333), Is.EqualTo(3_033_333));
        }

        [Test]
        public void Map_AnyTimesAtAll_Rise()
        {
            var random = new Random(11);
            var clock = new DeviceClock(30);
            long last = long.MinValue, arrival = 0;
            for (int i = 0; i < 20000; i++)
            {
                arrival += random.Next(100_000);
                if (random.Next(50) == 0)
                    clock.Restart();
                long device = random.Next(4) == 0 ? (long)((random.NextDouble() - 0.5) * 1e15) : arrival + random.Next(1000);
                long now = clock.Map(device, arrival);
                Assert.That(now, Is.GreaterThan(last));
                last = now;
            }
        }
    }
}
