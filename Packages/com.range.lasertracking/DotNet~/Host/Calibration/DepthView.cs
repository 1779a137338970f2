using System;
using System.Runtime.InteropServices;
using LaserTracking.Capture;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Geometry;
using LaserTracking.Host.Sources;
using LaserTracking.Imaging;
using LaserTracking.Simulation;

namespace LaserTracking.Host.Calibration
{
    /// <summary>Depth pictures with the two cameras that took them and the colour pictures: recorded, or simulated from a scenario.</summary>
    internal sealed class DepthView : IDisposable
    {
        private readonly string _name;
        private readonly KinectRecording? _recording;
        private readonly IFrameSource? _simulated;
        private readonly LensCamera _depthCamera;
        private readonly Pose _depthToColorMm;

        private DepthView(string name, KinectRecording? recording, IFrameSource? simulated, LensCamera depthCamera, Pose depthToColorMm, LensCamera color)
        {
            _name = name;
            _recording = recording;
            _simulated = simulated;
            _depthCamera = depthCamera;
            _depthToColorMm = depthToColorMm;
            Color = color;
        }

        /// <summary>With its true focal length, for pictures of the size that was asked for.</summary>
        public LensCamera Color { get; }

        /// <exception cref="InputException">It cannot be read, or has no depth or no calibration.</exception>
        public static DepthView Open(string name, int colorWidth, int colorHeight)
        {
            if (name.EndsWith(".json", StringComparison.OrdinalIgnoreCase))
                return Simulated(name, colorWidth, colorHeight);
            KinectRecording recording = KinectRecording.Open(name);
            try
            {
                if (recording.DepthTrack == null)
                    throw new InputException(name, "it holds no depth", "give a recording made with depth on");
                if (!recording.TryReadCalibration(out byte[] json))
                    throw new InputException(name, "it holds no device calibration", "give a recording made with a device");
                if (!KinectCalibration.TryRead(json, recording.Configuration.DepthMode, colorWidth, colorHeight, out KinectCalibration? kinect, out string reason))
                    throw new InputException(name, reason, "give another recording");
                return new DepthView(name, recording, null, kinect!.Infrared, kinect.InfraredToColorMm, kinect.Color);
            }
            catch
            {
                recording.Dispose();
                throw;
            }
        }

        /// <summary>The screen's plane in the first depth picture that gives one, in the colour camera's space.</summary>
        /// <exception cref="InputException">None does; the message says why the last one does not.</exception>
        public PlaneFit Measure(ScreenGeometry screen)
        {
            string reason = "it holds no depth picture that can be read";
            var depth = new ushort[_depthCamera.Pinhole.Width * _depthCamera.Pinhole.Height];
            var capture = new KinectCapture();
            using var frame = new Frame();
            while (_recording != null ? _recording.TryReadNext(capture) : _simulated!.TryRead(frame))
            {
                if (!(_recording != null ? TryRecorded(capture, depth) : TrySimulated(frame.Depth, depth)))
                    continue;
                if (DepthScreenPlane.TryMeasure(_depthCamera, _depthToColorMm, Color, depth, screen, out PlaneFit? fit, out reason))
                    return fit!;
            }

            throw new InputException(_name, reason, "record the screen from where the camera stands, with nobody before it");
        }

        public void Dispose()
        {
            _recording?.Dispose();
            _simulated?.Dispose();
        }

        private static DepthView Simulated(string name, int colorWidth, int colorHeight)
        {
            SimulatedRange range = CameraInput.Simulate(name);
            if (range.DepthToColorMm is not Pose pose || range.Calibration.HandCamera is not HandCamera depth)
                throw new InputException(name, "its camera 1 is off: there is no depth", "enable depth_camera");
            PinholeCamera color = range.ColorCamera.Pinhole;
            if (color.Width != colorWidth || color.Height != colorHeight)
                throw new InputException(name, FormattableString.Invariant($"its camera 0 takes {color.Width}x{color.Height}, the calibration is for {colorWidth}x{colorHeight}"), "calibrate with the same scenario");
            return new DepthView(name, null, range.CreateDepthSource(), new LensCamera(depth.Intrinsics, BrownDistortion.None), pose, range.ColorCamera);
        }

        private bool TryRecorded(KinectCapture capture, ushort[] depth) =>
            capture.Depth.IsPresent && capture.Depth.SizeBytes == 2 * depth.Length && _recording!.TryReadPayload(capture.Depth, MemoryMarshal.AsBytes(depth.AsSpan()));

        private static unsafe bool TrySimulated(Image image, ushort[] depth)
        {
            for (int y = 0; y < image.Height; y++)
                new ReadOnlySpan<ushort>(image.Pixels + (long)y * image.Stride, image.Width).CopyTo(depth.AsSpan(y * image.Width, image.Width));
            return true;
        }
    }
}
