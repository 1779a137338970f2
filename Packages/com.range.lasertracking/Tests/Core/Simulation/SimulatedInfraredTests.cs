using LaserTracking.Capture;
using LaserTracking.Detection;
using LaserTracking.Geometry;
using LaserTracking.Imaging;
using NUnit.Framework;

namespace LaserTracking.Simulation
{
    public sealed unsafe class SimulatedInfraredTests
    {
        [Test]
        public void Infrared_NotEnabled_FramesHoldColorAlone()
        {
            var range = new SimulatedRange(SimulationExamples.Small(), SimulationExamples.EmptyScene());
            using IFrameSource source = range.CreateColorSource();
            using var frame = new Frame();
            Assert.That(source.TryRead(frame), Is.True);
            Assert.That(frame.Infrared.IsPresent, Is.False);
            Assert.That(range.InfraredMapping, Is.Null);
        }

        [Test]
        public void Infrared_EmitterAt850_ShinesWhereTheMappingPutsIt()
        {
            SimulatedRange range = Range(LaserColor.Infrared, false);
            Vector2D brightest = Brightest(range, out int peak);
            Assert.That(peak, Is.GreaterThan(300));
            Assert.That(range.InfraredMapping!.TryMap(brightest, out Vector2D colorPx), Is.True);
            TrueDot dot = range.Truth.DotsOf(5)[0];
            Assert.That((colorPx - dot.PositionPx).Length, Is.LessThan(2));
        }

        [Test]
        public void Infrared_LaserAt532_IsNotInIt()
        {
            Brightest(Range(LaserColor.Green, false), out int peak);
            Assert.That(peak, Is.LessThan(150));
        }

        [Test]
        public void Infrared_ActiveIllumination_IsTenTimesAsBright()
        {
            double passive = Mean(Range(LaserColor.Green, false)), active = Mean(Range(LaserColor.Green, true));
            Assert.That(passive, Is.EqualTo(80).Within(4));
            Assert.That(active, Is.EqualTo(10 * passive).Within(0.02 * active));
        }

        [Test]
        public void Infrared_SameSeed_GivesTheSameBytes()
        {
            using Frame first = Read(Range(LaserColor.Infrared, false)), second = Read(Range(LaserColor.Infrared, false));
            Assert.That(SimulationExamples.Fingerprint(first.Infrared), Is.EqualTo(SimulationExamples.Fingerprint(second.Infrared)));
        }

        private static SimulatedRange Range(LaserColor color, bool active)
        {
            SimulationScenario scenario = SimulationExamples.Small();
            scenario.InfraredCamera.Enabled = true;
            scenario.InfraredCamera.Width = scenario.InfraredCamera.Height = 256;
            scenario.InfraredCamera.Active = active;
            scenario.Shooters[0].Laser.Color = color;
            scenario.Shots.Add(new ShotSettings { TimeS = 0.1, PulseMs = 290, ScreenM = new Vector2D(1.1, 0.7) });
            return new SimulatedRange(scenario, SimulationExamples.EmptyScene());
        }

        private static Frame Read(SimulatedRange range)
        {
            using IFrameSource source = range.CreateColorSource();
            var frame = new Frame();
            while (source.TryRead(frame) && frame.Index < 5)
            {
            }

            Assert.That(frame.Infrared.Format, Is.EqualTo(PixelFormat.Infrared16));
            return frame;
        }

        private static Vector2D Brightest(SimulatedRange range, out int peak)
        {
            using Frame frame = Read(range);
            peak = -1;
            int best = 0;
            var pixels = (ushort*)frame.Infrared.Pixels;
            for (int i = 0; i < frame.Infrared.Width * frame.Infrared.Height; i++)
            {
                if (pixels[i] <= peak)
                    continue;
                peak = pixels[i];
                best = i;
            }

            return new Vector2D(best % frame.Infrared.Width, best / frame.Infrared.Width);
        }

        private static double Mean(SimulatedRange range)
        {
            using Frame frame = Read(range);
            double sum = 0;
            int count = frame.Infrared.Width * frame.Infrared.Height;
            for (int i = 0; i < count; i++)
                sum += ((ushort*)frame.Infrared.Pixels)[i];
            return sum / count;
        }
    }
}
