// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine.UIElements
{
    public struct StyleBackground
    {
        public StyleBackground(Texture2D v) => value = v;

        public Background value { get; set; }

        public static implicit operator StyleBackground(Texture2D v) => new StyleBackground(v);
    }
}
