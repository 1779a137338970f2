using System;
using System.Globalization;

namespace LaserTracking.Detection
{
    /// <summary>Refuses settings outside their documented range, NaN included; the message names setting, value and range.</summary>
    internal static class SettingCheck
    {
        /// <exception cref="ArgumentException">The value is not in minimum…maximum.</exception>
        public static void InRange(string name, double value, double minimum, double maximum)
        {
            if (!(value >= minimum && value <= maximum))
            {
                throw new ArgumentException(string.Format(
                    CultureInfo.InvariantCulture, "{0} is {1}; it must lie in {2}…{3}", name, value, minimum, maximum));
            }
        }
    }
}
