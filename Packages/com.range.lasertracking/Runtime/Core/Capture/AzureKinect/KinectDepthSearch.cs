using System;
using LaserTracking.Geometry;

namespace LaserTracking.Capture.AzureKinect
{
    /// <summary>
    /// Where in the depth picture lies what a colour pixel shows: walks out along the pixel's ray, which is a curve in the depth picture
    /// (the epipolar curve), to where it first meets the measured surface. For points on a known plane use the plane instead. Immutable,
    /// allocates nothing.
    /// </summary>
    public sealed class KinectDepthSearch
    {
        // The SDK's range, and how far off the pixel found may be when it is carried back into the colour picture.
        private const double NearestMm = 50;
        private const double FarthestMm = 14000;
        private const double LargestErrorPx = 10;
        private const int Halvings = 30;
        private readonly KinectTransformation _transformation;
        private readonly LensCamera _depth;
        private readonly Pose _colorToDepthMm;

        public KinectDepthSearch(KinectCalibration calibration)
        {
            _transformation = new KinectTransformation(calibration);
            _depth = calibration.Infrared;
            _colorToDepthMm = calibration.InfraredToColorMm.Inverse;
        }

        /// <param name="colorPixel">In the colour picture.</param>
        /// <param name="depthMm">The depth picture, row by row without gaps; 0: nothing measured.</param>
        /// <param name="depthPixel">Valid only when true is returned; between pixels as a rule.</param>
        /// <returns>False where the ray meets nothing that was measured or the depth camera does not see the place.</returns>
        public bool TryFind(Vector2D colorPixel, ReadOnlySpan<ushort> depthMm, out Vector2D depthPixel)
        {
            depthPixel = default;
            if (depthMm.Length != _depth.Pinhole.Width * _depth.Pinhole.Height)
                throw new ArgumentException("this is no depth picture of the calibration's mode", nameof(depthMm));
            if (!_transformation.CameraOf(KinectSensor.Color).TryUnproject(colorPixel, out Vector2D ray))
                return false;

            // Even steps in 1/z are even steps along the curve; there are at least as many as it is pixels long.
            const double near = 1 / NearestMm, far = 1 / FarthestMm;
            double longest = _depth.Pinhole.FocalXPx * _colorToDepthMm.Position.Length * near;
            int steps = (int)Math.Min(100000, Math.Max(16, 2 * longest));
            double before = near;
            bool wasInFront = false;
            for (int i = 0; i <= steps; i++)
            {
                double inverse = near + (far - near) * i / steps;
                double gap = Gap(ray, inverse, depthMm, out _);
                if (gap >= 0 && wasInFront && IsMeeting(ray, colorPixel, before, inverse, depthMm, out depthPixel))
                    return true;
                wasInFront = gap < 0;
                before = inverse;
            }

            return false;
        }

        /// <summary>Between in front of and behind the surface lies the surface, or an edge behind which the place is hidden.</summary>
        private bool IsMeeting(Vector2D ray, Vector2D colorPixel, double front, double behind, ReadOnlySpan<ushort> depthMm, out Vector2D depthPixel)
        {
            for (int i = 0; i < Halvings; i++)
            {
                double middle = (front + behind) / 2, gap = Gap(ray, middle, depthMm, out _);
                if (gap < 0)
                    front = middle;
                else if (gap >= 0)
                    behind = middle;
                else
                    break;
            }

            Gap(ray, behind, depthMm, out depthPixel);
            return _transformation.TryTo2D(KinectSensor.Depth, depthPixel, DepthAt(depthPixel, depthMm), KinectSensor.Color, out Vector2D back)
                && (back - colorPixel).Length <= LargestErrorPx;
        }

        /// <summary>How far the ray's point lies behind what the depth camera measured there, mm; not a number where it measured nothing.</summary>
        private double Gap(Vector2D ray, double inverseZ, ReadOnlySpan<ushort> depthMm, out Vector2D depthPixel)
        {
            Vector3D point = _colorToDepthMm.TransformPoint(new Vector3D(ray.X, ray.Y, 1) * (1 / inverseZ));
            double measured = _depth.TryProject(point, out depthPixel) ? DepthAt(depthPixel, depthMm) : 0;
            return measured > 0 ? point.Z - measured : double.NaN;
        }

        private int DepthAt(Vector2D pixel, ReadOnlySpan<ushort> depthMm)
        {
            int width = _depth.Pinhole.Width;
            double x = Math.Floor(pixel.X + 0.5), y = Math.Floor(pixel.Y + 0.5);
            return x >= 0 && y >= 0 && x < width && y < _depth.Pinhole.Height ? depthMm[(int)y * width + (int)x] : 0;
        }
    }
}
