using System.Collections.Generic;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Shows shots: a hole where each ended, the target lit for a moment, a line along the way. All from pools of fixed size, the oldest
    /// goes first; coloured by shooter. Without an emitter it listens to the one on its own object or above.
    /// </summary>
    [DisallowMultipleComponent]
    [AddComponentMenu("Laser Tracking/Shot Visuals")]
    public sealed class ShotVisuals : MonoBehaviour
    {
        private static readonly int BaseColor = Shader.PropertyToID("_BaseColor");
        private static readonly int MainColor = Shader.PropertyToID("_Color");

        [SerializeField]
        [Tooltip("Whose shots are shown. Empty: the LaserRange or RemoteInput on this object or above.")]
        private ShotEmitter? _emitter;

        [SerializeField]
        [Tooltip("Of the holes: an unlit one works in every render pipeline.")]
        private Material? _holeMaterial;

        [SerializeField]
        [Tooltip("Of the lines.")]
        private Material? _rayMaterial;

        [SerializeField]
        [Range(0, 512)]
        [Tooltip("Holes shown at once; with the next one the oldest goes.")]
        private int _holes = 64;

        [SerializeField]
        [Range(0, 64)]
        [Tooltip("Lines shown at once.")]
        private int _rays = 16;

        [SerializeField]
        [Min(0.001f)]
        private float _holeDiameterM = 0.03f;

        [SerializeField]
        [Min(0.001f)]
        private float _rayWidthM = 0.008f;

        [SerializeField]
        [Min(0)]
        [Tooltip("Seconds for which a line is seen.")]
        private float _rayS = 0.35f;

        [SerializeField]
        [Min(0)]
        [Tooltip("Seconds for which a hit target is lit; 0: not at all.")]
        private float _flashS = 0.2f;

        [SerializeField]
        private ShooterColors _colors = new ShooterColors();

        private readonly List<TargetFlash> _flashes = new List<TargetFlash>();
        private HoleMark[] _holeMarks = new HoleMark[0];
        private ShotRay[] _shotRays = new ShotRay[0];
        private MaterialPropertyBlock? _color;
        private ShotEmitter? _listened;
        private int _nextHole;
        private int _nextRay;

        /// <summary>Holes that can be seen now.</summary>
        public int HolesShown
        {
            get
            {
                int shown = 0;
                foreach (HoleMark hole in _holeMarks)
                    shown += hole.IsShown ? 1 : 0;
                return shown;
            }
        }

        /// <summary>Lines that can be seen now.</summary>
        public int RaysShown
        {
            get
            {
                int shown = 0;
                foreach (ShotRay ray in _shotRays)
                    shown += ray.IsShown ? 1 : 0;
                return shown;
            }
        }

        /// <summary>Whether a target is lit now.</summary>
        public bool IsLit(LaserTarget target) => _flashes.Exists(flash => flash.Target == target && flash.IsLit);

        /// <summary>Takes all marks away, for the next run.</summary>
        public void Clear()
        {
            foreach (HoleMark hole in _holeMarks)
                hole.Hide();
            foreach (ShotRay ray in _shotRays)
                ray.Hide();
            foreach (TargetFlash flash in _flashes)
                flash.PutOut();
        }

        private void Awake()
        {
            _color = new MaterialPropertyBlock();
            _holeMarks = new HoleMark[_holes];
            for (int i = 0; i < _holes; i++)
                _holeMarks[i] = new HoleMark(transform, _holeMaterial, _holeDiameterM);
            _shotRays = new ShotRay[_rays];
            for (int i = 0; i < _rays; i++)
                _shotRays[i] = new ShotRay(transform, _rayMaterial, _rayWidthM);
        }

        private void OnEnable()
        {
            _listened = _emitter != null ? _emitter : GetComponentInParent<ShotEmitter>();
            if (_listened == null)
                ShotEmitters.Report(this, "ShotVisuals " + name + " has no emitter, so it shows nothing; drag the LaserRange in", false);
            else
                _listened.ShotTraced += Show;
        }

        private void OnDisable()
        {
            if (_listened is ShotEmitter listened)
                listened.ShotTraced -= Show;
            _listened = null;
            Clear();
        }

        // After what the marks are on has moved.
        private void LateUpdate()
        {
            double nowS = Time.timeAsDouble;
            for (int i = 0; i < _holeMarks.Length; i++)
                _holeMarks[i].Follow();
            for (int i = 0; i < _shotRays.Length; i++)
                _shotRays[i].Update(nowS);
            for (int i = 0; i < _flashes.Count; i++)
                _flashes[i].Update(nowS);
        }

        private void Show(ShotTrace trace)
        {
            Color color = _colors.Of(trace.Shot.Shooter);
            double nowS = Time.timeAsDouble;
            _color!.SetColor(BaseColor, color);
            _color.SetColor(MainColor, color);
            if (_shotRays.Length > 0)
                _shotRays[_nextRay++ % _shotRays.Length].Show(trace, color, _color, nowS + _rayS);
            if (trace.Met == null)
                return;
            if (_holeMarks.Length > 0)
                _holeMarks[_nextHole++ % _holeMarks.Length].Show(trace, _color);
            if (trace.Target != null && _flashS > 0)
                FlashOf(trace.Target).Light(color, nowS + _flashS);
        }

        /// <summary>Made with a target's first hit; those of destroyed targets make room.</summary>
        private TargetFlash FlashOf(LaserTarget target)
        {
            for (int i = _flashes.Count - 1; i >= 0; i--)
            {
                if (_flashes[i].Target == target)
                    return _flashes[i];
                if (_flashes[i].Target == null)
                    _flashes.RemoveAt(i);
            }

            var made = new TargetFlash(target);
            _flashes.Add(made);
            return made;
        }
    }
}
