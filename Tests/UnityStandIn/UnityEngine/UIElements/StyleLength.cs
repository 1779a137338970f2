// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine.UIElements
{
    public struct StyleLength
    {
        public StyleLength(Length v) => value = v;

        public Length value { get; set; }

        public static implicit operator StyleLength(Length v) => new StyleLength(v);

        public static implicit operator StyleLength(float v) => new StyleLength(new Length(v, LengthUnit.Pixel));
    }
}
