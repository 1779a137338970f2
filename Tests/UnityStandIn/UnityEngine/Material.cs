// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine
{
    public class Material : Object
    {
        public Material(Material source)
        {
            color = source == null ? Color.white : source.color;
        }

        public Color color { get; set; }
    }
}
