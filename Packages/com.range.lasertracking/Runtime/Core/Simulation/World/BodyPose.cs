using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>The joints from which the depth camera's solids are built. Screen space, metres.</summary>
    internal struct BodyPose
    {
        public TrueHand Weapon;
        public Vector3D HeadM;
        public Vector3D NeckM;

        /// <summary>Unit vector from the left to the right shoulder.</summary>
        public Vector3D ShoulderAxis;
        public Vector3D HipM;
        public Vector3D SupportShoulderM;
        public Vector3D SupportElbowM;
        public Vector3D SupportWristM;
        public Vector3D SupportPalmM;
    }
}
