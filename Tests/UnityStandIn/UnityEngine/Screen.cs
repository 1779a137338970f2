// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityStandIn;

namespace UnityEngine
{
    public sealed class Screen
    {
        public static int width => Desk.Width;

        public static int height => Desk.Height;
    }
}
