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

        /// <summary>Its Game view shows any display, but lists the first alone.</summary>
        public static bool IsEditor { get; set; }

        /// <summary>The left button goes down in the frames while this is set.</summary>
        public static bool IsPressed { get; set; }

        /// <summary>Plugs in more displays than the first, which is the window's; by their widths and heights.</summary>
        public static void Plug(params int[] sizes)
        {
            var all = new int[sizes.Length + 2];
            (all[0], all[1]) = (Width, Height);
            sizes.CopyTo(all, 2);
            Display.displays = MakeDisplays(all);
        }

        internal static Display[] MakeDisplays(params int[] sizes)
        {
            var displays = new Display[sizes.Length / 2];
            for (int i = 0; i < displays.Length; i++)
                displays[i] = new Display(sizes[2 * i], sizes[2 * i + 1]) { active = i == 0 };
            return displays;
        }

        internal static void Reset()
        {
            Display.displays = MakeDisplays(1920, 1080);
            Width = 1920;
            Height = 1080;
            Mouse = default;
            IsPressed = false;
            IsEditor = false;
        }
    }
}
