using System;
using System.CommandLine;
using System.Linq;
using LaserTracking.Geometry;
using LaserTracking.Host.Calibration;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Commands
{
    /// <summary>range calibrate plane: where the screen stands before the camera, by its size and by depth, and how the two agree.</summary>
    internal static class CalibratePlaneCommand
    {
        /// <summary>Corners that miss by more fail: a few pixels are what pointing at them by hand leaves.</summary>
        private const double MostCornerRmsPx = 3;

        public static Command Create()
        {
            var file = new Argument<string>("CALIBRATION") { Description = "What 'calibrate screen' wrote." };
            var recording = new Option<string?>("--depth") { HelpName = "RECORDING", Description = "A recording (.mkv) of the same camera in the same place, with depth; or a simulation's scenario (.json) whose camera 1 sees the screen." };
            var camera = new Option<string?>("--camera") { HelpName = "FILE", Description = "The camera with its lens, when the calibration does not hold it; else the recording's factory calibration is used." };
            var limit = new Option<double?>("--limit") { HelpName = "MM", Description = "Exit 1 when size and depth disagree by more than this at a corner of the screen." };
            var command = new Command("plane", "Where the screen stands before the camera: by its size, by depth, and how the two agree; exit 1 when no flat screen of that size fits.") { file, recording, camera, limit };
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
            using DepthView? view = recordingFile == null ? null : DepthView.Open(recordingFile, calibration.ImageWidth, calibration.ImageHeight);
            LensCamera camera = (calibration.Screen.IsFocalLengthKnown ? calibration.Screen.Camera : null) ?? (cameraFile != null ? LensCameraJson.ReadFile(cameraFile) : view?.Color)
                ?? throw new InputException(file, calibration.Screen.Camera == null ? "it does not hold the camera's lens" : "its lens was found from the screen alone, which does not show the focal length",
                    "add --camera FILE from 'calibrate board', or --depth RECORDING with a factory calibration");
            if (camera.Pinhole.Width != calibration.ImageWidth || camera.Pinhole.Height != calibration.ImageHeight)
                throw new InputException(cameraFile ?? file, FormattableString.Invariant($"the camera is calibrated for pictures of {camera.Pinhole.Width}x{camera.Pinhole.Height}, the screen for {calibration.ImageWidth}x{calibration.ImageHeight}"), "calibrate both at one size");
            if (!ScreenPlane.TryFromSize(calibration.Screen, camera, out ScreenPlane? plane, out string reason))
                throw new InputException(file, reason, "check the calibration");

            Vector3D middle = plane!.ScreenToCameraMm.TransformPoint(new Vector3D(plane.ScreenSizeM.X * 500, plane.ScreenSizeM.Y * 500, 0));
            JObject bySize = Place(plane.Plane);
            bySize["middle_mm"] = Rounded(2, middle.X, middle.Y, middle.Z);
            bySize["corner_rms_px"] = Math.Round(plane.CornerRmsPx, 4);
            bool isFlat = plane.CornerRmsPx <= MostCornerRmsPx, isWithin = true;
            if (!isFlat)
                Console.Error.WriteLine(FormattableString.Invariant($"range: {file}: no flat screen of {plane.ScreenSizeM.X}x{plane.ScreenSizeM.Y} m looks like this to that camera, its corners miss by {plane.CornerRmsPx:F1} px: check the size, the corners and the camera's focal length"));
            var result = new JObject { ["from_size"] = bySize };
            if (view != null)
            {
                PlaneFit depth = view.Measure(calibration.Screen);
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
            return isFlat && isWithin ? ExitCodes.Done : ExitCodes.CheckFailed;
        }

        private static JObject Place(Plane3D plane) => new()
        {
            ["normal"] = Rounded(6, plane.Normal.X, plane.Normal.Y, plane.Normal.Z),
            ["distance_mm"] = Math.Round(plane.Distance, 2),
        };

        private static JArray Rounded(int decimals, params double[] values) => new(values.Select(v => Math.Round(v, decimals)));
    }
}
