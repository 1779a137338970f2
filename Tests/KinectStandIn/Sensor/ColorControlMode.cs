// Test code, never shipped: part of a stand-in for the Azure Kinect wrapper, see Tests/KinectStandIn/README.md.
namespace Microsoft.Azure.Kinect.Sensor
{
    public enum ColorControlMode
    {
        Auto = 0,
        Manual = 1,
    }
}
