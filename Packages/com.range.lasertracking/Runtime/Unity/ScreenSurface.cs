using System;
using System.IO;
using LaserTracking.Geometry;
using UnityEngine;
using Pose = LaserTracking.Geometry.Pose;

namespace LaserTracking.Unity
{
    /// <summary>
    /// The projected picture in the scene: a rectangle around this transform, local x right, y up, z into the picture, in metres
    /// whatever the transform's scale. It may be moved, and the viewpoint too: shots go through both as they stood when the light left.
    /// Runs after other components, so that whatever moves them has done so.
    /// </summary>
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(1000)]
    [AddComponentMenu("Laser Tracking/Screen Surface")]
    public sealed class ScreenSurface : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("Width and height of the projected picture in metres.")]
        private Vector2 _sizeM = new Vector2(3.73f, 2.26f);

        [SerializeField]
        [Tooltip("Screen calibration of camera 0 (JSON). Without it there are shots in the picture, but no hits.")]
        private TextAsset? _calibration;

        [SerializeField]
        [Tooltip("File in Unity's persistent data folder that a CalibrationScreen writes; once it is there it counts and not the asset. Empty: none.")]
        private string _calibrationFile = "";

        [SerializeField]
        [Tooltip("Stands before the main camera, wherever that goes, so that it fills the height of its view: for a desk without a real screen. A perspective camera without lens shift.")]
        private bool _fillsCamera;

        private RangeCalibration? _inUse;

        /// <summary>Width and height of the projected picture in metres.</summary>
        public Vector2D SizeM => _sizeM.ToCore();

        /// <summary>Both above zero and finite; else nothing can be hit.</summary>
        public bool HasSize => _sizeM.x > 0 && _sizeM.y > 0 && SizeM.IsFinite;

        /// <summary>The calibration: what was put in use, else the file where there is one, else the asset; null when there is none.</summary>
        /// <exception cref="InputException">It is none; the message says what is wrong.</exception>
        public RangeCalibration? ReadCalibration()
        {
            if (_inUse != null)
                return _inUse;
            if (CalibrationPath is string path && File.Exists(path))
                return RangeCalibrationFile.Read(path);
            return _calibration == null ? null : RangeCalibrationFile.Parse(_calibration.text, "calibration of " + name);
        }

        /// <summary>Where a calibration made while it runs is kept; null when none shall be.</summary>
        /// <exception cref="InputException">What was entered is no path.</exception>
        public string? CalibrationPath =>
            _calibrationFile.Length == 0 ? null : UserPath.Under(Application.persistentDataPath, _calibrationFile);

        /// <summary>Puts a calibration in use for this run.</summary>
        internal void Use(RangeCalibration calibration) => _inUse = calibration;

        /// <summary>Puts a calibration in use, and in the file where there shall be one. A range reads it when it opens.</summary>
        /// <param name="calibration">The screen's own.</param>
        /// <param name="problem">Why it could not be kept; it is in use all the same until this component is gone.</param>
        public bool TryUse(RangeCalibration calibration, out string problem)
        {
            _inUse = calibration;
            problem = "";
            try
            {
                if (CalibrationPath is string path)
                    RangeCalibrationFile.Write(calibration, path);
                return true;
            }
            catch (Exception failure) when (failure is IOException || failure is UnauthorizedAccessException || failure is InputException)
            {
                problem = failure.Message;
                return false;
            }
        }

        /// <summary>Where the surface stands in the world; its scale plays no part.</summary>
        public Pose Pose
        {
            get
            {
                Camera? camera = _fillsCamera ? Camera.main : null;
                return camera == null ? transform.WorldPose() : BeforeCamera(camera);
            }
        }

        /// <summary>A point of screen space (origin top-left, x right, y down, z into the picture; m) in the world.</summary>
        public Vector3D ScreenToWorld(Vector3D screenM) => Pose.TransformPoint(Axes.ScreenToSurface(screenM, SizeM));

        /// <summary>A world point in screen space, metres.</summary>
        public Vector3D WorldToScreen(Vector3D world) => Axes.SurfaceToScreen(Pose.InverseTransformPoint(world), SizeM);

        private void LateUpdate() => ShotEmitters.RememberViews(this);

        private void OnDrawGizmos()
        {
            Gizmos.color = Color.cyan;
            Vector3 topLeft = Corner(0, 0), topRight = Corner(SizeM.X, 0), bottomRight = Corner(SizeM.X, SizeM.Y), bottomLeft = Corner(0, SizeM.Y);
            Gizmos.DrawLine(topLeft, topRight);
            Gizmos.DrawLine(topRight, bottomRight);
            Gizmos.DrawLine(bottomRight, bottomLeft);
            Gizmos.DrawLine(bottomLeft, topLeft);
        }

        private Pose BeforeCamera(Camera camera)
        {
            Pose eye = camera.transform.WorldPose();
            double distanceM = _sizeM.y / 2 / Math.Tan(camera.fieldOfView * Math.PI / 360);
            return new Pose(eye.TransformPoint(new Vector3D(0, 0, distanceM)), eye.Rotation);
        }

        private Vector3 Corner(double xM, double yM) => ScreenToWorld(new Vector3D(xM, yM, 0)).ToUnity();
    }
}
