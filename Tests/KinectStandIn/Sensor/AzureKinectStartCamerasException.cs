// Test code, never shipped: part of a stand-in for the Azure Kinect wrapper, see Tests/KinectStandIn/README.md.
namespace Microsoft.Azure.Kinect.Sensor
{
    public class AzureKinectStartCamerasException : AzureKinectException
    {
        public AzureKinectStartCamerasException(string message)
            : base(message)
        {
        }
    }
}
