using LaserTracking.Capture;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>Where a <see cref="LaserRange"/> gets its frames from: drag another asset in to change from camera to recording.</summary>
    public abstract class FrameSourceAsset : ScriptableObject
    {
        /// <summary>
        /// Seconds from the light to the moment its frame can be read, about; 0 for what is not live. With it a shot is judged
        /// against what the screen showed when the light left.
        /// </summary>
        public virtual double LatencyS => 0;

        /// <summary>Opens the source. The caller owns and disposes it.</summary>
        /// <exception cref="InputException">It cannot be opened; the message says what to do.</exception>
        public abstract IFrameSource CreateSource();
    }
}
