using System.Collections.Generic;

namespace LaserTracking.Capture.Live
{
    /// <summary>
    /// One camera as its vendor's library gives it, and nothing more: <see cref="LiveCameraLoop"/> looks for it again when it is gone,
    /// locks its settings and brings its times on the host's clock. All calls come from one thread. An exception from any of them counts
    /// as a lost camera.
    /// </summary>
    public interface ILiveCamera
    {
        /// <summary>What it delivers once it is open.</summary>
        FrameSourceInfo Info { get; }

        /// <summary>What is to be locked, in this order, once pictures come.</summary>
        IReadOnlyList<CameraSetting> Settings { get; }

        /// <summary>Finds and starts it. False with the reason and what to do, one line, without the camera's name.</summary>
        bool TryOpen(out string problem);

        /// <summary>Waits for the next picture and fills the frame with it; times are the device's, in microseconds.</summary>
        /// <param name="frame">Begun by the camera; its index is set by the source.</param>
        /// <param name="timeoutMs">Longest time to wait; where the vendor's call cannot be bounded, its own.</param>
        /// <param name="problem">Why there is nothing, where that is more than a timeout; else empty.</param>
        LiveReading Read(Frame frame, int timeoutMs, out string problem);

        /// <summary>Asks for the setting's value; false when the camera refuses.</summary>
        bool TrySet(CameraSetting setting);

        /// <summary>Reads back what the camera says it has; false when it does not tell.</summary>
        bool TryGet(CameraSetting setting, out double value);

        /// <summary>What the last picture says it was taken with; false when pictures do not tell.</summary>
        bool TryGetUsed(CameraSetting setting, out double value);

        /// <summary>Stops and releases it; also after a failed <see cref="TryOpen"/>. May be opened again.</summary>
        void Close();
    }
}
