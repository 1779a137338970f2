// Test code, never shipped: part of a stand-in for OpenCvSharp, see Tests/OpenCvStandIn/README.md.
using OpenCvStandIn;

namespace OpenCvSharp
{
    public class VideoCapture : CvObject
    {
        private FakeWebcam _webcam;

        public bool Open(int index, VideoCaptureAPIs apiPreference = VideoCaptureAPIs.ANY)
        {
            _webcam = FakeWebcam.Open(index, apiPreference);
            return _webcam != null;
        }

        public bool IsOpened() => _webcam != null;

        public double Get(VideoCaptureProperties propertyId) => _webcam.Get(propertyId);

        public bool Grab() => _webcam.Grab();

        public bool Retrieve(Mat image, int flag = 0) => _webcam.Retrieve(image);

        public bool Set(VideoCaptureProperties propertyId, double value) => _webcam.Set(propertyId, value);

        internal override void Release() => _webcam?.Close();
    }
}
