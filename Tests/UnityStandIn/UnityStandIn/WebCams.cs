// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityEngine;

namespace UnityStandIn
{
    /// <summary>The computer's one webcam in the hands of a test.</summary>
    public static class WebCams
    {
        private static string _name;
        private static int _newInFrame = -1;

        /// <summary>Textures that play.</summary>
        public static int Playing { get; internal set; }

        internal static WebCamDevice[] Devices => _name == null ? new WebCamDevice[0] : new[] { new WebCamDevice(_name) };

        internal static Color32[] Pixels { get; private set; }

        internal static int Width { get; private set; }

        internal static int Height { get; private set; }

        public static void PlugIn(string name) => _name = name;

        public static void Unplug() => _name = null;

        /// <summary>A new picture for the next frame of the player, rows from the bottom.</summary>
        public static void Show(int width, int height, Color32[] pixels)
        {
            Width = width;
            Height = height;
            Pixels = pixels;
            _newInFrame = Time.frameCount + 1;
        }

        internal static bool IsNew(string name) => name == _name && _newInFrame == Time.frameCount;

        internal static void Reset()
        {
            _name = null;
            Pixels = null;
            Playing = 0;
            _newInFrame = -1;
        }
    }
}
