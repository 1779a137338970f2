// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine
{
    public class Texture : Object
    {
        protected Texture()
        {
        }

        public virtual int width
        {
            get => Width;
            set => Width = value;
        }

        public virtual int height
        {
            get => Height;
            set => Height = value;
        }

        internal virtual int Width { get; set; }

        internal virtual int Height { get; set; }

        public FilterMode filterMode { get; set; } = FilterMode.Bilinear;

        public TextureWrapMode wrapMode { get; set; }
    }
}
