// Test code, never shipped: part of a stand-in for OpenCvSharp, see Tests/OpenCvStandIn/README.md.
namespace OpenCvSharp
{
    public abstract class CvObject : DisposableObject
    {
    }
}
