// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System.Collections.Generic;

namespace UnityEngine
{
    public sealed class MaterialPropertyBlock
    {
        private readonly Dictionary<int, Color> _colors = new Dictionary<int, Color>();

        public MaterialPropertyBlock()
        {
        }

        public bool isEmpty => _colors.Count == 0;

        public void Clear() => _colors.Clear();

        public void SetColor(int nameID, Color value) => _colors[nameID] = value;

        public Color GetColor(int nameID) => _colors.TryGetValue(nameID, out Color color) ? color : default;

        internal void CopyTo(MaterialPropertyBlock other)
        {
            other.Clear();
            foreach (KeyValuePair<int, Color> color in _colors)
                other._colors.Add(color.Key, color.Value);
        }
    }
}
