using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>
    /// The displays that cameras and panels draw on, numbered from 0: in a player those that are plugged in, in the editor whatever its
    /// Game view shows.
    /// </summary>
    internal static class OutputDisplay
    {
        /// <summary>Switches a display on, where it is not; that lasts as long as the player. False: it is not plugged in.</summary>
        public static bool TrySwitchOn(int display)
        {
            if (!IsOther(display))
                return display == 0 || Application.isEditor;
            if (!Display.displays[display].active)
                Display.displays[display].Activate();
            return true;
        }

        /// <summary>Pixels of what is drawn there.</summary>
        public static void GetSize(int display, out int width, out int height)
        {
            bool isOther = IsOther(display);
            width = isOther ? Display.displays[display].renderingWidth : Screen.width;
            height = isOther ? Display.displays[display].renderingHeight : Screen.height;
        }

        /// <summary>
        /// A place of the pointer on a display, from its lower left corner; false: the pointer is on another one. Unity cannot tell
        /// everywhere; it then counts as being where it is asked for.
        /// </summary>
        public static bool TryGetPlaceOn(int display, Vector3 pointer, out Vector2 placePx)
        {
            Vector3 place = Display.RelativeMouseAt(pointer);
            bool isKnown = !place.Equals(Vector3.zero);
            placePx = isKnown ? new Vector2(place.x, place.y) : new Vector2(pointer.x, pointer.y);
            return !isKnown || (int)place.z == display;
        }

        private static bool IsOther(int display) => display > 0 && display < Display.displays.Length;
    }
}
