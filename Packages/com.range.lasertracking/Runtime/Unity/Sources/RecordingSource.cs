using System.IO;
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

        public override long HandClockOffsetUs => _handOffsetUs;

        public override IFrameSource CreateSource(LaserRange range)
        {
            if (_file.Length == 0)
                throw new InputException("recording source " + name, "names no file", "give the path of an Azure Kinect recording");
            return Open(_file, KinectStreams.Color | KinectStreams.Infrared, "colour");
        }

        public override IFrameSource? CreateHandSource() =>
            _handFile.Length == 0 ? null : Open(_handFile, KinectStreams.Depth | KinectStreams.Infrared, "depth");

        private IFrameSource Open(string file, KinectStreams streams, string needed)
        {
            string path = Path.Combine(Application.streamingAssetsPath, file);
            KinectRecording recording = KinectRecording.Open(path);
            if ((needed == "depth" ? recording.DepthTrack : recording.ColorTrack) != null)
                return new PrefetchingFrameSource(new KinectRecordingSource(recording, streams));
            recording.Dispose();
            throw new InputException("recording source " + name, path + " holds no " + needed, "give the recording of the other camera");
        }
    }
}
