using System;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>
    /// Manual exposure of the Azure Kinect's colour camera: a ladder of times that its mains setting selects (Sensor SDK,
    /// src/color/color_priv.h); what is asked for is rounded up to the next rung. A Femto takes any multiple of 100 µs.
    /// </summary>
    public static class KinectExposure
    {
        /// <summary>Rungs that fit in a frame at 30 a second, with mains (or a projector) of 60 Hz, microseconds.</summary>
        public static ReadOnlySpan<int> Ladder60Hz => Rungs60Hz;

        /// <summary>The same for 50 Hz.</summary>
        public static ReadOnlySpan<int> Ladder50Hz => Rungs50Hz;

        private static readonly int[] Rungs60Hz = { 500, 1250, 2500, 8330, 16670, 33330 };
        private static readonly int[] Rungs50Hz = { 500, 1250, 2500, 10000, 20000, 30000 };

        /// <summary>The exposure the camera takes when it is asked for one; the longest rung when none is as long.</summary>
        /// <param name="askedUs">Asked for, microseconds.</param>
        /// <param name="mainsHz">50 or 60.</param>
        public static int RoundUp(int askedUs, int mainsHz)
        {
            ReadOnlySpan<int> ladder = mainsHz == 50 ? Ladder50Hz : Ladder60Hz;
            foreach (int rung in ladder)
            {
                if (rung >= askedUs)
                    return rung;
            }

            return ladder[ladder.Length - 1];
        }
    }
}
