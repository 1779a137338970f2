// Test code, never shipped: part of an executable stand-in for Unity's engine, see Tests/UnityStandIn/README.md.
namespace UnityEngine
{
    public struct WebCamDevice
    {
        internal WebCamDevice(string name) => this.name = name;

        public string name { get; }
    }
}
