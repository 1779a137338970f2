// Test code, never shipped: part of a stand-in for the Azure Kinect wrapper, see Tests/KinectStandIn/README.md.
namespace Microsoft.Azure.Kinect.Sensor
{
    public enum ColorControlCommand
    {
        ExposureTimeAbsolute = 0,
        Whitebalance = 6,
        BacklightCompensation = 7,
        Gain = 8,
        PowerlineFrequency = 9,
    }
}
