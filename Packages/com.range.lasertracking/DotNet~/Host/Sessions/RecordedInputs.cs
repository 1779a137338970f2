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
        /// <exception cref="InputException">It holds no depth.</exception>
        public static IFrameSource OpenHandCamera(string path)
        {
            if (FrameSources.Detect(path) != FrameSourceKind.AzureKinectRecording)
                throw NoDepth(path);
            KinectRecording recording = KinectRecording.Open(path);
            if (recording.DepthTrack != null)
                return new KinectRecordingSource(recording, KinectStreams.Depth);
            recording.Dispose();
            throw NoDepth(path);
        }

        private static InputException NoDepth(string path) =>
            new(path, "the second camera's recording holds no depth", "give the recording of the depth camera that sees the trainees");

        private static KinectRecordingSource Open(string path, KinectStreams streams) =>
            new(KinectRecording.Open(path), streams);
    }
}
