using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>One weapon hand at one moment. Screen space, metres.</summary>
    public struct TrueHand
    {
        public Vector3D ShoulderM;
        public Vector3D ElbowM;
        public Vector3D WristM;
        public Vector3D PalmM;

        /// <summary>Where the light leaves the weapon.</summary>
        public Vector3D MuzzleM;

        /// <summary>Unit vector along the light: muzzle → dot.</summary>
        public Vector3D LightDirection;

        /// <summary>Unit vector along the barrel as the depth camera sees it; differs from the light by the boresight error.</summary>
        public Vector3D BarrelDirection;

        /// <summary>Where the light meets (or would meet) the screen.</summary>
        public Vector2D DotM;

        /// <summary>Speed of the palm, m/s.</summary>
        public double SpeedMPerS;
    }
}
