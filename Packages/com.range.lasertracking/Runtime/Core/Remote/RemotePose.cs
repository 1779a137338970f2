using LaserTracking.Geometry;
using LaserTracking.Hands;

namespace LaserTracking.Remote
{
    /// <summary>Where a hand or weapon is and points to, as a remote detector saw it. What is not known is NaN.</summary>
    public struct RemotePose
    {
        public RemoteSpace Space;

        /// <summary>When it was so, microseconds on the sender's camera clock.</summary>
        public long TimeUs;

        /// <summary>When it came here, microseconds, receiver's wall clock.</summary>
        public long ReceivedTimeUs;

        /// <summary>Which of several, 0 or more; the published message knows one only.</summary>
        public int TrackId;

        public HandSide Hand;

        public Vector3D Palm;

        /// <summary>Standard deviation of the palm along one axis, metres; 0: it was not seen, or the sender does not say.</summary>
        public double PalmSigmaM;

        public Vector3D Muzzle;

        /// <summary>The laser's dot.</summary>
        public Vector3D Target;

        /// <summary>Unit vector from the muzzle to the dot.</summary>
        public Vector3D Direction;

        /// <summary>0…1.</summary>
        public double Confidence;

        /// <summary>Nothing known.</summary>
        internal static RemotePose Unknown
        {
            get
            {
                var nowhere = new Vector3D(double.NaN, double.NaN, double.NaN);
                return new RemotePose { Palm = nowhere, Muzzle = nowhere, Target = nowhere, Direction = nowhere, Confidence = 1 };
            }
        }
    }
}
