using System;
using LaserTracking.Capture;
using LaserTracking.Capture.Live;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>
    /// A camera that is plugged in, or will be: it is looked for until it is there. Times of all such sources are on the host's clock, so
    /// that two cameras go together without more.
    /// </summary>
    public abstract class LiveSourceAsset : FrameSourceAsset
    {
        [SerializeField]
        [Min(0)]
        [Tooltip("From the light to the arrival of its picture, milliseconds, about. Moving targets are judged by it.")]
        private float _latencyMs = 60;

        [SerializeField]
        [Tooltip("Added to this camera's times where it is camera 1, milliseconds: what its latency above is wrong by against camera 0's.")]
        private float _clockOffsetMs;

        public override double LatencyS => _latencyMs * 0.001;

        public override long ClockOffsetUs => (long)Math.Round(_clockOffsetMs * 1000.0);

        public override bool IsLive => true;

        public override IFrameSource CreateSource(LaserRange range) => CreateSource(HostClock.NowUs);

        /// <summary>The camera, not yet open. Whether it is there shows later, as health.</summary>
        /// <exception cref="InputException">Its vendor's library is missing, or the asset's settings contradict each other.</exception>
        protected abstract ILiveCamera CreateCamera();

        internal LiveCameraSource CreateSource(Func<long> nowUs) => new LiveCameraSource(CreateCamera(), nowUs, new LiveCameraSettings { LatencyMs = _latencyMs });
    }
}
