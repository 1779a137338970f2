using System.Collections.Generic;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using LaserTracking.Capture;
using LaserTracking.Capture.Live;
using LaserTracking.Unity;
using OpenCvSharp;
using UnityEngine;

namespace LaserTracking.OpenCv
{
    /// <summary>
    /// Camera 0: a webcam whose exposure, gain and white balance are locked and read back, which Unity's own WebCamTexture cannot do.
    /// </summary>
    [CreateAssetMenu(fileName = "Webcam", menuName = "Laser Tracking/OpenCV Webcam Source")]
    public sealed class WebcamSource : LiveSourceAsset
    {
        private const string Remedy = "put OpenCvSharp.dll and its native library OpenCvSharpExtern into Assets/Plugins, as Documentation~/cameras.md says";
        private const string LockItYourself = "lock it in the program of the camera's maker, or use another camera";

        [SerializeField]
        [Min(0)]
        [Tooltip("Number of the camera, from 0, in the order of the operating system.")]
        private int _index;

        [SerializeField]
        private WebcamBackend _backend = WebcamBackend.Automatic;

        [SerializeField]
        [Tooltip("Size to ask for. The camera must have it, and the screen be calibrated at it.")]
        private int _width = 1280;

        [SerializeField]
        private int _height = 720;

        [SerializeField]
        [Min(1)]
        private int _framesPerSecond = 30;

        [SerializeField]
        [Tooltip("Wire format, four letters: MJPG for high rates, YUY2 for pictures without loss. Empty: the driver's choice.")]
        private string _fourCc = "MJPG";

        [SerializeField]
        [Min(1)]
        [Tooltip("Exposure, microseconds. Windows has powers of two of a second only: 7813, 3906, 1953.")]
        private int _exposureUs = 7813;

        [SerializeField]
        [Min(-1)]
        [Tooltip("Gain, in the camera's own numbers; -1 leaves it as it is.")]
        private int _gain = -1;

        [SerializeField]
        [Min(0)]
        [Tooltip("White balance, kelvin; 0 stops the automatic where it stands.")]
        private int _whiteBalanceK = 4500;

        protected override ILiveCamera CreateCamera()
        {
            if (_width < 2 || _height < 2)
                throw new InputException("webcam source " + name, "the size " + _width + "×" + _height + " is none", "set a size that the camera has");
            if (_fourCc.Length != 0 && _fourCc.Length != 4)
                throw new InputException("webcam source " + name, "\"" + _fourCc + "\" is no wire format", "write four letters, or none");
            VendorLibrary.Check("OpenCvSharp library", Touch, Remedy);
            return CreateWebcam();
        }

        // Apart from CreateCamera, which must be compiled where the library cannot be loaded.
        [MethodImpl(MethodImplOptions.NoInlining)]
        private ILiveCamera CreateWebcam()
        {
            VideoCaptureAPIs backend = BackendOf(_backend);
            bool isWindows = backend == VideoCaptureAPIs.DSHOW || backend == VideoCaptureAPIs.MSMF;
            double nearest = isWindows ? WebcamExposure.FromPowerOfTwo(WebcamExposure.ToPowerOfTwo(_exposureUs)) : WebcamExposure.FromTenthsOfMs(WebcamExposure.ToTenthsOfMs(_exposureUs));
            var settings = new List<CameraSetting>
            {
                Setting(VideoCaptureProperties.Exposure, "exposure", "µs", _exposureUs, 0.02 * _exposureUs, nearest),
                Setting(VideoCaptureProperties.AutoWB, "automatic white balance", "", 0, 0, null),
            };
            if (_whiteBalanceK > 0)
                settings.Add(Setting(VideoCaptureProperties.WBTemperature, "white balance", "K", _whiteBalanceK, 100, null));
            if (_gain >= 0)
                settings.Add(Setting(VideoCaptureProperties.Gain, "gain", "", _gain, 1, null));
            var info = new FrameSourceInfo("webcam " + _index, _width, _height, _framesPerSecond, null);
            return new WebcamCamera(_index, backend, _fourCc, info, settings, HostClock.NowUs);
        }

        [MethodImpl(MethodImplOptions.NoInlining)]
        private static void Touch() => WebcamCamera.Touch();

        private static VideoCaptureAPIs BackendOf(WebcamBackend backend)
        {
            if (backend != WebcamBackend.Automatic)
                return (VideoCaptureAPIs)(int)backend;
            if (RuntimeInformation.IsOSPlatform(OSPlatform.Windows))
                return VideoCaptureAPIs.DSHOW;
            return RuntimeInformation.IsOSPlatform(OSPlatform.OSX) ? VideoCaptureAPIs.AVFOUNDATION : VideoCaptureAPIs.V4L2;
        }

        private static CameraSetting Setting(VideoCaptureProperties property, string name, string unit, double asked, double tolerance, double? nearest) =>
            new CameraSetting((int)property, name, unit, asked, tolerance, nearest, LockItYourself);
    }
}
