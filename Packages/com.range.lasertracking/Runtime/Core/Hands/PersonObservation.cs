using LaserTracking.Geometry;

namespace LaserTracking.Hands
{
    /// <summary>One person who stands before camera 1, as known from all frames so far: people stand while their hands move.</summary>
    public struct PersonObservation
    {
        /// <summary>From 1; stays with the place where somebody stands, a new number after they left.</summary>
        public int PersonId;

        /// <summary>About where the eyes are: camera 1's space, mm.</summary>
        public Vector3D EyeMm;

        /// <summary>Standard deviation of that along one axis, shape and posture included.</summary>
        public double SigmaMm;

        /// <summary>The same of its height, 0: as sideways. Which of the eyes aims and how the head is turned moves it sideways.</summary>
        public double HeightSigmaMm;
    }
}
