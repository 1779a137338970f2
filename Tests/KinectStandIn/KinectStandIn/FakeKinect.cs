// Test code, never shipped: part of a stand-in for the Azure Kinect wrapper, see Tests/KinectStandIn/README.md.
using System;
using System.Collections.Generic;
using System.Linq;
using System.Threading;
using Microsoft.Azure.Kinect.Sensor;

namespace KinectStandIn
{
    /// <summary>
    /// A camera in the hands of tests: what it shows, and how it fails. Pictures come every <see cref="IntervalMs"/>, their bytes are their
    /// number; the device's clock counts from zero whenever the cameras start.
    /// </summary>
    public sealed class FakeKinect
    {
        private static readonly List<FakeKinect> All = new List<FakeKinect>();

        private readonly Dictionary<ColorControlCommand, int> _values = new Dictionary<ColorControlCommand, int>();
        private DeviceConfiguration _configuration;
        private Capture _capture;
        private int _inFlight;
        private int _pictures;

        public FakeKinect(string serialNumber)
        {
            SerialNumber = serialNumber;
            lock (All)
                All.Add(this);
        }

        /// <summary>Thrown by the first call into the library, as when its native part is missing.</summary>
        public static Exception LibraryProblem { get; set; }

        public string SerialNumber { get; }

        public byte[] RawCalibration { get; set; } = new byte[0];

        public bool IsConnected { get; set; } = true;

        public int IntervalMs { get; set; } = 5;

        /// <summary>No picture comes, but no error either.</summary>
        public bool IsSilent { get; set; }

        /// <summary>What the exposure becomes, whatever it is set to; 0: what it is set to.</summary>
        public int StubbornExposureUs { get; set; }

        /// <summary>Set to let a call of GetCapture wait far beyond its timeout, until it is set again.</summary>
        public ManualResetEventSlim Hang { get; set; }

        public bool IsOpen { get; private set; }

        public bool IsStarted { get; private set; }

        public int Starts { get; private set; }

        public DeviceConfiguration Configuration => _configuration;

        /// <summary>Captures handed out and not disposed.</summary>
        public int CapturesOut => _inFlight;

        public IReadOnlyDictionary<ColorControlCommand, int> Values => _values;

        /// <summary>No cameras, and a library that is there.</summary>
        public static void Reset()
        {
            lock (All)
                All.Clear();
            LibraryProblem = null;
        }

        internal static int CountConnected()
        {
            if (LibraryProblem != null)
                throw LibraryProblem;
            lock (All)
                return All.Count(kinect => kinect.IsConnected);
        }

        internal static FakeKinect Open(int index)
        {
            lock (All)
            {
                FakeKinect kinect = All.Where(candidate => candidate.IsConnected).ElementAt(index);
                if (kinect.IsOpen)
                    throw new AzureKinectOpenDeviceException("k4a_device_open() failed");
                kinect.IsOpen = true;
                return kinect;
            }
        }

        internal void Start(DeviceConfiguration configuration)
        {
            if (!IsConnected)
                throw new AzureKinectStartCamerasException("k4a_device_start_cameras() failed");
            _configuration = configuration;
            _capture = MakeCapture(configuration);
            _pictures = 0;
            _values.Clear();
            IsStarted = true;
            Starts++;
        }

        internal void Stop() => IsStarted = false;

        internal void Close() => IsOpen = IsStarted = false;

        internal void Set(ColorControlCommand command, ColorControlMode mode, int value)
        {
            if (!IsConnected)
                throw new AzureKinectException("k4a_device_set_color_control() failed");
            _values[command] = command == ColorControlCommand.ExposureTimeAbsolute && StubbornExposureUs > 0 ? StubbornExposureUs : value;
        }

        internal int Get(ColorControlCommand command, out ColorControlMode mode)
        {
            if (!IsConnected)
                throw new AzureKinectException("k4a_device_get_color_control() failed");
            bool isSet = _values.TryGetValue(command, out int value);
            mode = isSet ? ColorControlMode.Manual : ColorControlMode.Auto;
            return value;
        }

        internal Capture Wait(TimeSpan timeout)
        {
            Hang?.Wait();
            if (!IsConnected || !IsStarted)
                throw new AzureKinectException("k4a_device_get_capture() failed");
            if (IsSilent)
            {
                Thread.Sleep(timeout);
                throw new TimeoutException();
            }

            if (IntervalMs > 0)
                Thread.Sleep(IntervalMs);
            return Fill(_capture);
        }

        internal void CaptureGivenBack() => _inFlight--;

        // One capture for all, so that what the sources allocate can be told from what the wrapper would.
        private static Image MakeImage(ImageFormat format, int width, int height, int stride, int rows) =>
            new Image(format, width, height, stride, new byte[stride * rows]);

        private Capture MakeCapture(DeviceConfiguration configuration)
        {
            var capture = new Capture(this);
            if (configuration.ColorResolution == ColorResolution.R720p)
                capture.Color = MakeImage(configuration.ColorFormat, 1280, 720, 1280, 1080);
            if (configuration.DepthMode == DepthMode.NFOV_Unbinned)
            {
                capture.Depth = MakeImage(ImageFormat.Depth16, 640, 576, 1280, 576);
                capture.IR = MakeImage(ImageFormat.IR16, 640, 576, 1280, 576);
            }

            return capture;
        }

        private Capture Fill(Capture capture)
        {
            _pictures++;
            _inFlight++;
            _values.TryGetValue(ColorControlCommand.ExposureTimeAbsolute, out int exposureUs);
            _values.TryGetValue(ColorControlCommand.Whitebalance, out int whiteBalanceK);
            Fill(capture.Color, exposureUs, whiteBalanceK);
            Fill(capture.Depth, 0, 0);
            Fill(capture.IR, 0, 0);
            return capture;
        }

        private void Fill(Image image, int exposureUs, int whiteBalanceK)
        {
            if (image == null)
                return;
            image.Memory.Span.Fill((byte)_pictures);
            image.DeviceTimestamp = TimeSpan.FromTicks(_pictures * 333_333L);
            image.Exposure = TimeSpan.FromTicks(exposureUs * 10L);
            image.WhiteBalance = whiteBalanceK;
        }
    }
}
