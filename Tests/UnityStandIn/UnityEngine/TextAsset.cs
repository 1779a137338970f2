// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
using System.Text;

namespace UnityEngine
{
    public class TextAsset : Object
    {
        public TextAsset()
            : this("")
        {
        }

        public TextAsset(string text)
        {
            this.text = text;
        }

        public string text { get; }

        public byte[] bytes => Encoding.UTF8.GetBytes(text);

        public override string ToString() => text;
    }
}
