// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine.Events
{
    /// <summary>Listeners that are set in the Inspector are not modelled.</summary>
    public abstract class UnityEventBase
    {
        protected UnityEventBase()
        {
        }

        public int GetPersistentEventCount() => 0;
    }
}
