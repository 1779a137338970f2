using LaserTracking.Capture;
using LaserTracking.Capture.AzureKinect;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Plays Azure Kinect recordings (.mkv), also interrupted or damaged ones, at their own pace; read by this package itself, without
    /// any native library.
    /// </summary>
    [CreateAssetMenu(fileName = "Recording", menuName = "Laser Tracking/Recording Source")]
    public sealed class RecordingSource : FrameSourceAsset
    {
        [SerializeField]
        [Tooltip("Recording of camera 0, the one that sees the screen. A relative path begins in StreamingAssets.")]
        private string _file = "";

        [SerializeField]
        [Tooltip("Recording of camera 1, the one that sees the trainees. Empty: none.")]
        private string _handFile = "";

        [SerializeField]
        [Tooltip("Microseconds to add to camera 1's times to bring them on camera 0's clock.")]
        private long _handOffsetUs;

        private byte[]? _deviceCalibration;
        private byte[]? _handDeviceCalibration;

        public override byte[]? DeviceCalibration => _deviceCalibration;

        public override byte[]? HandDeviceCalibration => _handDeviceCalibration;

        public override long HandClockOffsetUs => _handOffsetUs;

        public override IFrameSource CreateSource(LaserRange range)
        {
            if (_file.Length == 0)
                throw new InputException("recording source " + name, "names no file", "give the path of an Azure Kinect recording");
            return Open(_file, KinectStreams.Color | KinectStreams.Infrared, "colour", out _deviceCalibration);
        }

        public override IFrameSource? CreateHandSource() =>
            _handFile.Length == 0 ? null : Open(_handFile, KinectStreams.Depth | KinectStreams.Infrared, "depth", out _handDeviceCalibration);

        private IFrameSource Open(string file, KinectStreams streams, string needed, out byte[]? deviceCalibration)
        {
            string path = UserPath.Under(Application.streamingAssetsPath, file);
            KinectRecording recording = KinectRecording.Open(path);
            deviceCalibration = recording.TryReadCalibration(out byte[] json) ? json : null;
            if ((needed == "depth" ? recording.DepthTrack : recording.ColorTrack) != null)
                return new PrefetchingFrameSource(new KinectRecordingSource(recording, streams));
            recording.Dispose();
            throw new InputException("recording source " + name, path + " holds no " + needed, "give the recording of the other camera");
        }
    }
}
