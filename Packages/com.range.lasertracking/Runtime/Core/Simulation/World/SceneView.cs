using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Scoring;

namespace LaserTracking.Simulation
{
    /// <summary>How the scene's targets appear on the screen, seen from the viewpoint. Immutable; no allocation after construction.</summary>
    internal sealed class SceneView
    {
        private readonly int[] _farToNear;
        private readonly Vector3D _eye;

        public SceneView(SceneModel scene)
        {
            Scene = scene;
            _eye = scene.Surface.InverseTransformPoint(scene.Viewpoint);
            if (!(_eye.Z < 0))
                throw new ArgumentException("the scene's viewpoint must lie in front of the screen surface");
            var targets = new List<int>();
            for (int i = 0; i < scene.Objects.Count; i++)
            {
                if (scene.Objects[i].Target != null)
                    targets.Add(i);
            }

            // Ties keep the scene's order: a stable sort, so that equal scenes draw equally.
            targets.Sort((a, b) =>
            {
                int order = Depth(b).CompareTo(Depth(a));
                return order != 0 ? order : a.CompareTo(b);
            });
            _farToNear = targets.ToArray();
        }

        public SceneModel Scene { get; }

        /// <summary>The viewpoint in the surface's axes.</summary>
        public Vector3D EyeM => _eye;

        /// <summary>Indices of the objects that are targets, the farthest first.</summary>
        public ReadOnlySpan<int> FarToNear => _farToNear;

        public static bool Moves(SceneObject item) => item.Motion.Kind != MotionKind.None;

        /// <summary>From the target's plane (m) to screen space (m) at a time.</summary>
        public PlaneMap TargetToScreen(int objectIndex, double timeS)
        {
            Pose pose = Scene.Objects[objectIndex].PoseAt(timeS);
            Vector3D o = Scene.Surface.InverseTransformPoint(pose.Position);
            Vector3D u = Scene.Surface.InverseTransformDirection(pose.TransformDirection(new Vector3D(1, 0, 0)));
            Vector3D v = Scene.Surface.InverseTransformDirection(pose.TransformDirection(new Vector3D(0, 1, 0)));
            // The line from the eye through S = o + x u + y v meets z = 0 at (S.xy e.z − e.xy S.z) / (e.z − S.z).
            double ex = _eye.X, ey = _eye.Y, ez = _eye.Z;
            var toSurface = new PlaneMap(
                u.X * ez - ex * u.Z, v.X * ez - ex * v.Z, o.X * ez - ex * o.Z,
                u.Y * ez - ey * u.Z, v.Y * ez - ey * v.Z, o.Y * ez - ey * o.Z,
                -u.Z, -v.Z, ez - o.Z);
            Vector2D size = Scene.ScreenSizeM;
            return new PlaneMap(1, 0, size.X / 2, 0, -1, size.Y / 2, 0, 0, 1) * toSurface;
        }

        /// <summary>The nearest target whose zones hold the screen point as seen from the viewpoint; index -1 when there is none.</summary>
        public int Pick(Vector2D screenM, double timeS, out int zone, out Vector2D localM)
        {
            for (int i = _farToNear.Length - 1; i >= 0; i--)
            {
                localM = TargetToScreen(_farToNear[i], timeS).Inverse.Map(screenM);
                zone = Scene.Objects[_farToNear[i]].Target!.ZoneAt(localM);
                if (zone >= 0)
                    return _farToNear[i];
            }

            zone = -1;
            localM = default;
            return -1;
        }

        public int Find(string targetName)
        {
            foreach (int i in _farToNear)
            {
                if (Scene.Objects[i].Name == targetName)
                    return i;
            }

            return -1;
        }

        private double Depth(int objectIndex) =>
            (Scene.Objects[objectIndex].PoseAt(0).Position - Scene.Viewpoint).Length;
    }
}
