// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityStandIn;

namespace UnityEngine
{
    /// <summary>Displays stand side by side, the first at the left; as in a player, where all that are plugged in are listed and only the first is on.</summary>
    public class Display
    {
        internal Display(int width, int height)
        {
            renderingWidth = width;
            renderingHeight = height;
        }

        public static Display[] displays = Desk.MakeDisplays(1920, 1080);

        public bool active { get; internal set; }

        public int renderingWidth { get; }

        public int renderingHeight { get; }

        public void Activate() => active = true;

        /// <summary>With its number as z; zero where there is one display only: the manual says so of platforms without several.</summary>
        public static Vector3 RelativeMouseAt(Vector3 inputMouseCoordinates)
        {
            float left = 0;
            for (int i = 0; i < displays.Length && displays.Length > 1; i++)
            {
                if (inputMouseCoordinates.x < left + displays[i].renderingWidth)
                    return new Vector3(inputMouseCoordinates.x - left, inputMouseCoordinates.y, i);
                left += displays[i].renderingWidth;
            }

            return Vector3.zero;
        }
    }
}
