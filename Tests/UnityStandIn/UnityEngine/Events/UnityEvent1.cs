// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine.Events
{
    public class UnityEvent<T0> : UnityEventBase
    {
        private UnityAction<T0> _calls;

        public UnityEvent()
        {
        }

        public void AddListener(UnityAction<T0> call) => _calls += call;

        public void RemoveListener(UnityAction<T0> call) => _calls -= call;

        public void Invoke(T0 arg0) => _calls?.Invoke(arg0);
    }
}
