// Test code, never shipped: part of a stand-in for the Azure Kinect wrapper, see Tests/KinectStandIn/README.md.
using System;

namespace Microsoft.Azure.Kinect.Sensor
{
    public class Image : IDisposable
    {
        private readonly byte[] _bytes;

        internal Image(ImageFormat format, int width, int height, int stride, byte[] bytes)
        {
            Format = format;
            WidthPixels = width;
            HeightPixels = height;
            StrideBytes = stride;
            _bytes = bytes;
        }

        public TimeSpan DeviceTimestamp { get; set; }

        public TimeSpan Exposure { get; set; }

        public ImageFormat Format { get; }

        public int HeightPixels { get; }

        public Memory<byte> Memory => _bytes;

        public int StrideBytes { get; }

        public int WhiteBalance { get; set; }

        public int WidthPixels { get; }

        public void Dispose()
        {
        }
    }
}
