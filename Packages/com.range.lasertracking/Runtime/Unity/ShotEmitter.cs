using System;
using System.Collections.Generic;
using LaserTracking.Geometry;
using LaserTracking.Scoring;
using LaserTracking.Session;
using UnityEngine;
using UnityEngine.Events;

namespace LaserTracking.Unity
{
    /// <summary>
    /// What all components that bring shots into a scene share: where the screen stands, how a shot becomes a hit, who is told. All
    /// events come on the main thread; a listener that throws keeps nobody else from hearing.
    /// </summary>
    public abstract class ShotEmitter : MonoBehaviour
    {
        [SerializeField]
        private ScreenSurface? _screen;

        [SerializeField]
        [Tooltip("Eye from which the picture on the screen is drawn, in front of the screen. Empty: the main camera.")]
        private Transform? _viewpoint;

        [SerializeField]
        [Tooltip("Layers that shots can hit.")]
        private LayerMask _hitLayers = ~0;

        [SerializeField]
        [Tooltip("Viewpoint: a shot meets what the picture shows under the dot. Muzzle: the published rule, from the muzzle through the dot, where the muzzle is known.")]
        private AimRay _aim;

        [SerializeField]
        [Tooltip("Called for every shot, hit or miss.")]
        private UnityEvent<ShotEvent> _shotFired = new UnityEvent<ShotEvent>();

        [SerializeField]
        [Tooltip("Called for everything the operator should know.")]
        private UnityEvent<HealthEvent> _healthChanged = new UnityEvent<HealthEvent>();

        private readonly Queue<HealthEvent> _health = new Queue<HealthEvent>();
        private ShotCaster? _caster;

        /// <summary>Raised for every shot, hit or miss, in the order of the shots.</summary>
        public event Action<ShotEvent>? ShotFired;

        /// <summary>The same shots with their way through the scene, for those who draw it; only shots with a place on the screen.</summary>
        public event Action<ShotTrace>? ShotTraced;

        /// <summary>Raised for everything the operator should know; the Console has it too.</summary>
        public event Action<HealthEvent>? HealthChanged;

        /// <summary>The screen that the shots land on.</summary>
        public ScreenSurface? Screen => _screen == null ? null : _screen;

        internal Transform? Viewpoint
        {
            get
            {
                if (_viewpoint != null)
                    return _viewpoint;
                Camera camera = UnityEngine.Camera.main;
                return camera == null ? null : camera.transform;
            }
        }

        /// <summary>The camera that draws the picture on the screen; null where the viewpoint is none.</summary>
        internal Camera? Camera => Viewpoint is Transform viewpoint && viewpoint.GetComponent<Camera>() is Camera camera && camera != null ? camera : null;

        internal int HitLayers => _hitLayers;

        /// <summary>Queued: told in the next Update.</summary>
        internal void AddHealth(in HealthEvent health) => _health.Enqueue(health);

        /// <summary>Tells the Console now and the listeners in this or the next Update.</summary>
        private protected void Report(string text, bool isError, HealthKind kind = HealthKind.SetUp)
        {
            ShotEmitters.Log(this, text, isError);
            AddHealth(new HealthEvent { FrameIndex = -1, Kind = kind, Text = text });
        }

        private protected void RaiseHealth()
        {
            while (_health.Count > 0)
                Raise(HealthChanged, _healthChanged, _health.Dequeue());
        }

        /// <summary>Builds what casts shots, or says why there can be no hits.</summary>
        private protected void PrepareCasting()
        {
            _caster = null;
            Transform? viewpoint = Viewpoint;
            string kind = GetType().Name;
            if (Screen == null)
                Report(kind + " " + name + " has no screen: shots cannot hit anything; drag one in", false);
            else if (!_screen!.HasSize)
                Report("ScreenSurface " + _screen.name + ": a screen of " + _screen.SizeM + " m has no place for shots, so nothing can be hit; set the picture's width and height in metres", false);
            else if (viewpoint == null)
                Report(kind + " " + name + " has no viewpoint and the scene no main camera: shots cannot hit anything; drag a viewpoint in or tag the camera MainCamera", false);
            else
                _caster = new ShotCaster(_screen, viewpoint, _hitLayers, _aim);
        }

        /// <summary>Seconds to add to Unity's time for the scene's clock.</summary>
        private protected abstract double ClockOffsetS { get; }

        /// <summary>Called when everything has moved in this frame: shots fired at its picture go through this view.</summary>
        internal void RememberView() => _caster?.RememberView(Time.timeAsDouble + ClockOffsetS);

        /// <summary>Casts the shot and tells everybody.</summary>
        /// <param name="shot">Complete but for its hit.</param>
        /// <param name="sceneTimeS">When its light left, on the scene's clock.</param>
        private protected void Emit(ShotEvent shot, double sceneTimeS)
        {
            ShotTrace trace = default;
            bool isCast = _caster != null && shot.HasScreenPosition;
            if (isCast)
                trace = _caster!.Cast(ref shot, sceneTimeS);
            OnScored(shot);
            Raise(ShotFired, _shotFired, shot);
            if (!isCast)
                return;
            Raise(ShotTraced, null, trace);
            if (trace.Target != null)
                trace.Target.ReportHit(shot);
        }

        /// <summary>The shot is complete; nobody has been told yet.</summary>
        private protected virtual void OnScored(in ShotEvent shot)
        {
        }

        private protected void Raise<T>(Action<T>? listeners, UnityEvent<T>? unityEvent, in T what) => Raise(this, listeners, unityEvent, what);

        internal static void Raise<T>(UnityEngine.Object context, Action<T>? listeners, UnityEvent<T>? unityEvent, in T what)
        {
            try
            {
                listeners?.Invoke(what);
            }
            catch (Exception problem)
            {
                Debug.LogException(problem, context);
            }

            try
            {
                unityEvent?.Invoke(what);
            }
            catch (Exception problem)
            {
                Debug.LogException(problem, context);
            }
        }
    }
}
