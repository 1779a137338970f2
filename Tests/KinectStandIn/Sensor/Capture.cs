// Test code, never shipped: part of a stand-in for the Azure Kinect wrapper, see Tests/KinectStandIn/README.md.
using System;
using KinectStandIn;

namespace Microsoft.Azure.Kinect.Sensor
{
    public class Capture : IDisposable
    {
        private readonly FakeKinect _owner;

        internal Capture(FakeKinect owner)
        {
            _owner = owner;
        }

        public Image Color { get; set; }

        public Image Depth { get; set; }

        public Image IR { get; set; }

        public void Dispose() => _owner.CaptureGivenBack();
    }
}
