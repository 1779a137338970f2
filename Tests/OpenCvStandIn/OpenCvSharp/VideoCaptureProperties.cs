// Test code, never shipped: part of a stand-in for OpenCvSharp, see Tests/OpenCvStandIn/README.md.
namespace OpenCvSharp
{
    public enum VideoCaptureProperties
    {
        PosMsec = 0,
        FrameWidth = 3,
        FrameHeight = 4,
        Fps = 5,
        FourCC = 6,
        Gain = 14,
        Exposure = 15,
        AutoExposure = 21,
        AutoWB = 44,
        WBTemperature = 45,
    }
}
