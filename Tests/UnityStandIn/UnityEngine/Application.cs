// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityStandIn;

namespace UnityEngine
{
    public class Application
    {
        public static bool isPlaying => true;

        public static bool isEditor => Desk.IsEditor;

        public static RuntimePlatform platform => RuntimePlatform.LinuxEditor;

        public static string persistentDataPath => Desk.PersistentDataPath;

        public static string streamingAssetsPath => Desk.StreamingAssetsPath;
    }
}
