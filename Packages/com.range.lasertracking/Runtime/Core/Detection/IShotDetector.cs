using LaserTracking.Capture;
using LaserTracking.Geometry;

namespace LaserTracking.Detection
{
    /// <summary>
    /// Finds laser light in the frames of camera 0, one after the other. Stateful (background, noise); one thread at a time; no
    /// allocation once warm. A frame whose size or format differs from the last one starts the detector afresh.
    /// </summary>
    public interface IShotDetector
    {
        /// <summary>As on the command line: "shots", "paper", "dual".</summary>
        string Name { get; }

        /// <summary>Finds the dots of this frame. A frame without the needed picture gives no dots and leaves the state alone.</summary>
        void Process(Frame frame, Detections detections);

        /// <summary>
        /// Restricts the search to a convex polygon in image pixels (the projected screen), or to nothing for an empty one: the whole
        /// picture. Takes effect with the next frame.
        /// </summary>
        void SetScreenPolygon(Vector2D[] cornersPx);

        /// <summary>Forgets everything seen; settings stay.</summary>
        void Reset();
    }
}
