using System;
using System.Net;
using LaserTracking.Geometry;
using LaserTracking.Remote;
using LaserTracking.Session;
using UnityEngine;

namespace LaserTracking.Unity
{
    /// <summary>
    /// Shots and poses of a detector in another program or on another machine, over UDP or through a file (Documentation~/remote.md).
    /// Listens while it is enabled; a background thread receives, the main thread drains in Update. Shots with a place on the screen, and published rays that
    /// meet it, are cast into the scene as it stood when their light left.
    /// </summary>
    [DisallowMultipleComponent]
    [AddComponentMenu("Laser Tracking/Remote Input")]
    public sealed class RemoteInput : ShotEmitter
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
        [Tooltip("File that a detector on this machine replaces again and again; read in place of the network, whose fields then do not count. A relative path begins in Unity's persistent data path. Empty: the network.")]
        private string _file = "";

        [SerializeField]
        [Tooltip("Camera 0 in the scene, looking along its z axis: the published message's rays start from it. Empty: published rays hit nothing.")]
        private Transform? _camera;

        [SerializeField]
        [Tooltip("Factors on the published message's axes, +1 or -1: y down becomes y up.")]
        private Vector3 _axisFlip = new Vector3(1, -1, 1);

        [SerializeField]
        [Range(0.01f, 1)]
        [Tooltip("Weight of the newest vector in the published mean. 1: not smoothed; published: 0.2, which lags by four messages.")]
        private float _smoothing = 1;

        [SerializeField]
        [Min(0)]
        [Tooltip("Seconds from the light to the arrival of the quickest message, about: camera, detector and network. A shot meets the targets as they stood then.")]
        private float _latencyS;

        private readonly WallClock _wall = new WallClock();
        private readonly RemoteClock _senderClock = new RemoteClock();
        private IDisposable? _receiver;
        private PublishedAim? _published;
        private bool _hasToldCamera;

        /// <summary>What came in; null while it does not listen. Poses are read here, shots are taken by this component.</summary>
        public RemoteInbox? Inbox { get; private set; }

        /// <summary>Where it listens; null while it does not, or watches a file.</summary>
        public IPEndPoint? EndPoint => (_receiver as RemoteReceiver)?.EndPoint;

        /// <summary>The newest published ray as it stands in the scene, smoothed, from the muzzle; false while there is none.</summary>
        public bool TryGetAim(out Ray ray)
        {
            ray = default;
            if (Inbox == null || _published == null || !Inbox.TryGetPose(out RemotePose pose) || !TryPlace(pose, out Vector3D muzzleM, out Vector2D screenM) || !muzzleM.IsFinite)
                return false;
            Vector3 from = Screen!.ScreenToWorld(muzzleM).ToUnity();
            ray = new Ray(from, Screen.ScreenToWorld(new Vector3D(screenM.X, screenM.Y, 0)).ToUnity() - from);
            return true;
        }

        private void OnEnable()
        {
            ShotEmitters.Add(this);
            try
            {
                _published = new PublishedAim(_axisFlip.ToCore(), _smoothing);
                if (_file.Length == 0)
                    Listen(new RemoteReceiver(ReadSettings(), _wall));
                else
                    Watch(new RemoteFileReceiver(UserPath.Under(Application.persistentDataPath, _file), new RemoteSettings(), _wall));
            }
            catch (Exception problem) when (problem is InputException || problem is ArgumentException)
            {
                Report("RemoteInput " + name + ": " + problem.Message, true);
            }
        }

        private void Listen(RemoteReceiver receiver)
        {
            _receiver = receiver;
            Inbox = receiver.Inbox;
        }

        private void Watch(RemoteFileReceiver receiver)
        {
            _receiver = receiver;
            Inbox = receiver.Inbox;
        }

        // Not in OnEnable: by now the main camera is awake, wherever it is.
        private void Start()
        {
            if (_receiver != null)
                PrepareCasting();
        }

        private void OnDisable()
        {
            _receiver?.Dispose();
            _receiver = null;
            Inbox = null;
            ShotEmitters.Remove(this);
        }

        private void Update()
        {
            if (Inbox != null)
                Drain(Inbox, _published!);
            RaiseHealth();
        }

        private void Drain(RemoteInbox inbox, PublishedAim aim)
        {
            while (inbox.TryTakeHealth(out HealthEvent health))
            {
                ShotEmitters.Log(this, health.Text, false);
                AddHealth(health);
            }

            while (inbox.TryTakeShot(out RemoteShot shot))
            {
                _senderClock.Add(shot.Event.Shot.TimeUs, shot.ReceivedTimeUs);
                if (!shot.Event.HasScreenPosition && IsPublished(shot.Aim))
                    Place(aim, ref shot);
                Emit(shot.Event, SceneTimeS(shot.Event.Shot.TimeUs));
            }

            if (inbox.TryGetPose(out RemotePose pose) && IsPublished(pose))
            {
                _senderClock.Add(pose.TimeUs, pose.ReceivedTimeUs);
                aim.Add(pose);
            }
        }

        private static bool IsPublished(in RemotePose pose) => pose.Space == RemoteSpace.CameraMm;

        private void Place(PublishedAim aim, ref RemoteShot shot)
        {
            aim.Add(shot.Aim);
            if (_camera == null && Screen != null && !_hasToldCamera)
            {
                _hasToldCamera = true;
                Report("RemoteInput " + name + ": a published ray has come, but where camera 0 stands is not known, so it cannot hit anything; drag its transform in", false);
            }

            if (!TryPlace(shot.Aim, out Vector3D muzzleM, out Vector2D screenM))
                return;
            shot.Event.HasScreenPosition = true;
            shot.Event.ScreenM = screenM;
            shot.Event.HasMuzzle = muzzleM.IsFinite;
            shot.Event.MuzzleM = muzzleM;
            shot.Event.Direction = (new Vector3D(screenM.X, screenM.Y, 0) - muzzleM).Normalized;
        }

        private bool TryPlace(in RemotePose pose, out Vector3D muzzleM, out Vector2D screenM)
        {
            muzzleM = default;
            screenM = default;
            return IsPublished(pose) && _camera != null && Screen != null
                && _published!.TryPlace(pose, _camera.WorldPose(), Screen.Pose, Screen.SizeM, out muzzleM, out screenM);
        }

        /// <summary>A range of the scene may have set the clock that the targets move by.</summary>
        private protected override double ClockOffsetS => MovingTargets.Count > 0 ? MovingTargets.At(0).ClockOffsetS : 0;

        /// <summary>When the light left, on the clock that the targets move by.</summary>
        private double SceneTimeS(long senderTimeUs) => Time.timeAsDouble + ClockOffsetS - _senderClock.AgeS(senderTimeUs, _wall.NowUs) - _latencyS;

        private RemoteSettings ReadSettings()
        {
            var senders = new IPAddress[_allowedSenders.Length];
            for (int i = 0; i < senders.Length; i++)
                senders[i] = Parse(_allowedSenders[i]);
            return new RemoteSettings
            {
                Address = Parse(_address),
                Port = _port,
                Key = _keyFile.Length == 0 ? null : RemoteKey.ReadFile(UserPath.Under("", _keyFile)),
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
