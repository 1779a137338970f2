namespace LaserTracking.Geometry
{
    /// <summary>Where a rigid thing stands: parent = Rotation * local + Position.</summary>
    public readonly struct Pose
    {
        public readonly Vector3D Position;
        public readonly Rotation3D Rotation;

        public Pose(Vector3D position, Rotation3D rotation)
        {
            Position = position;
            Rotation = rotation;
        }

        public static Pose Identity => new Pose(default, Rotation3D.Identity);

        /// <summary>The parent's pose in the child's frame of reference.</summary>
        public Pose Inverse => new Pose(InverseTransformPoint(default), Rotation.Inverse);

        public Vector3D TransformPoint(Vector3D local) => Rotation * local + Position;

        public Vector3D InverseTransformPoint(Vector3D point) => Rotation.Inverse * (point - Position);

        public Vector3D TransformDirection(Vector3D local) => Rotation * local;

        public Vector3D InverseTransformDirection(Vector3D direction) => Rotation.Inverse * direction;

        /// <summary>parent * child: the child's pose in the parent's frame of reference.</summary>
        public static Pose operator *(Pose parent, Pose child) =>
            new Pose(parent.TransformPoint(child.Position), parent.Rotation * child.Rotation);
    }
}
