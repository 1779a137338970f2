// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine.Events
{
    public class UnityEvent : UnityEventBase
    {
        private UnityAction _calls;

        public UnityEvent()
        {
        }

        public void AddListener(UnityAction call) => _calls += call;

        public void RemoveListener(UnityAction call) => _calls -= call;

        public void Invoke() => _calls?.Invoke();
    }
}
