using System;
using LaserTracking.Geometry;
using NUnit.Framework;

namespace LaserTracking.Scoring
{
    public sealed class PoseHistoryTests
    {
        private static readonly Vector3D Up = new Vector3D(0, 1, 0);

        [Test]
        public void TryGetPoseAt_Empty_IsFalse()
        {
            Assert.That(new PoseHistory(4).TryGetPoseAt(0, out _), Is.False);
        }

        [Test]
        public void TryGetPoseAt_BetweenTwo_Interpolates()
        {
            var history = new PoseHistory(4);
            history.Add(1, At(0, 0));
            history.Add(2, At(4, 1));
            history.TryGetPoseAt(1.5, out Pose pose);
            Assert.That(pose.Position.X, Is.EqualTo(2).Within(1e-12));
            Vector3D turned = pose.TransformDirection(new Vector3D(0, 0, 1));
            Assert.That(Math.Atan2(turned.X, turned.Z), Is.EqualTo(0.5).Within(1e-12), "half the turn");
        }

        [Test]
        public void TryGetPoseAt_RotationOfOppositeSign_TakesTheShortWay()
        {
            var history = new PoseHistory(4);
            history.Add(0, At(0, 0.1));
            Rotation3D r = Rotation3D.AboutAxis(Up, 0.3);
            history.Add(1, new Pose(default, new Rotation3D(-r.X, -r.Y, -r.Z, -r.W)));
            history.TryGetPoseAt(0.5, out Pose pose);
            Vector3D turned = pose.TransformDirection(new Vector3D(0, 0, 1));
            Assert.That(Math.Atan2(turned.X, turned.Z), Is.EqualTo(0.2).Within(1e-9));
        }

        [Test]
        public void TryGetPoseAt_OutsideWhatIsKept_IsTheNearestKept()
        {
            var history = new PoseHistory(3);
            for (int i = 0; i < 8; i++)
                history.Add(i, At(i, 0));
            history.TryGetPoseAt(0, out Pose first);
            history.TryGetPoseAt(99, out Pose last);
            history.TryGetPoseAt(6, out Pose exact);
            Assert.That(first.Position.X, Is.EqualTo(5), "older ones are overwritten");
            Assert.That(last.Position.X, Is.EqualTo(7));
            Assert.That(exact.Position.X, Is.EqualTo(6));
            Assert.That(history.Count, Is.EqualTo(3));
        }

        [Test]
        public void Add_ClockThatStandsStill_KeepsThePastAndTheNewestPose()
        {
            var history = new PoseHistory(4);
            history.Add(1, At(0, 0));
            history.Add(2, At(4, 0));
            history.Add(2, At(6, 0));
            history.TryGetPoseAt(1.5, out Pose pose);
            Assert.That(pose.Position.X, Is.EqualTo(3).Within(1e-12));
        }

        [Test]
        public void Add_TimeThatRunsBack_ForgetsThePast()
        {
            var history = new PoseHistory(3);
            history.Add(10, At(10, 0));
            history.Add(11, At(11, 0));
            history.Add(2, At(2, 0));
            history.TryGetPoseAt(10.5, out Pose pose);
            Assert.That(pose.Position.X, Is.EqualTo(2));
            Assert.That(history.Count, Is.EqualTo(1));
        }

        private static Pose At(double x, double angleRad) => new Pose(new Vector3D(x, 0, 0), Rotation3D.AboutAxis(Up, angleRad));
    }
}
