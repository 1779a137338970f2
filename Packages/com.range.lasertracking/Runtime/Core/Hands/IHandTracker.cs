using LaserTracking.Capture;

namespace LaserTracking.Hands
{
    /// <summary>Finds hands and muzzles in the frames of camera 1. Stateful; one thread at a time; no allocation once warm.</summary>
    public interface IHandTracker
    {
        /// <summary>Finds the hands of this frame. A frame without a depth picture gives none.</summary>
        void Process(Frame frame, HandObservations observations);

        /// <summary>Forgets everything seen; settings stay.</summary>
        void Reset();
    }
}
