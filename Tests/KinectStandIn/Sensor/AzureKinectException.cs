// Test code, never shipped: part of a stand-in for the Azure Kinect wrapper, see Tests/KinectStandIn/README.md.
using System;

namespace Microsoft.Azure.Kinect.Sensor
{
    public class AzureKinectException : Exception
    {
        public AzureKinectException(string message)
            : base(message)
        {
        }
    }
}
