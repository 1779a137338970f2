// Test code, never shipped: part of a stand-in for the Azure Kinect wrapper, see Tests/KinectStandIn/README.md.
namespace Microsoft.Azure.Kinect.Sensor
{
    public class DeviceConfiguration
    {
        public FPS CameraFPS { get; set; }

        public ImageFormat ColorFormat { get; set; }

        public ColorResolution ColorResolution { get; set; }

        public DepthMode DepthMode { get; set; }

        public bool SynchronizedImagesOnly { get; set; }
    }
}
