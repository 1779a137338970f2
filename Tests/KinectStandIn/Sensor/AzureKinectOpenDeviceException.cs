// Test code, never shipped: part of a stand-in for the Azure Kinect wrapper, see Tests/KinectStandIn/README.md.
namespace Microsoft.Azure.Kinect.Sensor
{
    public class AzureKinectOpenDeviceException : AzureKinectException
    {
        public AzureKinectOpenDeviceException(string message)
            : base(message)
        {
        }
    }
}
