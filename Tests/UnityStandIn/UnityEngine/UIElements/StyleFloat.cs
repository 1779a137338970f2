// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine.UIElements
{
    public struct StyleFloat
    {
        public StyleFloat(float v) => value = v;

        public float value { get; set; }

        public static implicit operator StyleFloat(float v) => new StyleFloat(v);
    }
}
