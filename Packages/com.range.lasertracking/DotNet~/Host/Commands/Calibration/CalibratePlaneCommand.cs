using System;
using System.CommandLine;
using System.Linq;
using System.Runtime.InteropServices;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Geometry;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Commands
{
    /// <summary>range calibrate plane: where the screen stands before the camera, by its size and by depth, and how the two agree.</summary>
    internal static class CalibratePlaneCommand
    {
        public static Command Create()
        {
            var file = new Argument<string>("CALIBRATION") { Description = "What 'calibrate screen' wrote." };
            var recording = new Option<string?>("--depth") { HelpName = "RECORDING", Description = "A recording (.mkv) of the same camera in the same place, with depth." };
            var camera = new Option<string?>("--camera") { HelpName = "FILE", Description = "The camera with its lens, when the calibration does not hold it; else the recording's factory calibration is used." };
            var limit = new Option<double?>("--limit") { HelpName = "MM", Description = "Exit 1 when size and depth disagree by more than this at a corner of the screen." };
            var command = new Command("plane", "Where the screen stands before the camera: by its size, by depth, and how the two agree.") { file, recording, camera, limit };
            command.SetAction(parsed => Run(parsed.GetValue(file)!, parsed.GetValue(recording), parsed.GetValue(camera), parsed.GetValue(limit)));
            return command;
        }

        private static int Run(string file, string? recordingFile, string? cameraFile, double? limitMm)
        {
            if (limitMm is { } limit && !(limit >= 0))
                throw new InputException("--limit", "must be a number of millimetres, 0 or more", "write it as 20");
            if (limitMm != null && recordingFile == null)
                throw new InputException("--limit", "there is nothing to compare the screen's size with", "add --depth RECORDING");
            RangeCalibration calibration = RangeCalibrationFile.Read(file);
            using KinectRecording? recording = recordingFile == null ? null : KinectRecording.Open(recordingFile);
            KinectCalibration? kinect = recording == null ? null : Factory(recording, recordingFile!, calibration);
            LensCamera camera = calibration.Screen.Camera ?? (cameraFile != null ? LensCameraJson.ReadFile(cameraFile) : kinect?.Color)
                ?? throw new InputException(file, "it does not hold the camera's lens", "add --camera FILE from 'calibrate board', or --depth RECORDING with a factory calibration");
            if (camera.Pinhole.Width != calibration.ImageWidth || camera.Pinhole.Height != calibration.ImageHeight)
                throw new InputException(cameraFile ?? file, FormattableString.Invariant($"the camera is calibrated for pictures of {camera.Pinhole.Width}x{camera.Pinhole.Height}, the screen for {calibration.ImageWidth}x{calibration.ImageHeight}"), "calibrate both at one size");
            if (!ScreenPlane.TryFromSize(calibration.Screen, camera, out ScreenPlane? plane, out string reason))
                throw new InputException(file, reason, "check the calibration");

            Vector3D middle = plane!.ScreenToCameraMm.TransformPoint(new Vector3D(plane.ScreenSizeM.X * 500, plane.ScreenSizeM.Y * 500, 0));
            JObject bySize = Place(plane.Plane);
            bySize["middle_mm"] = Rounded(2, middle.X, middle.Y, middle.Z);
            bySize["corner_rms_px"] = Math.Round(plane.CornerRmsPx, 4);
            var result = new JObject { ["from_size"] = bySize };
            bool isWithin = true;
            if (kinect != null)
            {
                PlaneFit depth = Measure(recording!, recordingFile!, kinect, calibration.Screen);
                JObject byDepth = Place(depth.Plane);
                byDepth["sigma_mm"] = Math.Round(depth.Sigma, 2);
                byDepth["points"] = depth.Count;
                byDepth["near"] = depth.NearCount;
                result["from_depth"] = byDepth;
                if (!plane.TryCompare(depth.Plane, out ScreenPlaneAgreement agreement))
                    throw new InputException(recordingFile!, "the plane that depth gives does not lie before the screen's corners", "check that both files are of the same camera in the same place");
                result["agreement"] = new JObject
                {
                    ["angle_deg"] = Math.Round(agreement.AngleRad * 180 / Math.PI, 4),
                    ["middle_mm"] = Math.Round(agreement.MiddleMm, 2),
                    ["worst_corner_mm"] = Math.Round(agreement.WorstCornerMm, 2),
                    ["screen_m_by_depth"] = Rounded(4, agreement.OtherSizeM.X, agreement.OtherSizeM.Y),
                };
                isWithin = !(agreement.WorstCornerMm > limitMm);
                if (!isWithin)
                    Console.Error.WriteLine(FormattableString.Invariant($"range: size and depth disagree by {agreement.WorstCornerMm:F1} mm at a corner of the screen, over the limit of {limitMm} mm"));
            }

            Console.WriteLine(result.ToString());
            return isWithin ? ExitCodes.Done : ExitCodes.CheckFailed;
        }

        private static KinectCalibration Factory(KinectRecording recording, string name, RangeCalibration calibration)
        {
            KinectRecordConfiguration configuration = recording.Configuration;
            if (recording.DepthTrack == null)
                throw new InputException(name, "it holds no depth", "give a recording made with depth on");
            if (!recording.TryReadCalibration(out byte[] json))
                throw new InputException(name, "it holds no device calibration", "give a recording made with a device");
            if (!KinectCalibration.TryRead(json, configuration.DepthMode, calibration.ImageWidth, calibration.ImageHeight, out KinectCalibration? kinect, out string reason))
                throw new InputException(name, reason, "give another recording");
            return kinect!;
        }

        /// <summary>The first capture whose depth gives a plane.</summary>
        private static PlaneFit Measure(KinectRecording recording, string name, KinectCalibration kinect, ScreenGeometry screen)
        {
            string reason = "it holds no depth picture that can be read";
            var depth = new ushort[kinect.Infrared.Pinhole.Width * kinect.Infrared.Pinhole.Height];
            var capture = new KinectCapture();
            while (recording.TryReadNext(capture))
            {
                if (!capture.Depth.IsPresent || capture.Depth.SizeBytes != 2 * depth.Length || !recording.TryReadPayload(capture.Depth, MemoryMarshal.AsBytes(depth.AsSpan())))
                    continue;
                if (KinectScreenPlane.TryMeasure(kinect, depth, screen, out PlaneFit? fit, out reason))
                    return fit!;
            }

            throw new InputException(name, reason, "record the screen from where the camera stands, with nobody before it");
        }

        private static JObject Place(Plane3D plane) => new()
        {
            ["normal"] = Rounded(6, plane.Normal.X, plane.Normal.Y, plane.Normal.Z),
            ["distance_mm"] = Math.Round(plane.Distance, 2),
        };

        private static JArray Rounded(int decimals, params double[] values) => new(values.Select(v => Math.Round(v, decimals)));
    }
}
