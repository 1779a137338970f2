// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine
{
    public class Renderer : Component
    {
        public bool enabled { get; set; } = true;

        public Material sharedMaterial { get; set; }
    }
}
