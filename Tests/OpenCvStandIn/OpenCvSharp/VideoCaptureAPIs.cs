// Test code, never shipped: part of a stand-in for OpenCvSharp, see Tests/OpenCvStandIn/README.md.
namespace OpenCvSharp
{
    public enum VideoCaptureAPIs
    {
        ANY = 0,
        V4L2 = 200,
        DSHOW = 700,
        AVFOUNDATION = 1200,
        MSMF = 1400,
    }
}
