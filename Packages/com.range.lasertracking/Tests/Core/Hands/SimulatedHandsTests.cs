using System;
using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Geometry;
using LaserTracking.Simulation;
using NUnit.Framework;

namespace LaserTracking.Hands
{
    /// <summary>Palm and muzzle of one simulated shooter at the sensor's published noise, against the simulation's truth.</summary>
    public sealed class SimulatedHandsTests
    {
        [TestCase(false, HandSide.Right, 1.9)]
        [TestCase(true, HandSide.Right, 2.4)]
        [TestCase(true, HandSide.Left, 2.4)]
        [Category("Long")]
        public void Process_WeaponRaised_PalmAndMuzzleWithinTheAskedDistances(bool twoHanded, HandSide side, double distanceM)
        {
            var scenario = new SimulationScenario { Seed = 41, DurationS = 5 };
            scenario.Shooters.Add(new ShooterSettings { TwoHanded = twoHanded, Hand = side, DistanceM = distanceM });
            for (int i = 0; i < 4; i++)
                scenario.Shots.Add(new ShotSettings { TimeS = 1.2 + 0.9 * i, PulseMs = 40, ScreenM = new Vector2D(1.1 + 0.4 * i, 0.6 + 0.2 * (i % 3)) });
            var range = new SimulatedRange(scenario, SimulationScenes.Default());
            HandCamera camera = range.Calibration.HandCamera!;
            var tracker = new DepthHandTracker(camera);
            var hands = new HandObservations();
            var palms = new List<double>();
            var muzzles = new List<double>();
            var bearings = new List<double>();
            using IFrameSource source = range.CreateDepthSource();
            using var frame = new Frame();
            for (int i = 0; source.TryRead(frame); i++)
            {
                tracker.Process(frame, hands);
                if (i < 40)
                    continue;
                TrueHand truth = range.Truth.HandAt(1, range.Truth.DepthFrameTimeUs(i));
                double palm = double.PositiveInfinity, muzzle = double.PositiveInfinity;
                foreach (HandObservation hand in hands.Hands)
                {
                    palm = Math.Min(palm, (camera.ToScreenM(hand.PalmMm) - truth.PalmM).Length * 1000);
                    double off = (camera.ToScreenM(hand.MuzzleMm) - truth.MuzzleM).Length * 1000;
                    muzzle = Math.Min(muzzle, off);
                    Vector3D weapon = camera.PoseInScreenMm.TransformDirection(hand.WeaponDirection);
                    if (off < 30 && weapon.LengthSquared > 0)
                        bearings.Add(Math.Abs(Math.Atan2(weapon.X, weapon.Z) - Math.Atan2(truth.LightDirection.X, truth.LightDirection.Z)));
                }

                palms.Add(palm);
                muzzles.Add(muzzle);
            }

            palms.Sort();
            muzzles.Sort();
            bearings.Sort();
            Assert.That(palms[palms.Count / 2], Is.LessThanOrEqualTo(25), "palm, median");
            Assert.That(palms[(int)(0.95 * palms.Count)], Is.LessThanOrEqualTo(60), "palm, 95 %");
            Assert.That(muzzles[muzzles.Count / 2], Is.LessThanOrEqualTo(12), "muzzle, median");
            Assert.That(muzzles[(int)(0.95 * muzzles.Count)], Is.LessThanOrEqualTo(30), "muzzle, 95 %");
            Assert.That(bearings.Count, Is.GreaterThan(palms.Count / 2), "bearings told");
            Assert.That(bearings[bearings.Count / 2], Is.LessThanOrEqualTo(0.2), "bearing of the weapon, median");
        }
    }
}
