using System.Runtime.CompilerServices;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Capture.Live;
using LaserTracking.Unity;
using UnityEngine;

namespace LaserTracking.Kinect
{
    /// <summary>What both uses of an Azure Kinect share: which one it is, and the calibration that its maker gave it.</summary>
    public abstract class KinectSourceAsset : LiveSourceAsset
    {
        /// <summary>Both cameras run at it.</summary>
        protected const int FramesPerSecond = 30;

        /// <summary>Height of the colour pictures; their width is 16/9 of it.</summary>
        protected const int ColorHeight = 720;

        private const string Remedy = "put the Azure Kinect Sensor SDK's native libraries (or Orbbec's of the same names) into Assets/Plugins, as Documentation~/cameras.md says";

        [SerializeField]
        [Tooltip("Serial number, as printed on the camera. Empty: the first that is free; with two cameras give both.")]
        private string _serialNumber = "";

        private KinectCamera? _camera;

        protected string SerialNumber => _serialNumber;

        /// <summary>For people.</summary>
        protected string CameraName => "Kinect" + (_serialNumber.Length > 0 ? " " + _serialNumber : "");

        /// <summary>The device's factory calibration, JSON, as recordings carry it; null until the camera ran once in this session.</summary>
        public override byte[]? DeviceCalibration => _camera?.RawCalibration;

        /// <summary>Reads the factory calibration for 1280×720 colour and a depth mode's pictures.</summary>
        /// <param name="depthMode">Of the infrared and depth pictures.</param>
        /// <param name="calibration">Valid only when true is returned.</param>
        /// <param name="reason">Why there is none, one line.</param>
        public bool TryReadCalibration(KinectDepthMode depthMode, out KinectCalibration? calibration, out string reason)
        {
            byte[]? raw = DeviceCalibration;
            if (raw != null)
                return KinectCalibration.TryRead(raw, depthMode, ColorHeight * 16 / 9, ColorHeight, out calibration, out reason);
            calibration = null;
            reason = CameraName + " has not run yet";
            return false;
        }

        protected sealed override ILiveCamera CreateCamera()
        {
            VendorLibrary.Check("Azure Kinect library", Touch, Remedy);
            _camera = CreateKinect();
            return _camera;
        }

        private protected abstract KinectCamera CreateKinect();

        [MethodImpl(MethodImplOptions.NoInlining)]
        private static void Touch() => KinectCamera.Touch();
    }
}
