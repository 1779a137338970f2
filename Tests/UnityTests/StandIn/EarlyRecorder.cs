using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>Runs before others; its base class's private messages must be found.</summary>
    [DefaultExecutionOrder(-5)]
    internal sealed class EarlyRecorder : Recorder
    {
    }
}
