using LaserTracking.Geometry;

namespace LaserTracking.Scoring
{
    /// <summary>One collider in its object's local space, before the object's scale, as Unity's components store it.</summary>
    public readonly struct SceneCollider
    {
        private SceneCollider(ColliderShape shape, Vector3D center, Vector3D size, double radius, double height, int axis, bool isTrigger)
            : this()
        {
            Shape = shape;
            Center = center;
            Size = size;
            Radius = radius;
            Height = height;
            Axis = axis;
            IsTrigger = isTrigger;
        }

        private SceneCollider(in SceneCollider own, Pose childPose, Vector3D childScale, int childLayer)
        {
            this = own;
            IsOnChild = true;
            ChildPose = childPose;
            ChildScale = childScale;
            ChildLayer = childLayer;
        }

        public ColliderShape Shape { get; }

        public Vector3D Center { get; }

        /// <summary>Full edge lengths of a box.</summary>
        public Vector3D Size { get; }

        public double Radius { get; }

        /// <summary>Of a capsule, over both caps.</summary>
        public double Height { get; }

        /// <summary>Of a capsule: 0 = x, 1 = y, 2 = z.</summary>
        public int Axis { get; }

        public bool IsTrigger { get; }

        /// <summary>True when it sits on a child of the object; then the child's pose, scale and layer count, not the object's.</summary>
        public bool IsOnChild { get; }

        /// <summary>The child in the object's axes and in metres: the object's scale is already in it.</summary>
        public Pose ChildPose { get; }

        /// <summary>World scale along the child's axes.</summary>
        public Vector3D ChildScale { get; }

        public int ChildLayer { get; }

        public static SceneCollider Box(Vector3D center, Vector3D size, bool isTrigger = false) =>
            new SceneCollider(ColliderShape.Box, center, size, 0, 0, 0, isTrigger);

        public static SceneCollider Sphere(Vector3D center, double radius, bool isTrigger = false) =>
            new SceneCollider(ColliderShape.Sphere, center, default, radius, 0, 0, isTrigger);

        public static SceneCollider Capsule(Vector3D center, double radius, double height, int axis, bool isTrigger = false) =>
            new SceneCollider(ColliderShape.Capsule, center, default, radius, height, axis, isTrigger);

        public static SceneCollider Quad() => new SceneCollider(ColliderShape.Quad, default, default, 0, 0, 0, false);

        /// <summary>The same collider on a child that stays where it is in the object's axes.</summary>
        public SceneCollider OnChild(Pose childPose, Vector3D childScale, int childLayer) =>
            new SceneCollider(this, childPose, childScale, childLayer);
    }
}
