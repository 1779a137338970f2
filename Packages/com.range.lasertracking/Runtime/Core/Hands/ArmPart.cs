using LaserTracking.Geometry;

namespace LaserTracking.Hands
{
    /// <summary>One connected part of a grid that may be an arm: a slice of the segmenter's cell list.</summary>
    internal struct ArmPart
    {
        public int First;
        public int Count;
        public double AreaMm2;
        public double NearestMm;
        public double MiddleXMm;

        /// <summary>How far it reaches out before the body it hangs on; infinite for a part on its own.</summary>
        public double ReachMm;

        /// <summary>False where no body was seen behind it; then the next means nothing.</summary>
        public bool HasTorso;

        /// <summary>Middle of the torso behind the arm; only x and z are known, y is the arm's.</summary>
        public Vector3D TorsoMm;

        /// <summary>Where its rear end is.</summary>
        public double RootXMm;
        public Vector3D RootMm;

        /// <summary>Middle of all that is seen of it.</summary>
        public Vector3D MiddleMm;

        /// <summary>No deeper than a head.</summary>
        public bool IsShallow;

        /// <summary>0: unknown.</summary>
        public int PersonId;

        /// <summary>False where two arms hold one weapon, or too little is seen to tell where it comes from.</summary>
        public bool HasOneRoot;

        public bool HasEye;

        /// <summary>About where the eyes are: below the crown over the torso's middle.</summary>
        public Vector3D EyeMm;
    }
}
