using System;
using NUnit.Framework;

namespace LaserTracking.Geometry
{
    public sealed class PoseTests
    {
        [Test]
        public void Pose_InverseTransformPoint_UndoesTransformPoint()
        {
            var pose = new Pose(new Vector3D(1, -2, 3), Rotation3D.AboutAxis(new Vector3D(1, 2, 3), 0.7));
            Vector3D back = pose.InverseTransformPoint(pose.TransformPoint(new Vector3D(0.3, 0.2, -5)));
            Assert.That((back - new Vector3D(0.3, 0.2, -5)).Length, Is.LessThan(1e-12));
        }

        [Test]
        public void Pose_Product_TransformsByTheChildFirst()
        {
            var parent = new Pose(new Vector3D(0, 0, 10), Rotation3D.AboutAxis(new Vector3D(0, 1, 0), Math.PI / 2));
            var child = new Pose(new Vector3D(1, 0, 0), Rotation3D.Identity);
            Vector3D point = (parent * child).TransformPoint(default);
            Assert.That((point - new Vector3D(0, 0, 9)).Length, Is.LessThan(1e-12));
        }
    }
}
