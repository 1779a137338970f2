// Test code, never shipped: part of a stand-in for the Azure Kinect wrapper, see Tests/KinectStandIn/README.md.
namespace Microsoft.Azure.Kinect.Sensor
{
    public enum DepthMode
    {
        Off = 0,
        NFOV_2x2Binned = 1,
        NFOV_Unbinned = 2,
        WFOV_2x2Binned = 3,
    }
}
