// Test code, never shipped: part of a stand-in for the Azure Kinect wrapper, see Tests/KinectStandIn/README.md.
namespace Microsoft.Azure.Kinect.Sensor
{
    public enum ImageFormat
    {
        ColorNV12 = 1,
        Depth16 = 4,
        IR16 = 5,
    }
}
