// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine
{
    /// <summary>Draws nothing; remembers its lines.</summary>
    public sealed class Gizmos
    {
        public static Color color { get; set; }

        public static void DrawLine(Vector3 from, Vector3 to)
        {
            UnityStandIn.GizmoLines.Drawn.Add((color, from, to));
        }
    }
}
