using System;

namespace LaserTracking.Capture.Live
{
    /// <summary>How long a live camera is waited for. Defaults suit cameras of 15…60 frames a second.</summary>
    public sealed class LiveCameraSettings
    {
        /// <summary>Longest single wait for a picture, milliseconds: short, because the vendor's library locks the device meanwhile.</summary>
        public int ReadTimeoutMs { get; set; } = 100;

        /// <summary>Silence after which an open camera counts as lost, before its first picture: cameras start slowly.</summary>
        public int FirstPictureMs { get; set; } = 4000;

        /// <summary>Silence after which an open camera counts as lost, after its first picture.</summary>
        public int SilenceMs { get; set; } = 1000;

        /// <summary>Wait before a lost camera is looked for; doubles with every failure.</summary>
        public int FirstRetryMs { get; set; } = 500;

        /// <summary>Longest wait between two looks.</summary>
        public int LongestRetryMs { get; set; } = 8000;

        /// <summary>
        /// From the first picture to the locking of settings: cameras start in their automatic modes, and what is set before they run
        /// they take wrongly or forget.
        /// </summary>
        public int SettleMs { get; set; } = 2000;

        /// <summary>Between two checks that the settings still hold.</summary>
        public int CheckMs { get; set; } = 5000;

        /// <summary>From the light to the arrival of its picture, milliseconds, about.</summary>
        public double LatencyMs { get; set; }

        internal LiveCameraSettings Validated()
        {
            if (ReadTimeoutMs < 1 || FirstPictureMs < 1 || SilenceMs < 1 || FirstRetryMs < 1 || LongestRetryMs < FirstRetryMs || SettleMs < 0 || CheckMs < 1)
                throw new ArgumentException("times of a live camera must be positive, and the longest retry no shorter than the first");
            if (!(LatencyMs >= 0 && LatencyMs < 10_000))
                throw new ArgumentException("the latency must lie between 0 and 10,000 ms");
            return this;
        }
    }
}
