// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine
{
    public class Time
    {
        public static float time => (float)timeAsDouble;

        public static double timeAsDouble { get; internal set; }

        public static float deltaTime { get; internal set; }

        public static float fixedDeltaTime { get; set; } = 0.02f;

        public static double fixedTimeAsDouble { get; internal set; }

        public static int frameCount { get; internal set; }
    }
}
