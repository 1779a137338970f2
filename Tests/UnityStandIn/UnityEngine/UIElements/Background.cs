// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine.UIElements
{
    public struct Background
    {
        public Texture2D texture { get; set; }

        public static implicit operator Background(Texture2D v) => new Background { texture = v };
    }
}
