using System;
using LaserTracking.Capture;
using LaserTracking.Capture.AzureKinect;
using LaserTracking.Geometry;

namespace LaserTracking.Host.Sources
{
    /// <summary>Finds out how camera 0's infrared picture lies on its colour picture.</summary>
    internal static class InfraredMappings
    {
        /// <summary>Where the screen is taken to be when no calibration tells, mm: a tenth more or less moves the mapping by 1 px.</summary>
        private const double UsualDistanceMm = 2500;

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
