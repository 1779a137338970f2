// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityEngine;

namespace UnityStandIn
{
    /// <summary>What stands around the player in the hands of a test: the mouse, the window, the folders.</summary>
    public static class Desk
    {
        public static string PersistentDataPath { get; set; } = "";

        public static string StreamingAssetsPath { get; set; } = "";

        /// <summary>The window's width and height in pixels.</summary>
        public static int Width { get; set; } = 1920;

        public static int Height { get; set; } = 1080;

        /// <summary>Pixels from the window's lower left corner.</summary>
        public static Vector3 Mouse { get; set; }

        /// <summary>The left button goes down in the frames while this is set.</summary>
        public static bool IsPressed { get; set; }

        internal static void Reset()
        {
            Width = 1920;
            Height = 1080;
            Mouse = default;
            IsPressed = false;
        }
    }
}
