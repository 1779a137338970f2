// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine
{
    public enum RenderTextureFormat
    {
        ARGB32 = 0,
    }
}
