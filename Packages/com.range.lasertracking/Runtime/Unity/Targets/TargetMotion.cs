using LaserTracking.Geometry;
using LaserTracking.Scoring;
using UnityEngine;
using Pose = LaserTracking.Geometry.Pose;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Moves a target on a path that is a function of time, or (kind None) remembers where something else moved it, so that a shot
    /// can be judged against where the target was when the light left the laser.
    /// </summary>
    [DisallowMultipleComponent]
    [AddComponentMenu("Laser Tracking/Target Motion")]
    public sealed class TargetMotion : MonoBehaviour
    {
        private const int HistoryLength = 128;

        [SerializeField]
        [Tooltip("None: moved by something else; its last poses are remembered.")]
        private MotionKind _kind;

        [SerializeField]
        [Tooltip("Extent in metres in the parent's axes.")]
        private Vector3 _travelM;

        [SerializeField]
        [Min(0.01f)]
        [Tooltip("Seconds until the motion repeats.")]
        private float _periodS = 4;

        [SerializeField]
        [Tooltip("Seconds added to the time.")]
        private float _phaseS;

        private readonly PoseHistory _history = new PoseHistory(HistoryLength);
        private MotionPath _path;
        private Vector3 _rest;
        private Vector3 _shownPosition;
        private Quaternion _shownRotation;

        /// <summary>Seconds to add to Unity's time for the scene's clock, which is camera 0's. Set by the range in every frame.</summary>
        public double ClockOffsetS { get; set; }

        /// <summary>Displacement from rest in the parent's axes; kind None: moved by something else, or nowhere.</summary>
        internal MotionPath Path => _path;

        /// <summary>World pose at a time on the scene's clock, seconds.</summary>
        public Pose PoseAt(double sceneTimeS)
        {
            if (_path.Kind != MotionKind.None)
            {
                Vector3 local = LocalPositionAt(sceneTimeS);
                Transform? parent = transform.parent;
                return new Pose((parent == null ? local : parent.TransformPoint(local)).ToCore(), transform.rotation.ToCore());
            }

            return _history.TryGetPoseAt(sceneTimeS, out Pose pose) ? pose : transform.WorldPose();
        }

        /// <summary>Puts the target where it was, for a ray cast into the past; <see cref="Restore"/> must follow.</summary>
        internal void Rewind(double sceneTimeS)
        {
            Remember();
            if (_path.Kind != MotionKind.None)
            {
                transform.localPosition = LocalPositionAt(sceneTimeS);
            }
            else if (_history.TryGetPoseAt(sceneTimeS, out Pose pose))
            {
                transform.SetPositionAndRotation(pose.Position.ToUnity(), pose.Rotation.ToUnity());
            }
        }

        /// <summary>Puts the target where its path has no displacement; <see cref="Restore"/> must follow.</summary>
        internal void Rest()
        {
            Remember();
            if (_path.Kind != MotionKind.None)
                transform.localPosition = _rest;
        }

        /// <summary>Back to what is shown, to the bit.</summary>
        internal void Restore()
        {
            transform.localPosition = _shownPosition;
            transform.localRotation = _shownRotation;
        }

        private void Remember()
        {
            _shownPosition = transform.localPosition;
            _shownRotation = transform.localRotation;
        }

        private void Awake()
        {
            _rest = transform.localPosition;
            if (_kind != MotionKind.None && !(_periodS > 0))
            {
                ShotEmitters.Report(this, "TargetMotion " + name + ": the period must be above zero seconds; the target stands still", true);
                return;
            }

            _path = new MotionPath(_kind, _travelM.ToCore(), _periodS, _phaseS);
        }

        private void OnEnable() => MovingTargets.Add(this);

        private void OnDisable() => MovingTargets.Remove(this);

        private void Update()
        {
            if (_path.Kind != MotionKind.None)
                transform.localPosition = LocalPositionAt(Time.timeAsDouble + ClockOffsetS);
        }

        // After every Update, so that whatever moved the target this frame has done so.
        private void LateUpdate()
        {
            if (_path.Kind == MotionKind.None)
                _history.Add(Time.timeAsDouble + ClockOffsetS, transform.WorldPose());
        }

        private Vector3 LocalPositionAt(double sceneTimeS) => _rest + _path.OffsetAt(sceneTimeS).ToUnity();
    }
}
