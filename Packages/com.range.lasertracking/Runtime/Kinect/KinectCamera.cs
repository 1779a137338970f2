using System;
using System.Collections.Generic;
using System.Runtime.CompilerServices;
using LaserTracking.Capture;
using LaserTracking.Capture.Live;
using LaserTracking.Imaging;
using Microsoft.Azure.Kinect.Sensor;
using KinectCapture = Microsoft.Azure.Kinect.Sensor.Capture;
using KinectImage = Microsoft.Azure.Kinect.Sensor.Image;
using PictureImage = LaserTracking.Imaging.Image;

namespace LaserTracking.Kinect
{
    /// <summary>
    /// One Azure Kinect, or an Orbbec Femto behind Orbbec's libraries of the same names, by the Sensor SDK's wrapper. The wrapper makes a
    /// capture and its images anew for every frame and copies colour once; this class adds no garbage of its own.
    /// </summary>
    internal sealed class KinectCamera : ILiveCamera
    {
        // Devices are opened one after another: looking for a serial number opens others' for a moment.
        private static readonly object OpenLock = new object();

        private readonly string _serialNumber;
        private readonly DeviceConfiguration _configuration;
        private readonly bool _withInfrared;
        private Device? _device;
        private double _usedExposureUs;
        private double _usedWhiteBalanceK;
        private volatile byte[]? _rawCalibration;

        /// <param name="serialNumber">As printed on it; empty: the first that is free.</param>
        /// <param name="configuration">Colour alone or depth alone.</param>
        /// <param name="withInfrared">Copies the infrared picture beside depth.</param>
        /// <param name="info">What will come.</param>
        /// <param name="settings">To be locked; by <see cref="ColorControlCommand"/>.</param>
        public KinectCamera(string serialNumber, DeviceConfiguration configuration, bool withInfrared, FrameSourceInfo info, IReadOnlyList<CameraSetting> settings)
        {
            _serialNumber = serialNumber.Trim();
            _configuration = configuration;
            _withInfrared = withInfrared;
            Info = info;
            Settings = settings;
        }

        public FrameSourceInfo Info { get; }

        public IReadOnlyList<CameraSetting> Settings { get; }

        /// <summary>The factory calibration as JSON; null before it was open once. From any thread.</summary>
        public byte[]? RawCalibration => _rawCalibration;

        /// <summary>Calls into the native library for the first time.</summary>
        [MethodImpl(MethodImplOptions.NoInlining)]
        public static void Touch() => Device.GetInstalledCount();

        public bool TryOpen(out string problem)
        {
            lock (OpenLock)
                _device = Find(out problem);
            if (_device == null)
                return false;
            try
            {
                _device.StartCameras(_configuration);
                _rawCalibration = _device.GetRawCalibration();
                return true;
            }
            catch (AzureKinectException failure)
            {
                problem = "it does not start (" + VendorLibrary.Describe(failure) + "); plug it into a USB 3 port of its own, and see that the depth engine's library lies beside the k4a library";
                return false;
            }
        }

        public LiveReading Read(Frame frame, int timeoutMs, out string problem)
        {
            problem = "";
            try
            {
                // Disposes its images too. Undisposed captures keep megabytes until the finalizer runs.
                using KinectCapture capture = _device!.GetCapture(TimeSpan.FromMilliseconds(timeoutMs));
                return Take(capture, frame) ? LiveReading.Picture : LiveReading.Nothing;
            }
            catch (TimeoutException)
            {
                return LiveReading.Nothing;
            }
            catch (AzureKinectException failure)
            {
                problem = "lost (" + VendorLibrary.Describe(failure) + "); check its cable and power";
                return LiveReading.Lost;
            }
        }

        public bool TrySet(CameraSetting setting)
        {
            try
            {
                _device!.SetColorControl((ColorControlCommand)setting.Id, ColorControlMode.Manual, (int)setting.Asked);
                return true;
            }
            catch (AzureKinectException)
            {
                return false;
            }
        }

        public bool TryGet(CameraSetting setting, out double value)
        {
            value = 0;
            try
            {
                value = _device!.GetColorControl((ColorControlCommand)setting.Id, out ColorControlMode mode);
                return mode == ColorControlMode.Manual;
            }
            catch (AzureKinectException)
            {
                return false;
            }
        }

        public bool TryGetUsed(CameraSetting setting, out double value)
        {
            switch ((ColorControlCommand)setting.Id)
            {
                case ColorControlCommand.ExposureTimeAbsolute: value = _usedExposureUs; break;
                case ColorControlCommand.Whitebalance: value = _usedWhiteBalanceK; break;
                default: value = 0; break;
            }

            return value > 0;
        }

        public void Close()
        {
            Device? device = _device;
            _device = null;
            if (device == null)
                return;
            try
            {
                device.StopCameras();
            }
            catch (AzureKinectException)
            {
                // Gone, or never started; it must be given back all the same.
            }
            finally
            {
                device.Dispose();
            }
        }

        private Device? Find(out string problem)
        {
            string seen = "";
            int count = Device.GetInstalledCount();
            for (int i = 0; i < count; i++)
            {
                Device device;
                try
                {
                    device = Device.Open(i);
                }
                catch (AzureKinectException)
                {
                    // Another source's, or another program's.
                    seen += (seen.Length > 0 ? ", " : "") + "one in use";
                    continue;
                }

                string serial = device.SerialNum;
                if (_serialNumber.Length == 0 || serial == _serialNumber)
                {
                    problem = "";
                    return device;
                }

                seen += (seen.Length > 0 ? ", " : "") + serial;
                device.Dispose();
            }

            problem = (_serialNumber.Length == 0 ? "no Kinect is free" : "there is no Kinect with this serial number") + " (connected: " + (seen.Length > 0 ? seen : "none") + "); plug it in, or correct the serial number in its asset";
            return null;
        }

        private bool Take(KinectCapture capture, Frame frame)
        {
            bool isColor = _configuration.ColorResolution != ColorResolution.Off;
            KinectImage? first = isColor ? capture.Color : capture.Depth;
            if (first == null)
                return false;
            frame.Begin(0, TimeUs(first));
            if (isColor)
            {
                _usedExposureUs = first.Exposure.Ticks / 10.0;
                _usedWhiteBalanceK = first.WhiteBalance;
                return TryCopy(first, ImageFormat.ColorNV12, PixelFormat.Nv12, frame.Color);
            }

            if (_withInfrared && capture.IR is KinectImage infrared)
                TryCopy(infrared, ImageFormat.IR16, PixelFormat.Infrared16, frame.Infrared);
            return TryCopy(first, ImageFormat.Depth16, PixelFormat.Depth16, frame.Depth);
        }

        private static bool TryCopy(KinectImage source, ImageFormat expected, PixelFormat format, PictureImage target)
        {
            int width = source.WidthPixels, height = source.HeightPixels, stride = source.StrideBytes;
            if (source.Format != expected || PictureImage.TightSize(format, width, height) == 0 || stride < PictureImage.TightStride(format, width))
                return false;
            ReadOnlySpan<byte> bytes = source.Memory.Span;
            target.Reset(format, width, height, TimeUs(source), stride);
            if (bytes.Length < target.SizeBytes)
            {
                target.Clear();
                return false;
            }

            bytes.Slice(0, target.SizeBytes).CopyTo(target.Bytes);
            return true;
        }

        /// <summary>A time span counts tenths of a microsecond.</summary>
        private static long TimeUs(KinectImage image) => image.DeviceTimestamp.Ticks / 10;
    }
}
