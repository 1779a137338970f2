using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using LaserTracking.Capture;
using LaserTracking.Capture.Live;
using LaserTracking.Imaging;
using OpenCvSharp;
using Image = LaserTracking.Imaging.Image;

namespace LaserTracking.OpenCv
{
    /// <summary>
    /// A webcam through OpenCV. Pictures land in one Mat that is used again; nothing is allocated for a frame. OpenCV's waits cannot be
    /// bounded: a camera that hangs holds its thread until the driver gives up (about 10 s on Linux).
    /// </summary>
    internal sealed unsafe class WebcamCamera : ILiveCamera
    {
        private const double ManualVideoForLinux = 1;
        private const double PriorityVideoForLinux = 3;

        private readonly int _index;
        private readonly VideoCaptureAPIs _backend;
        private readonly double _fourCc;
        private readonly Func<long> _nowUs;
        private VideoCapture? _capture;
        private Mat? _picture;
        private double _lastMs;

        /// <param name="index">0-based, in the operating system's order.</param>
        /// <param name="backend">Decides the unit of the exposure.</param>
        /// <param name="fourCc">Four letters of the wire format, or empty.</param>
        /// <param name="info">Size and rate to ask for.</param>
        /// <param name="settings">To be locked; by <see cref="VideoCaptureProperties"/>, exposure in microseconds.</param>
        /// <param name="nowUs">For pictures whose driver gives no time.</param>
        public WebcamCamera(int index, VideoCaptureAPIs backend, string fourCc, FrameSourceInfo info, IReadOnlyList<CameraSetting> settings, Func<long> nowUs)
        {
            _index = index;
            _backend = backend;
            _fourCc = fourCc.Length == 4 ? fourCc[0] | fourCc[1] << 8 | fourCc[2] << 16 | fourCc[3] << 24 : 0;
            Info = info;
            Settings = settings;
            _nowUs = nowUs;
        }

        public FrameSourceInfo Info { get; }

        public IReadOnlyList<CameraSetting> Settings { get; }

        /// <summary>Calls into the native library for the first time.</summary>
        [MethodImpl(MethodImplOptions.NoInlining)]
        public static void Touch() => new Mat().Dispose();

        public bool TryOpen(out string problem)
        {
            _picture ??= new Mat();
            _capture = new VideoCapture();
            if (!_capture.Open(_index, _backend) || !_capture.IsOpened())
            {
                problem = "there is no camera number " + _index + ", or another program uses it; plug it in, or choose another number in its asset";
                return false;
            }

            // The wire format first: it decides which sizes and rates there are.
            if (_fourCc != 0)
                _capture.Set(VideoCaptureProperties.FourCC, _fourCc);
            _capture.Set(VideoCaptureProperties.FrameWidth, Info.Width);
            _capture.Set(VideoCaptureProperties.FrameHeight, Info.Height);
            _capture.Set(VideoCaptureProperties.Fps, Info.NominalFramesPerSecond);
            double width = _capture.Get(VideoCaptureProperties.FrameWidth), height = _capture.Get(VideoCaptureProperties.FrameHeight);
            bool fits = width == Info.Width && height == Info.Height;
            problem = fits ? "" : FormattableString.Invariant($"it gives pictures of {width}×{height}, not {Info.Width}×{Info.Height}; choose a size that it has, and calibrate at that size");
            return fits;
        }

        public LiveReading Read(Frame frame, int timeoutMs, out string problem)
        {
            problem = "";
            if (!_capture!.Grab() || !_capture.Retrieve(_picture!))
            {
                problem = "lost: no picture comes; check its cable";
                return LiveReading.Lost;
            }

            long timeUs = TimeUs();
            frame.Begin(0, timeUs);
            if (TryCopy(_picture!, frame.Color, timeUs))
                return LiveReading.Picture;
            problem = "its pictures are of a kind that is not known here; choose another wire format";
            return LiveReading.Nothing;
        }

        public bool TrySet(CameraSetting setting)
        {
            var property = (VideoCaptureProperties)setting.Id;
            switch (property)
            {
                case VideoCaptureProperties.Exposure when IsWindows:
                    // Setting the time by itself turns the automatic off.
                    return _capture!.Set(property, WebcamExposure.ToPowerOfTwo(setting.Asked));
                case VideoCaptureProperties.Exposure:
                    // Some drivers leave the automatic mode only when they were told to enter it.
                    _capture!.Set(VideoCaptureProperties.AutoExposure, PriorityVideoForLinux);
                    _capture.Set(VideoCaptureProperties.AutoExposure, ManualVideoForLinux);
                    return _capture.Set(property, WebcamExposure.ToTenthsOfMs(setting.Asked));
                default:
                    return _capture!.Set(property, setting.Asked);
            }
        }

        public bool TryGet(CameraSetting setting, out double value)
        {
            var property = (VideoCaptureProperties)setting.Id;
            value = _capture!.Get(property);
            switch (property)
            {
                case VideoCaptureProperties.Exposure when IsWindows:
                    // −1 is OpenCV's "not known", and half a second is nobody's exposure.
                    bool isPower = value < -1;
                    value = WebcamExposure.FromPowerOfTwo(value);
                    return isPower;
                case VideoCaptureProperties.Exposure:
                    value = WebcamExposure.FromTenthsOfMs(value);
                    return value > 0 && _capture.Get(VideoCaptureProperties.AutoExposure) == ManualVideoForLinux;
                case VideoCaptureProperties.WBTemperature:
                    return value > 0;
                default:
                    return value >= 0;
            }
        }

        public bool TryGetUsed(CameraSetting setting, out double value)
        {
            value = 0;
            return false;
        }

        public void Close()
        {
            VideoCapture? capture = _capture;
            _capture = null;
            _picture?.Dispose();
            _picture = null;
            capture?.Dispose();
        }

        private bool IsWindows => _backend == VideoCaptureAPIs.DSHOW || _backend == VideoCaptureAPIs.MSMF;

        /// <summary>The driver's time where it gives one that rises; else now.</summary>
        private long TimeUs()
        {
            double ms = _capture!.Get(VideoCaptureProperties.PosMsec), last = _lastMs;
            _lastMs = ms;
            return ms > 0 && ms > last ? (long)Math.Round(ms * 1000) : _nowUs();
        }

        private static bool TryCopy(Mat picture, Image target, long timeUs)
        {
            int width = picture.Cols, height = picture.Rows, type = picture.Type().Value;
            bool isBgr = type == MatType.CV_8UC3.Value;
            PixelFormat format = isBgr || type == MatType.CV_8UC4.Value ? PixelFormat.Bgra32
                : type == MatType.CV_8UC2.Value ? PixelFormat.Yuy2
                : type == MatType.CV_8UC1.Value ? PixelFormat.Gray8 : PixelFormat.None;
            if (Image.TightSize(format, width, height) == 0)
                return false;
            target.Reset(format, width, height, timeUs);
            byte* row = picture.DataPointer;
            for (int y = 0; y < height; y++, row += picture.Step())
            {
                byte* to = target.Pixels + (long)y * target.Stride;
                if (isBgr)
                    ColorConversion.BgrToBgra(row, to, width);
                else
                    Buffer.MemoryCopy(row, to, target.Stride, target.Stride);
            }

            return true;
        }
    }
}
