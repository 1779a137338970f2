using System;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Imaging;

namespace LaserTracking.Capture.Recording
{
    /// <summary>What a <see cref="FrameRecorder"/> keeps of the frames and how.</summary>
    public sealed class FrameRecorderSettings
    {
        /// <summary>Pictures to record; the tracks are those of them that the first frame has.</summary>
        public KinectStreams Streams { get; set; } = KinectStreams.All;

        /// <summary>Only this part of the colour pictures, every bit of it; null: all.</summary>
        public PixelRegion? Region { get; set; }

        /// <summary>1…100: colour becomes a JPEG of this quality; 0: it stays as it comes, every bit of it.</summary>
        public int JpegQuality { get; set; }

        /// <summary>Nominal, of the camera; 0: unknown.</summary>
        public double FramesPerSecond { get; set; }

        /// <summary>The device's own calibration.json or null, asked for with the first frame, by the recorder's thread: before, a device may not know it.</summary>
        public Func<byte[]?>? DeviceCalibration { get; set; }

        /// <summary>Null: unknown.</summary>
        public string? SerialNumber { get; set; }

        /// <summary>Frames that may wait for the disk, 1…256; bounds the memory.</summary>
        public int QueueLength { get; set; } = 12;

        /// <summary>Wait for room in the queue instead of dropping the frame: for sources that can wait, never for a camera.</summary>
        public bool WaitsWhenFull { get; set; }

        /// <exception cref="ArgumentException">A value is out of its range.</exception>
        public void Validate()
        {
            if (JpegQuality < 0 || JpegQuality > 100)
                throw new ArgumentException("JPEG quality " + JpegQuality + " is not within 0…100");
            if (QueueLength < 1 || QueueLength > 256)
                throw new ArgumentException("a queue of " + QueueLength + " frames is not within 1…256");
        }
    }
}
