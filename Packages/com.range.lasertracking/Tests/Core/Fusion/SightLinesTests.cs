using System;
using LaserTracking.Geometry;
using LaserTracking.Hands;
using NUnit.Framework;

namespace LaserTracking.Fusion
{
    public sealed class SightLinesTests
    {
        private const double MuzzleSigmaM = 0.012;
        private static readonly Vector3D Eyes = new Vector3D(1.4, 0.9, -2.9);

        [TestCase(0.0, 0.2, 0.65, TestName = "Learn_WhoAimsExactly_IsExpectedCloserToTheLine")]
        [TestCase(1.0, 0.8, 1.25, TestName = "Learn_WhoAimsAsExpected_KeepsTheExpectedSpread")]
        [TestCase(2.5, 1.6, 3.0, TestName = "Learn_WhoAimsLoosely_IsExpectedFartherOff")]
        public void Learn_SpreadOfTheAim_IsTakenOver(double errors, double least, double most)
        {
            var settings = new FusionSettings();
            var lines = new SightLines(settings);
            var camera = new HandCamera(new PinholeCamera(504, 504, 320, 288, 640, 576), Pose.Identity);
            lines.See(new PersonObservation { PersonId = 1, EyeMm = Eyes * 1000, SigmaMm = 60 }, camera, 0);
            double reach = 0.75, expected = Math.Sqrt(MuzzleSigmaM * MuzzleSigmaM / (reach * reach) + settings.SightSpreadRad * settings.SightSpreadRad);
            var random = new Random(5);
            for (int i = 0; i < 60; i++)
            {
                Vector3D aim = Aim(i);
                double angle = 2 * Math.PI * random.NextDouble(), size = errors * expected * Math.Sqrt(-2 * Math.Log(1 - random.NextDouble()));
                Vector3D across = Vector3D.Cross(aim, new Vector3D(0, 1, 0)).Normalized, down = Vector3D.Cross(aim, across);
                Vector3D direction = aim + (across * Math.Cos(angle) + down * Math.Sin(angle)) * size;
                lines.Settle(1, lines.Weigh(1, Eyes + aim * reach, MuzzleSigmaM, direction, 1), 1);
            }

            Assert.That(lines.TrySight(1, Eyes + Aim(7) * reach, MuzzleSigmaM, out _, out double sigma), Is.True);
            Assert.That(sigma / expected, Is.InRange(least, most));
        }

        [Test]
        public void Add_TakenBack_LeavesTheLineAsItWas()
        {
            var lines = new SightLines(new FusionSettings());
            lines.See(new PersonObservation { PersonId = 1, EyeMm = Eyes * 1000, SigmaMm = 60 }, new HandCamera(new PinholeCamera(504, 504, 320, 288, 640, 576), Pose.Identity), 0);
            Vector3D muzzle = Eyes + Aim(3) * 0.75 + new Vector3D(0.03, 0, 0);
            lines.TrySight(1, muzzle, MuzzleSigmaM, out Vector3D before, out double sigmaBefore);
            SightEvidence evidence = lines.Weigh(1, muzzle, MuzzleSigmaM, Aim(3), 1);
            lines.Add(1, evidence, 1);
            lines.TrySight(1, muzzle, MuzzleSigmaM, out Vector3D with, out double sigmaWith);
            Assert.That(sigmaWith, Is.LessThan(0.5 * sigmaBefore));
            Assert.That((with - before).Length, Is.GreaterThan(0.01));
            lines.Add(1, evidence, -1);
            lines.TrySight(1, muzzle, MuzzleSigmaM, out Vector3D after, out double sigmaAfter);
            Assert.That((after - before).Length, Is.LessThan(1e-9));
            Assert.That(sigmaAfter, Is.EqualTo(sigmaBefore).Within(1e-9));
        }

        private static Vector3D Aim(int i) => (new Vector3D(0.4 + 0.3 * (i % 11), 0.3 + 0.25 * (i % 7), 0) - Eyes).Normalized;
    }
}
