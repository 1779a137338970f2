using LaserTracking.Geometry;
using UnityEngine;
using Pose = LaserTracking.Geometry.Pose;

namespace LaserTracking.Unity
{
    /// <summary>
    /// The projected picture in the scene: a rectangle around this transform, local x right, y up, z into the picture, in metres
    /// whatever the transform's scale.
    /// </summary>
    [DisallowMultipleComponent]
    [AddComponentMenu("Laser Tracking/Screen Surface")]
    public sealed class ScreenSurface : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("Width and height of the projected picture in metres.")]
        private Vector2 _sizeM = new Vector2(3.73f, 2.26f);

        [SerializeField]
        [Tooltip("Screen calibration of camera 0 (JSON). Without it there are shots in the picture, but no hits.")]
        private TextAsset? _calibration;

        /// <summary>Width and height of the projected picture in metres.</summary>
        public Vector2D SizeM => _sizeM.ToCore();

        /// <summary>The calibration's text, or null.</summary>
        public string? CalibrationText => _calibration == null ? null : _calibration.text;

        /// <summary>Where the surface stands in the world; its scale plays no part.</summary>
        public Pose Pose => transform.WorldPose();

        /// <summary>A point of screen space (origin top-left, x right, y down, z into the picture; m) in the world.</summary>
        public Vector3D ScreenToWorld(Vector3D screenM) => Pose.TransformPoint(Axes.ScreenToSurface(screenM, SizeM));

        /// <summary>A world point in screen space, metres.</summary>
        public Vector3D WorldToScreen(Vector3D world) => Axes.SurfaceToScreen(Pose.InverseTransformPoint(world), SizeM);

        private void OnDrawGizmos()
        {
            Gizmos.color = Color.cyan;
            Vector3 topLeft = Corner(0, 0), topRight = Corner(SizeM.X, 0), bottomRight = Corner(SizeM.X, SizeM.Y), bottomLeft = Corner(0, SizeM.Y);
            Gizmos.DrawLine(topLeft, topRight);
            Gizmos.DrawLine(topRight, bottomRight);
            Gizmos.DrawLine(bottomRight, bottomLeft);
            Gizmos.DrawLine(bottomLeft, topLeft);
        }

        private Vector3 Corner(double xM, double yM) => ScreenToWorld(new Vector3D(xM, yM, 0)).ToUnity();
    }
}
