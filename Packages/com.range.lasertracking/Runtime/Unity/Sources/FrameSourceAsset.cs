using LaserTracking.Capture;
using LaserTracking.Geometry;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Where a <see cref="LaserRange"/> gets its frames from: drag another asset in to change from camera to recording. One asset
    /// is one device: it may carry camera 1 and its own calibration besides. All else is read after <see cref="CreateSource"/>.
    /// </summary>
    public abstract class FrameSourceAsset : ScriptableObject
    {
        /// <summary>
        /// Seconds from the light to the moment its frame can be read, about; 0 for what is not live. With it a shot is judged
        /// against what the screen showed when the light left.
        /// </summary>
        public virtual double LatencyS => 0;

        /// <summary>
        /// A device that does not wait: when frames come faster than they can be used the oldest are left out, and when it ends or
        /// cannot be opened it is tried again until it is there. Known before it is opened.
        /// </summary>
        public virtual bool IsLive => LatencyS > 0;

        /// <summary>Microseconds to add to this source's times to bring them on camera 0's clock, where it is camera 1.</summary>
        public virtual long ClockOffsetUs => 0;

        /// <summary>The same for the times of <see cref="CreateHandSource"/>.</summary>
        public virtual long HandClockOffsetUs => 0;

        /// <summary>
        /// Time of this source, microseconds, at which the scene's clock stands at zero, where it knows better (a simulation); null:
        /// the time of its first frame.
        /// </summary>
        public virtual long? SceneTimeZeroUs => null;

        /// <summary>What the source knows of its cameras itself; used when the <see cref="ScreenSurface"/> has no calibration.</summary>
        public virtual RangeCalibration? Calibration => null;

        /// <summary>
        /// The calibration that the device's maker gave it, JSON as Azure Kinect recordings carry it; null: it has none, or does not know it before its
        /// first frame. From any thread.
        /// </summary>
        public virtual byte[]? DeviceCalibration => null;

        /// <summary>The same of <see cref="CreateHandSource"/>'s.</summary>
        public virtual byte[]? HandDeviceCalibration => null;

        /// <summary>Opens the source; on the main thread. The caller owns it, reads and disposes it on a thread of its own.</summary>
        /// <param name="range">Plays it; a simulation renders the scene that this range stands in.</param>
        /// <exception cref="InputException">It cannot be opened; the message says what to do.</exception>
        public abstract IFrameSource CreateSource(LaserRange range);

        /// <summary>Camera 1 of the same device, or null: it has none. Owned by the caller too.</summary>
        /// <exception cref="InputException">It cannot be opened; the message says what to do.</exception>
        public virtual IFrameSource? CreateHandSource() => null;

        /// <summary>
        /// Called on the main thread in every Update while this source plays: for devices that can only be read there. The frame
        /// source itself is read and disposed on another thread.
        /// </summary>
        public virtual void UpdateSource()
        {
        }

        /// <summary>
        /// Called on the main thread when the source shall play no longer, just before its frame source is disposed: a read that waits
        /// for the device must come back soon.
        /// </summary>
        public virtual void ReleaseSource()
        {
        }
    }
}
