using System;

namespace LaserTracking.Capture.Live
{
    /// <summary>Exposure of a webcam in the units that drivers take it in.</summary>
    public static class WebcamExposure
    {
        /// <summary>Video4Linux: multiples of 100 µs.</summary>
        /// <param name="us">Microseconds, positive.</param>
        public static double ToTenthsOfMs(double us) => Math.Max(1, Math.Round(us / 100));

        /// <summary>Microseconds of a number of 100 µs steps.</summary>
        public static double FromTenthsOfMs(double steps) => steps * 100;

        /// <summary>Windows (DirectShow, Media Foundation): the whole power of two of a second that is nearest, −13…0.</summary>
        /// <param name="us">Microseconds, positive.</param>
        public static double ToPowerOfTwo(double us) => Math.Max(-13, Math.Min(0, Math.Round(Math.Log(us * 1e-6) / Math.Log(2))));

        /// <summary>Microseconds of a power of two of a second.</summary>
        public static double FromPowerOfTwo(double power) => Math.Pow(2, power) * 1e6;
    }
}
