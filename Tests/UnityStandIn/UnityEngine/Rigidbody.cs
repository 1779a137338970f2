// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine
{
    /// <summary>Moves nothing here; there to be asked for.</summary>
    public class Rigidbody : Component
    {
    }
}
