using LaserTracking.Geometry;

namespace LaserTracking.Hands
{
    /// <summary>What one arm's cells say about hand, axis and muzzle. Camera space, mm.</summary>
    internal struct ArmFit
    {
        public Vector3D PalmMm;

        /// <summary>The middle of the hand's visible surface, moved in by half a palm's thickness: seen also where the weapon is not.</summary>
        public Vector3D SurfaceMm;

        /// <summary>That surface is seen; not of a second weapon within an arm.</summary>
        public bool HasSurface;

        /// <summary>The palm as the muzzle tells it (<see cref="GripFinder"/>), and its standard deviation along one axis; 0: not known.</summary>
        public Vector3D GripMm;
        public double GripSigmaMm;

        /// <summary>False where two arms hold one weapon, or too little is seen to tell.</summary>
        public bool HasOneRoot;

        public Vector3D MuzzleMm;
        /// <summary>The muzzle is the end of what is seen before the hand, not inferred.</summary>
        public bool HasWeapon;

        /// <summary>Along which line the weapon is seen to lie; zero where it is not seen.</summary>
        public Vector3D WeaponDirection;

        public double PalmSigmaMm;
        public double MuzzleSigmaMm;

        /// <summary>Unit vector towards the hand; zero when the arm's shape does not tell.</summary>
        public Vector3D Axis;

        public double AxisSigmaRad;

        /// <summary>Unit vector from the eyes to the muzzle; zero when no head is seen.</summary>
        public Vector3D Sight;

        /// <summary>The forearm's middle line: a point on it and its direction; direction zero when too little of it is seen.</summary>
        public Vector3D LinePointMm;

        public Vector3D LineDirection;

        /// <summary>Visible surface of the hand.</summary>
        public double HandAreaMm2;

        /// <summary>The arm ends in a hole of a hand's size: the palm comes from the hole's outline and the forearm.</summary>
        public bool IsHandLost;

        public int PersonId;

        /// <summary>Whose arm it seems by this frame alone; another than <see cref="PersonId"/> where the weapon was that one's a frame ago.</summary>
        public int SeemsId;
        public HandSide Side;

        /// <summary>Distance along z at which a ray (z = 1) passes the forearm's line most closely; false when they run alike.</summary>
        public static bool TryLineDepth(in ArmFit fit, Vector3D ray, out double zMm)
        {
            Vector3D r = ray.Normalized, d = fit.LineDirection;
            double along = Vector3D.Dot(r, d), denominator = 1 - along * along;
            zMm = 0;
            // Nearer than about 40° to the ray an error across it moves the crossing point by more than itself.
            if (d.LengthSquared == 0 || denominator < 0.4)
                return false;
            double t = (Vector3D.Dot(fit.LinePointMm, r) - along * Vector3D.Dot(fit.LinePointMm, d)) / denominator;
            zMm = t * r.Z;
            return zMm > 0;
        }
    }
}
