using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Scoring;
using UnityEngine;
using Pose = LaserTracking.Geometry.Pose;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Describes a live scene as the headless program knows it, with the same rules as its scene reader: what a simulated camera
    /// shows is what a shot can hit. What cannot be taken over exactly is refused. Main thread only.
    /// </summary>
    public sealed class SceneModelBuilder
    {
        private readonly List<Transform> _owners = new List<Transform>();
        private readonly Dictionary<Transform, List<SceneCollider>> _colliders = new Dictionary<Transform, List<SceneCollider>>();
        private readonly HashSet<string> _names = new HashSet<string>();

        private readonly MovedObjects? _moved;

        private SceneModelBuilder(MovedObjects? moved)
        {
            _moved = moved;
        }

        /// <summary>The scene that a range stands in, at rest: motions are functions of the scene's clock.</summary>
        /// <exception cref="InputException">It cannot be described: which object, why, what to do.</exception>
        public static SceneModel Build(LaserRange range) => Build(range, new SceneModelBuilder(null));

        /// <summary>The same where something else moves targets that have a <see cref="TargetMotion"/> of kind None: their poses are to be logged.</summary>
        /// <param name="range">See above.</param>
        /// <param name="moved">What has to be logged.</param>
        internal static SceneModel Build(LaserRange range, out MovedObjects moved) => Build(range, new SceneModelBuilder(moved = new MovedObjects()));

        private static SceneModel Build(LaserRange range, SceneModelBuilder builder)
        {
            ScreenSurface? screen = range.Screen;
            Transform? viewpoint = range.Viewpoint;
            if (screen == null || viewpoint == null)
                throw Problem(range.transform, "its LaserRange has no " + (screen == null ? "screen" : "viewpoint"), "drag one in");
            if (builder._moved != null)
                builder._moved.SetView(screen, viewpoint);
            else if (MoverOf(screen.transform) != null || MoverOf(viewpoint) != null)
                throw Problem(range.transform, "the screen or the viewpoint of its LaserRange moves", "remove TargetMotion from them and from what is above them");
            Vector3D eye = viewpoint.position.ToCore();
            if (!(screen.SizeM.X > 0 && screen.SizeM.Y > 0))
                throw Problem(screen.transform, "the screen's size is not above zero in both directions", "set it in metres");
            if (!(screen.Pose.InverseTransformPoint(eye).Z < -1e-3))
                throw Problem(viewpoint, "the viewpoint is not in front of the screen", "move it to the side of the screen's negative z axis");

            for (int i = 0; i < MovingTargets.Count; i++)
                MovingTargets.At(i).Rest();
            try
            {
                foreach (GameObject root in range.gameObject.scene.GetRootGameObjects())
                    builder.Collect(root.transform);
                SceneObject[] objects = builder._owners.ConvertAll(builder.Describe).ToArray();
                return new SceneModel(range.gameObject.scene.name, screen.Pose, screen.SizeM, eye, range.HitLayers, objects);
            }
            finally
            {
                for (int i = MovingTargets.Count - 1; i >= 0; i--)
                    MovingTargets.At(i).Restore();
            }
        }

        private void Collect(Transform carrier)
        {
            if (!carrier.gameObject.activeInHierarchy)
                return;
            LaserTarget? target = carrier.GetComponentInParent<LaserTarget>();
            Transform owner = target != null && target.enabled ? target.transform : carrier;
            if (owner == carrier && target != null && target.enabled)
                Own(owner);
            foreach (Collider component in carrier.GetComponents<Collider>())
            {
                if (!component.enabled)
                    continue;
                if (_moved == null || LoggedMoverOf(carrier) == null)
                    ExpectStill(carrier);
                SceneCollider collider = Describe(component);
                Own(owner).Add(owner == carrier ? collider : collider.OnChild(PoseIn(owner, carrier), carrier.lossyScale.ToCore(), carrier.gameObject.layer));
            }

            for (int i = 0; i < carrier.childCount; i++)
                Collect(carrier.GetChild(i));
        }

        private List<SceneCollider> Own(Transform owner)
        {
            if (!_colliders.TryGetValue(owner, out List<SceneCollider> colliders))
            {
                _colliders.Add(owner, colliders = new List<SceneCollider>());
                _owners.Add(owner);
            }

            return colliders;
        }

        private SceneObject Describe(Transform owner)
        {
            LaserTarget? target = owner.GetComponent<LaserTarget>();
            TargetDefinition? definition = null;
            if (target != null && target.enabled)
            {
                definition = target.Definition;
                if (definition == null)
                    throw Problem(owner, "its LaserTarget has no usable definition", "assign a target definition");
                if (_colliders[owner].Count == 0)
                    throw Problem(owner, "its LaserTarget has no enabled collider on its object or below, so nothing can hit it", "add one or disable the target");
                if (!_names.Add(owner.name))
                    throw Problem(owner, "a second target of that name", "give every target a name of its own");
            }

            MotionPath motion = MotionOf(owner, out Rotation3D parentRotation);
            if (_moved != null && LoggedMoverOf(owner) is TargetMotion logged)
                _moved.Add(_owners.IndexOf(owner), owner, logged);
            return new SceneObject(owner.name, owner.gameObject.layer, owner.WorldPose(), owner.lossyScale.ToCore(), parentRotation, motion, _colliders[owner].ToArray(), definition);
        }

        private static SceneCollider Describe(Collider component)
        {
            Transform carrier = component.transform;
            Vector3 scale = carrier.lossyScale;
            if (IsSheared(carrier))
                throw Problem(carrier, "has a collider and is sheared: a rotated child of an unevenly scaled parent", "give the parent the scale 1 1 1");
            if (scale.x * scale.y * scale.z == 0)
                throw Problem(carrier, "has a collider but a scale of zero", "give it a scale");
            switch (component)
            {
                case BoxCollider box when box.size.x > 0 && box.size.y > 0 && box.size.z > 0:
                    return SceneCollider.Box(box.center.ToCore(), box.size.ToCore(), box.isTrigger);
                case SphereCollider sphere when sphere.radius > 0:
                    if (!IsNear(scale.x, scale.y) || !IsNear(scale.x, scale.z))
                        throw Problem(carrier, "a sphere under an uneven scale: what is seen would not be what is hit", "scale it evenly or use a capsule or box");
                    return SceneCollider.Sphere(sphere.center.ToCore(), sphere.radius, sphere.isTrigger);
                case CapsuleCollider capsule when capsule.radius > 0 && capsule.height > 0:
                    return SceneCollider.Capsule(capsule.center.ToCore(), capsule.radius, capsule.height, capsule.direction, capsule.isTrigger);
                case MeshCollider mesh when !mesh.convex && mesh.sharedMesh != null && mesh.sharedMesh.name == "Quad" && mesh.sharedMesh.vertexCount == 4:
                    return SceneCollider.Quad();
                default:
                    throw Problem(carrier, "its collider is no box, sphere, capsule or built-in quad of a size above zero", "use one of these");
            }
        }

        private static MotionPath MotionOf(Transform owner, out Rotation3D parentRotation)
        {
            parentRotation = Rotation3D.Identity;
            TargetMotion? mover = MoverOf(owner);
            if (mover == null)
                return default;
            MotionPath path = mover.Path;
            Transform? parent = mover.transform.parent;
            if (parent == null)
                return path;
            if (IsSheared(parent))
                throw Problem(mover.transform, "moves below a sheared parent", "give the parents the scale 1 1 1");
            parentRotation = parent.rotation.ToCore();
            return new MotionPath(path.Kind, Vector3D.Scale(parent.lossyScale.ToCore(), path.TravelM), path.PeriodS, path.PhaseS);
        }

        /// <summary>What moves the object on a path: its own motion or one above it.</summary>
        private static TargetMotion? MoverOf(Transform moved)
        {
            TargetMotion? mover = null;
            for (Transform? candidate = moved; candidate != null; candidate = candidate.parent)
            {
                TargetMotion? motion = candidate.GetComponent<TargetMotion>();
                if (motion == null || !motion.isActiveAndEnabled || motion.Path.Kind == MotionKind.None)
                    continue;
                if (mover != null)
                    throw Problem(mover.transform, "moves inside \"" + candidate.name + "\", which moves too", "let only one of them move");
                mover = motion;
            }

            return mover;
        }

        /// <summary>The motion, its own or one above it, that remembers where something else moves it.</summary>
        private static TargetMotion? LoggedMoverOf(Transform moved)
        {
            for (Transform? candidate = moved; candidate != null; candidate = candidate.parent)
            {
                TargetMotion? motion = candidate.GetComponent<TargetMotion>();
                if (motion != null && motion.isActiveAndEnabled && motion.Path.Kind == MotionKind.None)
                    return motion;
            }

            return null;
        }

        private static Pose PoseIn(Transform target, Transform child)
        {
            if (MoverOf(child) != MoverOf(target))
                throw Problem(child, "has a collider of the target \"" + target.name + "\" and moves in it", "move the target as a whole");
            Pose own = target.WorldPose(), pose = child.WorldPose();
            return new Pose(own.InverseTransformPoint(pose.Position), own.Rotation.Inverse * pose.Rotation);
        }

        private static void ExpectStill(Transform carrier)
        {
            if (carrier.GetComponentInParent<Rigidbody>() != null)
                throw Problem(carrier, "has a collider that physics moves (Rigidbody)", "use TargetMotion");
            for (Transform? candidate = carrier; candidate != null; candidate = candidate.parent)
            {
                foreach (MonoBehaviour script in candidate.GetComponents<MonoBehaviour>())
                {
                    if (script != null && script.enabled && script.GetType().Assembly != typeof(LaserRange).Assembly)
                        throw Problem(candidate, "the script " + script.GetType().Name + " may move what shots can hit", "use TargetMotion or take it off this object");
                }
            }
        }

        private static bool IsSheared(Transform transform)
        {
            Vector3D x = transform.TransformVector(new Vector3(1, 0, 0)).ToCore(), y = transform.TransformVector(new Vector3(0, 1, 0)).ToCore(), z = transform.TransformVector(new Vector3(0, 0, 1)).ToCore();
            return !IsRight(x, y) || !IsRight(x, z) || !IsRight(y, z);
        }

        private static bool IsRight(Vector3D a, Vector3D b) => System.Math.Abs(Vector3D.Dot(a, b)) <= 1e-4 * a.Length * b.Length;

        private static bool IsNear(double a, double b) => System.Math.Abs(System.Math.Abs(a) - System.Math.Abs(b)) <= 1e-4 * System.Math.Abs(a);

        private static InputException Problem(Transform at, string what, string remedy)
        {
            string path = at.name;
            for (Transform? above = at.parent; above != null; above = above.parent)
                path = above.name + "/" + path;
            return new InputException("object \"" + path + "\"", what, remedy);
        }
    }
}
