using System.Numerics;

namespace LaserTracking.Simulation
{
    /// <summary>Linear blends whose last bit is the same on every machine: the library's own fuse multiplication and addition where they can.</summary>
    internal static class Mix
    {
        public static Vector3 Of(Vector3 from, Vector3 to, float part) => from + (to - from) * part;
    }
}
