// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityStandIn;

namespace UnityEngine
{
    public class Input
    {
        public static Vector3 mousePosition => Desk.Mouse;

        public static bool GetMouseButtonDown(int button) => button == 0 && Desk.IsPressed;
    }
}
