// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using UnityEngine.Rendering;

namespace UnityEngine
{
    public class Renderer : Component
    {
        private readonly MaterialPropertyBlock _properties = new MaterialPropertyBlock();

        public bool enabled { get; set; } = true;

        public bool receiveShadows { get; set; } = true;

        public ShadowCastingMode shadowCastingMode { get; set; } = ShadowCastingMode.On;

        public Material sharedMaterial { get; set; }

        public bool HasPropertyBlock() => !_properties.isEmpty;

        /// <summary>Copies; null takes away.</summary>
        public void SetPropertyBlock(MaterialPropertyBlock properties)
        {
            _properties.Clear();
            if (properties != null)
                properties.CopyTo(_properties);
        }

        public void GetPropertyBlock(MaterialPropertyBlock properties) => _properties.CopyTo(properties);
    }
}
