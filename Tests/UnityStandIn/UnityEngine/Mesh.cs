// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;

namespace UnityEngine
{
    /// <summary>Points and triangles; a triangle is seen from the side from which its corners run clockwise.</summary>
    public sealed class Mesh : Object
    {
        /// <summary>Unity's built-in quad: 1×1 in the plane z = 0, seen from negative z.</summary>
        internal static Mesh Quad { get; } = new Mesh
        {
            name = "Quad",
            vertices = new[] { new Vector3(-0.5f, -0.5f), new Vector3(0.5f, -0.5f), new Vector3(-0.5f, 0.5f), new Vector3(0.5f, 0.5f) },
            triangles = new[] { 0, 3, 1, 3, 0, 2 },
        };

        public Vector3[] vertices { get; set; } = Array.Empty<Vector3>();

        public int vertexCount => vertices.Length;

        public int[] triangles { get; set; } = Array.Empty<int>();
    }
}
