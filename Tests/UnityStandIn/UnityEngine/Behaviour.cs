// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine
{
    public class Behaviour : Component
    {
        // The serialised name, as scene files spell it.
        private bool m_Enabled = true;

        public bool enabled
        {
            get => m_Enabled;
            set
            {
                m_Enabled = value;
                Refresh();
            }
        }

        public bool isActiveAndEnabled => !IsDestroyed && m_Enabled && gameObject.activeInHierarchy;
    }
}
