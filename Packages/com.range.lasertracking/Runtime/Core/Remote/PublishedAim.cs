using System;
using LaserTracking.Geometry;

namespace LaserTracking.Remote
{
    /// <summary>
    /// Puts the ray of a published message into the scene, as published: camera 0's millimetres to the scene's metres with the axis flip
    /// F = diag(+1, −1, +1), the camera vector (muzzle to dot) smoothed by an exponential mean, then the ray through the screen's plane.
    /// The mean lags by (1 − α)/α messages. One thread; no allocation.
    /// </summary>
    public sealed class PublishedAim
    {
        private readonly Vector3D _axisFlip;
        private readonly double _alpha;
        private Vector3D _smoothed = new Vector3D(double.NaN, double.NaN, double.NaN);
        private long _lastTimeUs;

        /// <summary>The published F: y down to y up.</summary>
        public static Vector3D PublishedFlip => new Vector3D(1, -1, 1);

        /// <summary>The published weight of the newest vector.</summary>
        public const double PublishedAlpha = 0.2;

        /// <param name="axisFlip">Factors on camera 0's axes, each +1 or −1.</param>
        /// <param name="alpha">Weight of the newest vector, above 0 up to 1; 1: not smoothed.</param>
        public PublishedAim(Vector3D axisFlip, double alpha)
        {
            if (Math.Abs(axisFlip.X) != 1 || Math.Abs(axisFlip.Y) != 1 || Math.Abs(axisFlip.Z) != 1)
                throw new ArgumentException("the axis flip has only +1 and -1");
            if (!(alpha > 0 && alpha <= 1))
                throw new ArgumentException("alpha lies above 0 and at most at 1");
            _axisFlip = axisFlip;
            _alpha = alpha;
        }

        /// <summary>Takes the next message's vector into the mean; the same message again changes nothing.</summary>
        public void Add(in RemotePose pose)
        {
            if (!pose.Direction.IsFinite || (_smoothed.IsFinite && pose.TimeUs == _lastTimeUs))
                return;
            _lastTimeUs = pose.TimeUs;
            _smoothed = _smoothed.IsFinite ? pose.Direction * _alpha + _smoothed * (1 - _alpha) : pose.Direction;
        }

        /// <summary>
        /// Where the ray from the message's muzzle along the smoothed vector meets the screen; without a vector, the message's own dot.
        /// False when it meets nothing.
        /// </summary>
        /// <param name="pose">Of space <see cref="RemoteSpace.CameraMm"/>.</param>
        /// <param name="camera">Camera 0 in the scene, looking along its z axis.</param>
        /// <param name="surface">The screen in the scene: local x right, y up, z into the picture.</param>
        /// <param name="screenSizeM">Width and height of the picture.</param>
        /// <param name="muzzleM">The muzzle in screen space; not finite where it is not known.</param>
        /// <param name="screenM">The meeting in screen space.</param>
        public bool TryPlace(in RemotePose pose, Pose camera, Pose surface, Vector2D screenSizeM, out Vector3D muzzleM, out Vector2D screenM)
        {
            Vector3D from = OnSurface(pose.Muzzle, camera, surface), at;
            muzzleM = Axes.SurfaceToScreen(from, screenSizeM);
            if (from.IsFinite && _smoothed.IsFinite)
            {
                Vector3D along = surface.InverseTransformDirection(camera.TransformDirection(Vector3D.Scale(_axisFlip, _smoothed)));
                at = from + along * (-from.Z / along.Z);
                if (!(from.Z < 0 && along.Z > 0))
                    at = new Vector3D(double.NaN, double.NaN, double.NaN);
            }
            else
            {
                at = OnSurface(pose.Target, camera, surface);
            }

            Vector3D onScreen = Axes.SurfaceToScreen(at, screenSizeM);
            screenM = new Vector2D(onScreen.X, onScreen.Y);
            return screenM.IsFinite;
        }

        private Vector3D OnSurface(Vector3D cameraMm, Pose camera, Pose surface) =>
            surface.InverseTransformPoint(camera.TransformPoint(Axes.MillimetresToMetres(Vector3D.Scale(_axisFlip, cameraMm))));
    }
}
