using System;
using LaserTracking.Capture;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Capture.Live;
using Microsoft.Azure.Kinect.Sensor;
using UnityEngine;

namespace LaserTracking.Kinect
{
    /// <summary>
    /// Camera 1: depth, and infrared if wanted, of an Azure Kinect or Femto at 30 frames a second. Colour stays off: nothing waits for it and
    /// the bus has room for camera 0.
    /// </summary>
    [CreateAssetMenu(fileName = "Hand Camera", menuName = "Laser Tracking/Kinect Depth Source")]
    public sealed class KinectDepthSource : KinectSourceAsset
    {
        [SerializeField]
        [Tooltip("The mode camera 1 was calibrated in. NFOV unbinned: 640 x 576, up to 3.9 m; binned modes see further.")]
        private KinectDepthMode _mode = KinectDepthMode.NfovUnbinned;

        [SerializeField]
        [Tooltip("Take the infrared picture too. The hand model needs it.")]
        private bool _withInfrared = true;

        private protected override KinectCamera CreateKinect()
        {
            (int width, int height) = KinectDepthModes.SizeOf(_mode);
            var configuration = new DeviceConfiguration
            {
                ColorResolution = ColorResolution.Off,
                DepthMode = ModeOf(_mode),
                CameraFPS = FPS.FPS30,
                SynchronizedImagesOnly = false,
            };
            return new KinectCamera(SerialNumber, configuration, _withInfrared, new FrameSourceInfo(CameraName + ", depth", width, height, FramesPerSecond, null), Array.Empty<CameraSetting>());
        }

        private DepthMode ModeOf(KinectDepthMode mode)
        {
            switch (mode)
            {
                case KinectDepthMode.Nfov2x2Binned: return DepthMode.NFOV_2x2Binned;
                case KinectDepthMode.NfovUnbinned: return DepthMode.NFOV_Unbinned;
                case KinectDepthMode.Wfov2x2Binned: return DepthMode.WFOV_2x2Binned;
                default: throw new InputException("Kinect depth source " + name, "the depth mode " + mode + " gives no depth at 30 frames a second", "choose a narrow one or the wide binned one");
            }
        }
    }
}
