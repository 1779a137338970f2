using System;
using System.Threading;
using LaserTracking.Capture;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Host.Recordings;
using LaserTracking.Host.Sources;

namespace LaserTracking.Host.Sessions
{
    /// <summary>Opens what a user names as a camera's recording, with just the pictures that this camera is used for.</summary>
    internal static class RecordedInputs
    {
        /// <summary>Camera 0: colour, and infrared where there is some.</summary>
        public static IFrameSource OpenScreenCamera(string path) =>
            FrameSources.Open(path, recording => Open(recording, KinectStreams.Color | KinectStreams.Infrared));

        /// <summary>Camera 1: depth.</summary>
        public static IFrameSource OpenHandCamera(string path) =>
            FrameSources.Open(path, recording => Open(recording, KinectStreams.Depth));

        private static KinectRecordingSource Open(string path, KinectStreams streams) =>
            new(KinectRecording.Open(path), streams);
    }
}
