using System;
using LaserTracking.Geometry;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>
    /// From pixels to points in space and back, between the device's sensors: what the Sensor SDK's calibration functions give, in
    /// double precision, and nothing where they give nothing (a pixel's own ray is better asked of <see cref="LensCamera"/>). Pixel
    /// centres are integers, lengths are mm. Immutable, allocates nothing.
    /// </summary>
    public sealed class KinectTransformation
    {
        private readonly KinectCalibration _calibration;

        public KinectTransformation(KinectCalibration calibration)
        {
            _calibration = calibration ?? throw new ArgumentNullException(nameof(calibration));
        }

        /// <summary>The camera of a sensor that takes pictures.</summary>
        /// <exception cref="ArgumentException">A motion sensor.</exception>
        public LensCamera CameraOf(KinectSensor sensor)
        {
            switch (sensor)
            {
                case KinectSensor.Depth: return _calibration.Infrared;
                case KinectSensor.Color: return _calibration.Color;
                default: throw new ArgumentException("this sensor takes no pictures", nameof(sensor));
            }
        }

        /// <summary>A pixel with its depth as a point of another sensor's space.</summary>
        /// <param name="source">Whose pixel it is.</param>
        /// <param name="pixel">In its picture.</param>
        /// <param name="depthMm">Along the source's axis, not along the ray.</param>
        /// <param name="target">Whose space is wanted.</param>
        /// <param name="pointMm">Valid only when true is returned.</param>
        /// <returns>False without depth, where the lens model gives no ray, or for a sensor whose place is not known.</returns>
        public bool TryTo3D(KinectSensor source, Vector2D pixel, double depthMm, KinectSensor target, out Vector3D pointMm)
        {
            pointMm = default;
            if (!(depthMm > 0) || !_calibration.TryGetPose(source, target, out Pose pose) || !CameraOf(source).TryUnproject(pixel, out Vector2D ray))
                return false;
            if (!(source == KinectSensor.Depth ? _calibration.InfraredCheck : _calibration.ColorCheck).HasRay(pixel.X, pixel.Y))
                return false;
            pointMm = pose.TransformPoint(new Vector3D(ray.X * depthMm, ray.Y * depthMm, depthMm));
            return true;
        }

        /// <summary>Where a point of one sensor's space is seen by another, also beside its picture; false behind it or outside its lens model.</summary>
        public bool TryTo2D(KinectSensor source, Vector3D pointMm, KinectSensor target, out Vector2D pixel)
        {
            pixel = default;
            return TryTo3D(source, pointMm, target, out Vector3D there) && CameraOf(target).TryProject(there, out pixel);
        }

        /// <summary>A point of one sensor's space in another's; false for a sensor whose place is not known.</summary>
        public bool TryTo3D(KinectSensor source, Vector3D pointMm, KinectSensor target, out Vector3D targetMm)
        {
            bool isKnown = _calibration.TryGetPose(source, target, out Pose pose);
            targetMm = pose.TransformPoint(pointMm);
            return isKnown;
        }

        /// <summary>A pixel with its depth as the pixel of another sensor that sees the same point. Within one sensor it stays as it is.</summary>
        public bool TryTo2D(KinectSensor source, Vector2D pixel, double depthMm, KinectSensor target, out Vector2D targetPixel)
        {
            targetPixel = pixel;
            return source == target || (TryTo3D(source, pixel, depthMm, target, out Vector3D point) && CameraOf(target).TryProject(point, out targetPixel));
        }
    }
}
