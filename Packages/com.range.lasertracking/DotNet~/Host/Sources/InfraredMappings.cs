using System;
using LaserTracking.Capture;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Geometry;
using Newtonsoft.Json.Linq;

namespace LaserTracking.Host.Sources
{
    /// <summary>Finds out how camera 0's infrared picture lies on its colour picture.</summary>
    internal static class InfraredMappings
    {
        /// <summary>Where the screen is taken to be when no calibration tells, mm: a tenth more or less moves the mapping by 1 px.</summary>
        private const double UsualDistanceMm = 2500;

        /// <summary>Least error along one axis that a mapping is trusted with, px of a picture 1920 wide.</summary>
        private const double LeastSigmaPx = 0.1;

        /// <summary>What 'calibrate mapping' wrote, for one screen and one place of the cameras.</summary>
        /// <exception cref="InputException">The file cannot be read or is no mapping.</exception>
        public static InfraredMapping Read(string file)
        {
            const string Maker = "'range calibrate mapping'";
            JObject root = CalibrationJson.ReadFile(file);
            CalibrationJson.CheckKind(root, file, "mapping", Maker);
            LensCamera infrared = Camera("infrared"), color = Camera("color");
            var rays = new Homography(CalibrationJson.Matrix(root["H_rays"], 3, file, "H_rays"));
            double rms = CalibrationJson.Numbers(new JArray((root["held_out"] as JObject)?["rms_px_1920"] is JValue { Type: not JTokenType.Null } proven ? proven : root["rms_px_1920"] ?? JValue.CreateNull()), 1, file, "rms_px_1920")[0];
            var mapping = InfraredMapping.OfRays(infrared, color, rays, Math.Max(LeastSigmaPx, Math.Abs(rms) / Math.Sqrt(2)));
            return mapping.TryMap(new Vector2D((infrared.Pinhole.Width - 1) / 2.0, (infrared.Pinhole.Height - 1) / 2.0), out Vector2D middle)
                && middle.X >= 0 && middle.Y >= 0 && middle.X < color.Pinhole.Width && middle.Y < color.Pinhole.Height
                ? mapping
                : throw new InputException(file, "field H_rays lays the middle of the infrared picture outside the colour picture", "name a file that " + Maker + " made");

            LensCamera Camera(string name) => LensCameraJson.Parse(root[name] as JObject ?? throw new InputException(file, $"field {name} is missing", "name a file that " + Maker + " made"), file, name + ".");
        }

        /// <summary>Refuses a mapping that was made for pictures of other sizes than a recording's.</summary>
        /// <exception cref="InputException">It was; where the sizes stand the other way round, that is said.</exception>
        public static void CheckSizes(InfraredMapping mapping, string file, IFrameSource source)
        {
            if (source is not KinectRecordingSource { Recording: { InfraredTrack: not null, ColorTrack: not null, Configuration: { } configuration } })
                return;
            (int width, int height) = KinectDepthModes.SizeOf(configuration.DepthMode);
            if (mapping.IsFor(width, height, configuration.ColorWidth, configuration.ColorHeight))
                return;
            bool isExchanged = mapping.IsFor(configuration.ColorWidth, configuration.ColorHeight, width, height);
            throw new InputException(file, FormattableString.Invariant($"this mapping is of other pictures than the recording's infrared {width}x{height} and colour {configuration.ColorWidth}x{configuration.ColorHeight}") + (isExchanged ? ": infrared and colour are exchanged in it" : string.Empty),
                isExchanged ? "exchange \"infrared\" and \"color\" in the file of points and run 'range calibrate mapping' again" : "run 'range calibrate mapping' on pictures of these sizes");
        }

        /// <summary>By the factory calibration in a recording; null without infrared, or with the reason why the calibration is of no use.</summary>
        /// <param name="source">Camera 0.</param>
        /// <param name="calibration">Where the screen lies; null: it faces the camera 2.5 m away.</param>
        /// <param name="problem">What the user should know when null is returned; null: there is nothing to map.</param>
        public static InfraredMapping? Find(IFrameSource source, RangeCalibration? calibration, out string? problem)
        {
            problem = null;
            if (source is not KinectRecordingSource { Recording: { InfraredTrack: not null, ColorTrack: not null } recording })
                return null;
            string reason = "the recording has no device calibration";
            KinectRecordConfiguration configuration = recording.Configuration;
            if (recording.TryReadCalibration(out byte[] json)
                && KinectCalibration.TryRead(json, configuration.DepthMode, configuration.ColorWidth, configuration.ColorHeight, out KinectCalibration? kinect, out reason))
            {
                if (calibration == null)
                    return InfraredMapping.OfCameras(kinect!.Infrared, kinect.Color, kinect.InfraredToColorMm, UsualDistanceMm);
                try
                {
                    return InfraredMapping.OnScreen(kinect!.Infrared, kinect.Color, kinect.InfraredToColorMm, calibration.Screen);
                }
                catch (ArgumentException unusable)
                {
                    reason = unusable.Message;
                }
            }

            problem = reason + ": infrared is laid on colour by equal fields of view, which may be off by many pixels";
            return null;
        }
    }
}
