// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityEngine;

namespace UnityStandIn
{
    /// <summary>What would be seen of a texture.</summary>
    public static class Projector
    {
        /// <summary>As applied last: four bytes a pixel, rows from the bottom.</summary>
        public static byte[] Shown(Texture2D texture) => texture.Shown;
    }
}
