// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System;

namespace UnityEngine
{
    public sealed class LineRenderer : Renderer
    {
        private Vector3[] _positions = new Vector3[2];

        public bool useWorldSpace { get; set; } = true;

        public float startWidth { get; set; } = 1;

        public float endWidth { get; set; } = 1;

        public Color startColor { get; set; } = Color.white;

        public Color endColor { get; set; } = Color.white;

        public int positionCount
        {
            get => _positions.Length;
            set => Array.Resize(ref _positions, value);
        }

        public void SetPosition(int index, Vector3 position) => _positions[index] = position;

        public Vector3 GetPosition(int index) => _positions[index];
    }
}
