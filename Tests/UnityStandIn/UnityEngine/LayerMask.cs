// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine
{
    public struct LayerMask
    {
        // The serialised name, as scene files spell it.
        private int m_Bits;

        public int value
        {
            get => m_Bits;
            set => m_Bits = value;
        }

        public static implicit operator int(LayerMask mask) => mask.m_Bits;

        public static implicit operator LayerMask(int intVal) => new LayerMask { m_Bits = intVal };
    }
}
