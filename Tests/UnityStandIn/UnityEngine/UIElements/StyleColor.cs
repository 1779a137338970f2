// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine.UIElements
{
    public struct StyleColor
    {
        public StyleColor(Color v) => value = v;

        public Color value { get; set; }

        public static implicit operator StyleColor(Color v) => new StyleColor(v);
    }
}
