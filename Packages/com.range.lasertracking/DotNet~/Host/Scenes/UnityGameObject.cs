using System;
using System.Collections.Generic;
using LaserTracking.Geometry;

namespace LaserTracking.Host.Scenes
{
    /// <summary>A GameObject with its place in the hierarchy, its world transform and those of its components that matter.</summary>
    internal sealed class UnityGameObject
    {
        private const double Tolerance = 1e-5;

        public UnityGameObject(UnityFields fields, UnityFields transform, long transformId, UnityGameObject? parent)
        {
            Fields = fields;
            Transform = transform;
            TransformId = transformId;
            Parent = parent;
            Name = fields.Text("m_Name");
            Path = parent == null ? Name : parent.Path + "/" + Name;
            Fields.Named($"object \"{Path}\"");
            Transform.Named($"object \"{Path}\", Transform");
            Layer = fields.Integer("m_Layer");
            if (Layer is < 0 or > 31)
                throw fields.Problem($"field m_Layer is {Layer}", "layers run from 0 to 31");
            IsActive = fields.Flag("m_IsActive") && (parent == null || parent.IsActive);

            Vector3D position = transform.Vector3("m_LocalPosition"), scale = transform.Vector3("m_LocalScale");
            Rotation3D rotation = transform.Rotation("m_LocalRotation");
            if (parent == null)
            {
                Pose = new Pose(position, rotation);
                Scale = scale;
                return;
            }

            Pose = parent.Pose * new Pose(Vector3D.Scale(parent.Scale, position), rotation);
            Scale = Vector3D.Scale(Turned(parent.Scale, rotation, out bool sheared), scale);
            IsSheared = parent.IsSheared || sheared;
        }

        public UnityFields Fields { get; }

        public UnityFields Transform { get; }

        public long TransformId { get; }

        public UnityGameObject? Parent { get; }

        public string Name { get; }

        /// <summary>Names from the root, with slashes.</summary>
        public string Path { get; }

        public int Layer { get; }

        /// <summary>In the hierarchy: it and all above it.</summary>
        public bool IsActive { get; }

        /// <summary>World position and rotation at rest.</summary>
        public Pose Pose { get; }

        /// <summary>World scale along the object's own axes; means nothing when sheared.</summary>
        public Vector3D Scale { get; }

        /// <summary>A rotated child of an unevenly scaled parent: no pose and scale describe it.</summary>
        public bool IsSheared { get; }

        public List<UnityComponent> Components { get; } = new();

        /// <summary>The component of the class on this object, enabled or not; null when there is none. Refuses two.</summary>
        public UnityComponent? Component(string script)
        {
            UnityComponent? found = null;
            foreach (UnityComponent component in Components)
            {
                if (component.Script == script)
                    found = found == null ? component : throw Fields.Problem($"has two {script} components", "remove one");
            }

            return found;
        }

        /// <summary>The same when it is enabled, otherwise null.</summary>
        public UnityComponent? Enabled(string script) =>
            Component(script) is { } component && component.Fields.Flag("m_Enabled") ? component : null;

        // Rᵀ S R is the parent's scale seen along the child's axes; whatever is beside its diagonal is shear.
        private static Vector3D Turned(Vector3D scale, Rotation3D rotation, out bool sheared)
        {
            Vector3D x = Seen(scale, rotation, new Vector3D(1, 0, 0));
            Vector3D y = Seen(scale, rotation, new Vector3D(0, 1, 0));
            Vector3D z = Seen(scale, rotation, new Vector3D(0, 0, 1));
            double beside = Math.Max(Math.Max(Math.Abs(x.Y), Math.Abs(x.Z)), Math.Abs(y.Z));
            double largest = Math.Max(Math.Abs(scale.X), Math.Max(Math.Abs(scale.Y), Math.Abs(scale.Z)));
            sheared = beside > Tolerance * largest;
            return new Vector3D(x.X, y.Y, z.Z);
        }

        private static Vector3D Seen(Vector3D scale, Rotation3D rotation, Vector3D axis) =>
            rotation.Inverse * Vector3D.Scale(scale, rotation * axis);
    }
}
