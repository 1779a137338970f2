using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Scoring;

namespace LaserTracking.Host.Scenes
{
    /// <summary>
    /// Turns what carries colliders into scene objects. As in Unity a collider belongs to the nearest LaserTarget on its object or
    /// above it; where that one is disabled, or there is none, it is scenery.
    /// </summary>
    internal sealed class SceneObjectReader
    {
        private readonly UnityHierarchy _hierarchy;
        private readonly TargetDefinitionReader _definitions;

        public SceneObjectReader(UnityHierarchy hierarchy, TargetDefinitionReader definitions)
        {
            _hierarchy = hierarchy;
            _definitions = definitions;
        }

        /// <summary>Active objects with enabled colliders, in hierarchy order.</summary>
        public SceneObject[] ReadAll()
        {
            var owners = new List<UnityGameObject>();
            var colliders = new Dictionary<UnityGameObject, List<SceneCollider>>();
            foreach (UnityGameObject carrier in _hierarchy.Objects)
            {
                if (!carrier.IsActive)
                    continue;
                UnityGameObject owner = TargetOf(carrier) ?? carrier;
                if (owner.Enabled(ProductScripts.LaserTarget) != null && !colliders.ContainsKey(owner))
                    Own(owner);
                foreach (UnityComponent component in carrier.Components)
                {
                    if (!UnityClass.IsCollider(component.ClassId) || !ColliderReader.TryRead(component, carrier, out SceneCollider collider))
                        continue;
                    ExpectNoOwnScripts(carrier);
                    if (!colliders.ContainsKey(owner))
                        Own(owner);
                    colliders[owner].Add(owner == carrier ? collider : collider.OnChild(PoseIn(owner, carrier), carrier.Scale, carrier.Layer));
                }
            }

            var names = new HashSet<string>(StringComparer.Ordinal);
            return owners.ConvertAll(owner => Read(owner, colliders[owner].ToArray(), names)).ToArray();

            void Own(UnityGameObject owner)
            {
                owners.Add(owner);
                colliders.Add(owner, new List<SceneCollider>());
            }
        }

        /// <summary>The object whose enabled TargetMotion moves this one: itself or one above it. Refuses two above each other.</summary>
        public static UnityGameObject? MoverOf(UnityGameObject moved)
        {
            UnityGameObject? mover = null;
            for (UnityGameObject? candidate = moved; candidate != null; candidate = candidate.Parent)
            {
                UnityFields? motion = candidate.Enabled(ProductScripts.TargetMotion)?.Fields;
                if (motion == null || motion.Choice<MotionKind>("_kind") == MotionKind.None)
                    continue;
                if (mover != null)
                    throw mover.Fields.Problem($"moves inside \"{candidate.Path}\", which moves too", "let only one of them move");
                mover = candidate;
            }

            return mover;
        }

        private SceneObject Read(UnityGameObject owner, SceneCollider[] colliders, HashSet<string> names)
        {
            UnityFields? target = owner.Enabled(ProductScripts.LaserTarget)?.Fields;
            if (target != null && colliders.Length == 0)
                throw target.Problem("has no enabled collider on its object or below, so nothing can hit it", "add one or disable the target");
            if (target != null && !names.Add(owner.Name))
                throw owner.Fields.Problem("a second target of that name", "give every target a name of its own");
            MotionPath motion = ReadMotion(owner, out Rotation3D parentRotation);
            TargetDefinition? definition = target == null ? null : _definitions.Read(target, "_definition");
            return new SceneObject(owner.Name, owner.Layer, owner.Pose, owner.Scale, parentRotation, motion, colliders, definition);
        }

        private static UnityGameObject? TargetOf(UnityGameObject carrier)
        {
            for (UnityGameObject? candidate = carrier; candidate != null; candidate = candidate.Parent)
            {
                UnityComponent? target = candidate.Component(ProductScripts.LaserTarget);
                if (target != null)
                    return target.Fields.Flag("m_Enabled") ? candidate : null;
            }

            return null;
        }

        private static Pose PoseIn(UnityGameObject target, UnityGameObject child)
        {
            if (MoverOf(child) != MoverOf(target))
                throw child.Fields.Problem($"has a collider of the target \"{target.Path}\" and moves in it", "move the target as a whole");
            Rotation3D back = target.Pose.Rotation.Inverse;
            return new Pose(back * (child.Pose.Position - target.Pose.Position), back * child.Pose.Rotation);
        }

        /// <summary>The motion of the object or of what carries it, in metres of the world along the axes of the mover's parent.</summary>
        private static MotionPath ReadMotion(UnityGameObject owner, out Rotation3D parentRotation)
        {
            parentRotation = Rotation3D.Identity;
            UnityGameObject? mover = MoverOf(owner);
            if (mover == null)
                return default;
            UnityFields fields = mover.Enabled(ProductScripts.TargetMotion)!.Fields;
            Vector3D travel = fields.Vector3("_travelM");
            if (mover.Parent != null)
            {
                if (mover.Parent.IsSheared)
                    throw fields.Problem("moves below a sheared parent", "give the parents the scale 1 1 1");
                parentRotation = mover.Parent.Pose.Rotation;
                travel = Vector3D.Scale(mover.Parent.Scale, travel);
            }

            double period = fields.Number("_periodS");
            if (!(period > 0))
                throw fields.Problem("field _periodS is not above zero");
            return new MotionPath(fields.Choice<MotionKind>("_kind"), travel, period, fields.Number("_phaseS"));
        }

        private static void ExpectNoOwnScripts(UnityGameObject carrier)
        {
            for (UnityGameObject? candidate = carrier; candidate != null; candidate = candidate.Parent)
            {
                foreach (UnityComponent component in candidate.Components)
                {
                    if (component.Script.EndsWith(".cs", StringComparison.Ordinal) && component.Fields.Flag("m_Enabled"))
                        throw component.Fields.Problem($"the script {component.Script} may move what shots can hit, and is not run headlessly", "use TargetMotion or take it off this object");
                }
            }
        }
    }
}
