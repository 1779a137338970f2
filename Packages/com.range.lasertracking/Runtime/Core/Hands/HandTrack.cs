using LaserTracking.Geometry;

namespace LaserTracking.Hands
{
    /// <summary>One hand over time. Camera space, mm, mm/s.</summary>
    internal struct HandTrack
    {
        public int Id;
        public Vector3D PalmMm;
        public Vector3D VelocityMmS;

        /// <summary>Whether two measured positions have given a velocity.</summary>
        public bool HasVelocity;

        /// <summary>Time of <see cref="PalmMm"/>.</summary>
        public long TimeUs;

        public long MeasuredUs;

        /// <summary>Palm's distance minus that of the forearm's line on the palm's ray, as last measured.</summary>
        public double LineOffsetMm;

        public bool HasLineOffset;

        /// <summary>From palm to muzzle, as last measured.</summary>
        public Vector3D MuzzleOffsetMm;

        /// <summary>The hand's surface when the weapon was last seen.</summary>
        public Vector3D WeaponSurfaceMm;

        /// <summary>From that to the palm.</summary>
        public Vector3D GripOffsetMm;

        public Vector3D WeaponOffsetMm;
        public Vector3D WeaponDirection;
        public long WeaponUs;

        public Vector3D Axis;
        public double AxisSigmaRad;
        public Vector3D Sight;
        public int PersonId;

        /// <summary>Frames in which the arm seemed to be that person's, less those in which it seemed another's; limited.</summary>
        public int PersonVotes;

        /// <summary>Right above zero, left below; limited, so that a new body side wins in time.</summary>
        public int SideVotes;

        public Vector3D PredictMuzzle(long timeUs) => Predict(timeUs) + MuzzleOffsetMm;

        public Vector3D Predict(long timeUs) => PalmMm + VelocityMmS * ((timeUs - TimeUs) * 1e-6);
    }
}
