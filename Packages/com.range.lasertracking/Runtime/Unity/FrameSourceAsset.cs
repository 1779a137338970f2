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

        /// <summary>Microseconds to add to this source's times to bring them on camera 0's clock. Read after <see cref="CreateSource"/>.</summary>
        public virtual long ClockOffsetUs => 0;

        /// <summary>
        /// Time of this source, microseconds, at which the scene's clock stands at zero, where it knows better (a simulation); null:
        /// the time of its first frame. Read after <see cref="CreateSource"/>.
        /// </summary>
        public virtual long? SceneTimeZeroUs => null;

        /// <summary>Opens the source. The caller owns and disposes it.</summary>
        /// <exception cref="InputException">It cannot be opened; the message says what to do.</exception>
        public abstract IFrameSource CreateSource();
    }
}
