using System;
using LaserTracking.Geometry;

namespace LaserTracking.Simulation
{
    /// <summary>Where camera 0 stands and how the screen lies in its picture (before any bump). Immutable.</summary>
    internal sealed class ColorCameraGeometry
    {
        private const double FilledShare = 0.93;

        public ColorCameraGeometry(ColorCameraSettings settings, Vector2D screenSizeM)
        {
            double w = screenSizeM.X, h = screenSizeM.Y;
            Vector3D position = settings.PositionM ?? new Vector3D(0.72 * w, -0.12 * h, -1.2 * w);
            Vector2D aim = settings.LookAtM ?? new Vector2D(w / 2, h / 2);
            Pose pose = LookAt.Pose(position, new Vector3D(aim.X, aim.Y, 0), settings.RollDeg * Math.PI / 180);
            double cx = (settings.Width - 1) / 2.0, cy = (settings.Height - 1) / 2.0;
            double focal = settings.FieldOfViewDeg > 0
                ? settings.Width / 2.0 / Math.Tan(settings.FieldOfViewDeg * Math.PI / 360)
                : FittingFocal(pose, screenSizeM, settings.Width / 2.0, settings.Height / 2.0);
            Vector3D x = pose.InverseTransformDirection(new Vector3D(1, 0, 0));
            Vector3D y = pose.InverseTransformDirection(new Vector3D(0, 1, 0));
            Vector3D o = pose.InverseTransformPoint(default);
            ScreenToImage = PlaneMap.Scale(focal, focal, cx, cy) *
                            new PlaneMap(x.X, y.X, o.X, x.Y, y.Y, o.Y, x.Z, y.Z, o.Z);
            PositionM = position;
            ToScreenMm = new Pose(Axes.MetresToMillimetres(pose.Position), pose.Rotation);
            Camera = new LensCamera(new PinholeCamera(focal, focal, cx, cy, settings.Width, settings.Height), new BrownDistortion(new[] { settings.LensK1, settings.LensK2, 0 }, 0, 0));
            if (settings.LensK1 != 0 || settings.LensK2 != 0)
                Lens = Camera;
            Screen = new ScreenGeometry(new Homography(ScreenToImage.Inverse.ToArray()), screenSizeM, Lens);
        }

        /// <summary>Screen m to image px, as if there were no distortion.</summary>
        public PlaneMap ScreenToImage { get; }

        /// <summary>The camera with its lens; null: no distortion.</summary>
        public LensCamera? Lens { get; }

        /// <summary>With its true focal length, whether its lens distorts or not.</summary>
        public LensCamera Camera { get; }

        /// <summary>Camera space to screen space, both mm.</summary>
        public Pose ToScreenMm { get; }

        public ScreenGeometry Screen { get; }

        public Vector3D PositionM { get; }

        private static double FittingFocal(Pose pose, Vector2D size, double halfWidth, double halfHeight)
        {
            double focal = double.PositiveInfinity;
            for (int corner = 0; corner < 4; corner++)
            {
                Vector3D p = pose.InverseTransformPoint(new Vector3D(corner % 2 * size.X, corner / 2 * size.Y, 0));
                if (!(p.Z > 0))
                    throw new ArgumentException("color_camera looks away from the screen; correct position_m or look_at_m");
                focal = Math.Min(focal, FilledShare * Math.Min(halfWidth * p.Z / Math.Abs(p.X), halfHeight * p.Z / Math.Abs(p.Y)));
            }

            return focal;
        }
    }
}
