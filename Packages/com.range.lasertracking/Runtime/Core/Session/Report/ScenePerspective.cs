using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Scoring;

namespace LaserTracking.Session
{
    /// <summary>Where points of the scene appear on the screen, seen from the scene's viewpoint.</summary>
    internal sealed class ScenePerspective
    {
        private const double NearestM = 1e-3;
        private readonly SceneModel _scene;
        private readonly Vector3D _eye;

        public ScenePerspective(SceneModel scene)
        {
            _scene = scene;
            _eye = scene.Surface.InverseTransformPoint(scene.Viewpoint);
        }

        /// <summary>Screen metres of a scene point; false beside or behind the eye.</summary>
        public bool TryProject(Vector3D scenePoint, out Vector2D screenM)
        {
            Vector3D local = _scene.Surface.InverseTransformPoint(scenePoint);
            screenM = default;
            double depth = local.Z - _eye.Z;
            if (!(depth > NearestM) || !(_eye.Z < 0))
                return false;
            screenM = OnScreen(local);
            return screenM.IsFinite;
        }

        /// <summary>Screen metres of a point in a target's plane, at a time on the scene's clock.</summary>
        public bool TryProject(SceneObject target, double timeS, Vector2D localM, out Vector2D screenM) =>
            TryProject(target.PoseAt(timeS).TransformPoint(new Vector3D(localM.X, localM.Y, 0)), out screenM);

        public double DistanceTo(Vector3D scenePoint) => (scenePoint - _scene.Viewpoint).Length;

        /// <summary>
        /// A covariance on the screen carried into a target's plane: the inverse of how the plane's axes appear on the screen.
        /// False for a target seen edge-on.
        /// </summary>
        public bool TryToTargetMm2(SceneObject target, double timeS, Vector2D localM, Covariance2D screenMm2, out Covariance2D targetMm2)
        {
            const double step = 1e-3;
            targetMm2 = default;
            if (!TryProject(target, timeS, localM, out Vector2D at) ||
                !TryProject(target, timeS, localM + new Vector2D(step, 0), out Vector2D right) ||
                !TryProject(target, timeS, localM + new Vector2D(0, step), out Vector2D up))
                return false;
            double a = (right.X - at.X) / step, b = (up.X - at.X) / step, c = (right.Y - at.Y) / step, d = (up.Y - at.Y) / step;
            double determinant = a * d - b * c;
            if (!(Math.Abs(determinant) > 1e-6))
                return false;
            targetMm2 = screenMm2.Transform(d / determinant, -b / determinant, -c / determinant, a / determinant);
            return true;
        }

        /// <summary>Outline on the screen of a convex collider, cut off at the screen's plane; empty when nothing lies behind it.</summary>
        public List<Vector2D> Outline(SceneObject thing, in SceneCollider collider, double timeS)
        {
            Pose pose = thing.PoseAt(timeS);
            var points = new List<Vector2D>();
            Vector3D half = collider.Shape == ColliderShape.Box ? collider.Size * 0.5
                : collider.Shape == ColliderShape.Quad ? new Vector3D(0.5, 0.5, 0)
                : new Vector3D(collider.Radius, collider.Radius, collider.Radius);
            if (collider.Shape == ColliderShape.Capsule)
            {
                double reach = Math.Max(collider.Radius, collider.Height / 2);
                half = collider.Axis == 0 ? new Vector3D(reach, half.Y, half.Z)
                    : collider.Axis == 1 ? new Vector3D(half.X, reach, half.Z) : new Vector3D(half.X, half.Y, reach);
            }

            var corners = new Vector3D[8];
            for (int i = 0; i < 8; i++)
            {
                var corner = new Vector3D((i & 1) == 0 ? -half.X : half.X, (i & 2) == 0 ? -half.Y : half.Y, (i & 4) == 0 ? -half.Z : half.Z);
                corners[i] = _scene.Surface.InverseTransformPoint(pose.TransformPoint(Vector3D.Scale(collider.Center + corner, thing.Scale)));
            }

            for (int i = 0; i < 8; i++)
            {
                for (int bit = 1; bit < 8; bit <<= 1)
                {
                    if ((i & bit) == 0)
                        AddEdge(corners[i], corners[i | bit], points);
                }
            }

            return ConvexHull(points);
        }

        private void AddEdge(Vector3D from, Vector3D to, List<Vector2D> points)
        {
            if (from.Z < NearestM && to.Z < NearestM)
                return;
            if (from.Z < NearestM)
                from += (to - from) * ((NearestM - from.Z) / (to.Z - from.Z));
            if (to.Z < NearestM)
                to += (from - to) * ((NearestM - to.Z) / (from.Z - to.Z));
            points.Add(OnScreen(from));
            points.Add(OnScreen(to));
        }

        private Vector2D OnScreen(Vector3D surfaceM)
        {
            double t = -_eye.Z / (surfaceM.Z - _eye.Z);
            Vector3D screen = Axes.SurfaceToScreen(_eye + (surfaceM - _eye) * t, _scene.ScreenSizeM);
            return new Vector2D(screen.X, screen.Y);
        }

        /// <summary>Andrew's monotone chain.</summary>
        private static List<Vector2D> ConvexHull(List<Vector2D> points)
        {
            points.Sort((p, q) => p.X != q.X ? p.X.CompareTo(q.X) : p.Y.CompareTo(q.Y));
            var hull = new List<Vector2D>();
            for (int pass = 0; pass < 2; pass++)
            {
                int start = hull.Count;
                for (int i = 0; i < points.Count; i++)
                {
                    Vector2D point = points[pass == 0 ? i : points.Count - 1 - i];
                    while (hull.Count >= start + 2 && Vector2D.Cross(hull[hull.Count - 1] - hull[hull.Count - 2], point - hull[hull.Count - 1]) <= 0)
                        hull.RemoveAt(hull.Count - 1);
                    hull.Add(point);
                }

                if (hull.Count > start)
                    hull.RemoveAt(hull.Count - 1);
            }

            return hull;
        }
    }
}
