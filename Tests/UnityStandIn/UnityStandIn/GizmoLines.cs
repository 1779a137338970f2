// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System.Collections.Generic;
using UnityEngine;

namespace UnityStandIn
{
    /// <summary>The lines that gizmos have drawn since the last <see cref="PlayerLoop.Reset"/>.</summary>
    public static class GizmoLines
    {
        public static List<(Color Color, Vector3 From, Vector3 To)> Drawn { get; } = new List<(Color, Vector3, Vector3)>();
    }
}
