using System;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Simulation
{
    public sealed unsafe class SimulatedDepthSourceTests
    {
        [Test]
        public void SimulatedDepthSource_Noise_HasTheStandardDeviationOfTheSettings()
        {
            SimulationScenario scenario = SimulationExamples.Small(3.01);
            scenario.Shooters.Clear();
            scenario.DepthCamera.RandomHoleShare = 0;
            scenario.DepthCamera.NoiseFarMm = 30;
            var range = new SimulatedRange(scenario, SimulationExamples.EmptyScene());
            using IFrameSource source = range.CreateDepthSource();
            using var frame = new Frame();
            const int y = 150, left = 100, count = 120;
            var sum = new double[count];
            var squares = new double[count];
            int n = 0;
            for (; source.TryRead(frame); n++)
            {
                var row = (ushort*)(frame.Depth.Pixels + y * frame.Depth.Stride);
                for (int i = 0; i < count; i++)
                {
                    sum[i] += row[left + i];
                    squares[i] += (double)row[left + i] * row[left + i];
                }
            }

            double variance = 0, expected = 0;
            var geometry = new DepthCameraGeometry(scenario.DepthCamera, scenario.Room, new Vector2D(3.2, 1.8));
            for (int i = 0; i < count; i++)
            {
                double mean = sum[i] / n, sigma = DepthSensor.SigmaMm(scenario.DepthCamera, geometry, mean);
                Assert.That(mean, Is.InRange(1000, 5400));
                variance += (squares[i] - n * mean * mean) / (n - 1);
                expected += sigma * sigma + 1 / 12.0;
            }

            Assert.That(expected / count, Is.GreaterThan(9));
            Assert.That(Math.Sqrt(variance / expected), Is.EqualTo(1).Within(0.04));
        }

        [Test]
        public void SimulatedDepthSource_Defaults_StayWithinThePublishedErrors()
        {
            var settings = new DepthCameraSettings();
            var geometry = new DepthCameraGeometry(settings, new RoomSettings(), new Vector2D(3.2, 1.8));
            Assert.That(DepthSensor.SigmaMm(settings, geometry, geometry.FarMm), Is.LessThanOrEqualTo(17));
            Assert.That(settings.SystematicMm, Is.LessThan(11));
            Assert.That(geometry.Width, Is.EqualTo(640));
            Assert.That(geometry.Height, Is.EqualTo(576));
        }

        [TestCase(false)]
        [TestCase(true)]
        public void SimulatedDepthSource_Arm_IsSeenWhereTruthSays(bool binned)
        {
            SimulationScenario scenario = SimulationExamples.Small(1);
            scenario.DepthCamera.Binned = binned;
            scenario.DepthCamera.NoiseNearMm = scenario.DepthCamera.NoiseFarMm = scenario.DepthCamera.SystematicMm = 0;
            scenario.DepthCamera.RandomHoleShare = scenario.DepthCamera.EdgeHoleShare = scenario.DepthCamera.LostPalmShare = 0;
            scenario.DepthCamera.MotionHoleShare = 0;
            scenario.Shots.Add(new ShotSettings { TimeS = 0.5, PulseMs = 300, ScreenM = new Vector2D(1.2, 0.7) });
            var range = new SimulatedRange(scenario, SimulationExamples.EmptyScene());
            HandCamera camera = range.Calibration.HandCamera!;
            using IFrameSource source = range.CreateDepthSource();
            using var frame = new Frame();
            while (frame.Index < 18 && source.TryRead(frame))
            {
            }

            TrueHand hand = range.Truth.HandAt(1, range.Truth.DepthFrameTimeUs(18));
            // The surface lies in front of the point inside by no more than the limb's radius, seen along a slanting ray.
            Check(frame, camera, (hand.ElbowM + hand.WristM) * 0.5, 75);
            Check(frame, camera, hand.PalmM, 85);
            // A quarter of the weapon returns no depth: three places along it are not all lost.
            int seen = 0;
            for (int i = 3; i <= 9; i += 3)
            {
                int depth = At(frame, camera, hand.MuzzleM - hand.BarrelDirection * (0.01 * i), out double truth);
                Assert.That(depth == 0 || depth > truth - 130 && depth < truth + 8, Is.True, depth + " for " + truth);
                seen += depth > 0 ? 1 : 0;
            }

            Assert.That(seen, Is.GreaterThan(0));
            Assert.That(frame.Depth.Bytes[0] | frame.Depth.Bytes[1], Is.Zero, "outside the hexagon");
        }

        [Test]
        public void SimulatedDepthSource_LostPalm_LeavesAHoleAndTheArm()
        {
            SimulationScenario scenario = SimulationExamples.Small(0.2);
            scenario.DepthCamera.LostPalmShare = 1;
            scenario.DepthCamera.EdgeHoleShare = scenario.DepthCamera.RandomHoleShare = 0;
            // Pointing up, so that the forearm is not hidden behind the hand.
            scenario.Shots.Add(new ShotSettings { TimeS = 0.1, PulseMs = 90, ScreenM = new Vector2D(1.6, 0.2) });
            var range = new SimulatedRange(scenario, SimulationExamples.EmptyScene());
            using IFrameSource source = range.CreateDepthSource();
            using var frame = new Frame();
            while (frame.Index < 4 && source.TryRead(frame))
            {
            }

            TrueHand hand = range.Truth.HandAt(1, range.Truth.DepthFrameTimeUs(4));
            Assert.That(At(frame, range.Calibration.HandCamera!, hand.PalmM, out _), Is.Zero);
            Assert.That(At(frame, range.Calibration.HandCamera!, (hand.ElbowM + hand.WristM) * 0.5, out _), Is.GreaterThan(0));
        }

        private static void Check(Frame frame, HandCamera camera, Vector3D pointM, double depthOfLimbMm)
        {
            int measured = At(frame, camera, pointM, out double truth);
            if (measured > 0)
                Assert.That(measured, Is.InRange(truth - depthOfLimbMm, truth + 8));
            else
                Assert.Fail("no depth at " + pointM);
        }

        private static int At(Frame frame, HandCamera camera, Vector3D pointM, out double depthMm)
        {
            Vector3D mm = camera.ToCameraMm(pointM);
            depthMm = mm.Z;
            Assert.That(camera.Intrinsics.TryProject(mm, out Vector2D p), Is.True);
            int x = (int)Math.Round(p.X), y = (int)Math.Round(p.Y);
            Assert.That(x >= 0 && y >= 0 && x < frame.Depth.Width && y < frame.Depth.Height, Is.True, "in the picture: " + p);
            return ((ushort*)(frame.Depth.Pixels + y * frame.Depth.Stride))[x];
        }
    }
}
