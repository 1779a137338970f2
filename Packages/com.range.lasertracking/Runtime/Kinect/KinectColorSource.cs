using System.Collections.Generic;
using LaserTracking.Capture;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Capture.Live;
using Microsoft.Azure.Kinect.Sensor;
using UnityEngine;

namespace LaserTracking.Kinect
{
    /// <summary>
    /// Camera 0: the colour of an Azure Kinect or Femto, 1280×720 NV12 at 30 frames a second, its exposure and white balance locked and
    /// checked. Depth stays off, so it neither waits for it nor disturbs camera 1.
    /// </summary>
    [CreateAssetMenu(fileName = "Screen Camera", menuName = "Laser Tracking/Kinect Colour Source")]
    public sealed class KinectColorSource : KinectSourceAsset
    {
        [SerializeField]
        [Min(100)]
        [Tooltip("Exposure, microseconds. 8330: one period of a projector at 60 Hz. An Azure Kinect takes 500, 1250, 2500, 8330 or 16670 (60 Hz), 500, 1250, 2500, 10000 or 20000 (50 Hz); others are rounded up.")]
        private int _exposureUs = 8330;

        [SerializeField]
        [Tooltip("Which ladder of exposures the camera uses.")]
        private MainsFrequency _mains = MainsFrequency.Hz60;

        [SerializeField]
        [Range(2500, 12500)]
        [Tooltip("White balance, kelvin.")]
        private int _whiteBalanceK = 4500;

        [SerializeField]
        [Range(-1, 255)]
        [Tooltip("Gain, 0 to 255; -1 leaves it as it is.")]
        private int _gain = -1;

        private protected override KinectCamera CreateKinect()
        {
            var configuration = new DeviceConfiguration
            {
                ColorFormat = ImageFormat.ColorNV12,
                ColorResolution = ColorResolution.R720p,
                DepthMode = DepthMode.Off,
                CameraFPS = FPS.FPS30,
                SynchronizedImagesOnly = false,
            };
            return new KinectCamera(SerialNumber, configuration, false, new FrameSourceInfo(CameraName + ", colour", ColorHeight * 16 / 9, ColorHeight, FramesPerSecond, null), Settings());
        }

        /// <summary>The mains frequency first: it selects the exposures there are.</summary>
        private List<CameraSetting> Settings()
        {
            int nearest = KinectExposure.RoundUp(_exposureUs, _mains == MainsFrequency.Hz50 ? 50 : 60), whiteBalanceK = _whiteBalanceK / 10 * 10;
            var settings = new List<CameraSetting>
            {
                Setting(ColorControlCommand.PowerlineFrequency, "mains frequency (1: 50 Hz, 2: 60 Hz)", "", (int)_mains, 0, null, "update the camera's firmware"),
                Setting(ColorControlCommand.ExposureTimeAbsolute, "exposure", "µs", _exposureUs, 100, nearest, "choose an exposure that the camera has, and check with range advise what it can see"),
                Setting(ColorControlCommand.Whitebalance, "white balance", "K", whiteBalanceK, 50, null, "the colours of dots may drift; choose another value"),
                Setting(ColorControlCommand.BacklightCompensation, "backlight compensation", "", 0, 0, null, "update the camera's firmware"),
            };
            if (_gain >= 0)
                settings.Add(Setting(ColorControlCommand.Gain, "gain", "", _gain, 1, null, "choose a gain that the camera has"));
            return settings;
        }

        private static CameraSetting Setting(ColorControlCommand command, string name, string unit, double asked, double tolerance, double? nearest, string remedy) =>
            new CameraSetting((int)command, name, unit, asked, tolerance, nearest, remedy);
    }
}
