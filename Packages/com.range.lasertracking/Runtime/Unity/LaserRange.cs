using System;
using LaserTracking.Session;
using UnityEngine;
using UnityEngine.Events;

namespace LaserTracking.Unity
{
    /// <summary>
    /// The range itself: reads frames, finds shots in them, casts them through the screen into the scene and tells who wants to
    /// know. Before other components, so that targets move by the clock it sets.
    /// </summary>
    [DisallowMultipleComponent]
    [DefaultExecutionOrder(-100)]
    [AddComponentMenu("Laser Tracking/Laser Range")]
    public sealed class LaserRange : MonoBehaviour
    {
        [SerializeField]
        private ScreenSurface? _screen;

        [SerializeField]
        [Tooltip("Eye from which the picture on the screen is drawn, in front of the screen. Usually the camera.")]
        private Transform? _viewpoint;

        [SerializeField]
        [Tooltip("Layers that shots can hit.")]
        private LayerMask _hitLayers = ~0;

        [SerializeField]
        [Tooltip("Where the frames of camera 0, the one that sees the screen, come from.")]
        private FrameSourceAsset? _source;

        [SerializeField]
        [Tooltip("Called for every shot, hit or miss.")]
        private UnityEvent<ShotEvent> _shotFired = new UnityEvent<ShotEvent>();

        /// <summary>Raised on the main thread for every shot, hit or miss, in the order of the shots.</summary>
        public event Action<ShotEvent>? ShotFired;
    }
}
