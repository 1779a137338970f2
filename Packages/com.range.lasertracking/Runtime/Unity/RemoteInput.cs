using System;
using System.Net;
using LaserTracking.Remote;
using LaserTracking.Scoring;
using LaserTracking.Session;
using UnityEngine;
using UnityEngine.Events;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Shots and poses of a detector in another program or on another machine, over UDP (Documentation~/remote.md). Listens while it
    /// is enabled; a background thread receives, the main thread drains in Update. Shots with a place on the screen are cast into the
    /// scene as it stands when they arrive.
    /// </summary>
    [DisallowMultipleComponent]
    [AddComponentMenu("Laser Tracking/Remote Input")]
    public sealed class RemoteInput : MonoBehaviour
    {
        [SerializeField]
        [Tooltip("Address to listen on. 127.0.0.1: only programs of this machine. Any other needs a key and a list of senders.")]
        private string _address = "127.0.0.1";

        [SerializeField]
        [Tooltip("UDP port.")]
        private int _port = RemoteSettings.DefaultPort;

        [SerializeField]
        [Tooltip("File with the key that the senders share, outside the project. Empty: packets are not signed.")]
        private string _keyFile = "";

        [SerializeField]
        [Tooltip("Addresses that may send. Empty: any program of this machine.")]
        private string[] _allowedSenders = new string[0];

        [SerializeField]
        [Tooltip("Screen that the shots land on.")]
        private ScreenSurface? _screen;

        [SerializeField]
        [Tooltip("Eye from which the picture on the screen is drawn, in front of the screen. Usually the camera.")]
        private Transform? _viewpoint;

        [SerializeField]
        [Tooltip("Layers that shots can hit.")]
        private LayerMask _hitLayers = ~0;

        [SerializeField]
        [Tooltip("Called for every shot, hit or miss.")]
        private UnityEvent<ShotEvent> _shotFired = new UnityEvent<ShotEvent>();

        private RemoteReceiver? _receiver;
        private PhysicsRaycaster? _raycaster;
        private ShotScorer? _scorer;

        /// <summary>Raised on the main thread for every shot, hit or miss, in order of arrival.</summary>
        public event Action<ShotEvent>? ShotFired;

        /// <summary>What came in; null while it does not listen. Poses are read here, shots are taken by this component.</summary>
        public RemoteInbox? Inbox => _receiver?.Inbox;

        /// <summary>Where it listens; null while it does not.</summary>
        public IPEndPoint? EndPoint => _receiver?.EndPoint;

        private void OnEnable()
        {
            try
            {
                _receiver = new RemoteReceiver(ReadSettings(), new WallClock());
            }
            catch (Exception problem) when (problem is InputException || problem is ArgumentException)
            {
                Debug.LogError("RemoteInput " + name + ": " + problem.Message, this);
            }
        }

        private void OnDisable()
        {
            _receiver?.Dispose();
            _receiver = null;
            _scorer = null;
        }

        private void Update()
        {
            if (_receiver == null)
                return;
            RemoteInbox inbox = _receiver.Inbox;
            while (inbox.TryTakeHealth(out HealthEvent health))
                Debug.LogWarning(health.Text, this);
            while (inbox.TryTakeShot(out RemoteShot shot))
                Raise(shot.Event);
        }

        private void Raise(ShotEvent shot)
        {
            if (_scorer == null && _screen != null && _viewpoint != null)
            {
                _raycaster = new PhysicsRaycaster(_hitLayers);
                _scorer = new ShotScorer(_raycaster, _screen.Pose, _screen.SizeM, _viewpoint.position.ToCore());
            }

            if (_scorer != null && shot.HasScreenPosition)
                shot.HasHit = _scorer.TryScore(shot.ScreenM, shot.ScreenCovarianceMm2, shot.Shot.Dot.Confidence, null, Time.timeAsDouble, out shot.Hit);
            ShotFired?.Invoke(shot);
            _shotFired.Invoke(shot);
            if (shot.HasHit && _raycaster!.TryFindTarget(shot.Hit.Target, out LaserTarget? target))
                target!.ReportHit(shot);
        }

        private RemoteSettings ReadSettings()
        {
            var senders = new IPAddress[_allowedSenders.Length];
            for (int i = 0; i < senders.Length; i++)
                senders[i] = Parse(_allowedSenders[i]);
            return new RemoteSettings
            {
                Address = Parse(_address),
                Port = _port,
                Key = _keyFile.Length == 0 ? null : RemoteKey.ReadFile(_keyFile),
                AllowedSenders = senders,
            };
        }

        private static IPAddress Parse(string text) =>
            IPAddress.TryParse(text, out IPAddress? address) ? address : throw new InputException("\"" + text + "\"", "this is no address", "write it like 192.168.7.20");

        private sealed class WallClock : IClock
        {
            public long NowUs => (DateTime.UtcNow - DateTime.UnixEpoch).Ticks / 10;
        }
    }
}
