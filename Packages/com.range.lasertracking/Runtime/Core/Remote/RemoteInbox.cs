using System;
using LaserTracking.Session;

namespace LaserTracking.Remote
{
    /// <summary>
    /// What came in and waits for its consumer: the newest pose of each hand, every shot in order, what was dropped and why. Filled by
    /// a background thread, emptied by any other; each call holds one lock for a moment. Nothing is allocated after construction.
    /// </summary>
    public sealed class RemoteInbox
    {
        /// <summary>Hands whose poses are kept; a further one takes the place of the oldest.</summary>
        public const int PoseCapacity = 8;

        private readonly object _lock = new object();
        private readonly RemoteShot[] _shots;
        private readonly RemotePose[] _poses = new RemotePose[PoseCapacity];
        private readonly long[] _drops = new long[RemoteDropText.Count];
        private readonly bool[] _isTold = new bool[RemoteDropText.Count];
        private int _firstShot;
        private int _shotCount;
        private int _poseCount;
        private int _newestPose = -1;
        private long _accepted;
        private long _lastDropUs;

        /// <param name="shotCapacity">Shots that may wait, at least 1.</param>
        public RemoteInbox(int shotCapacity)
        {
            _shots = new RemoteShot[Math.Max(1, shotCapacity)];
        }

        /// <summary>Messages used so far, repeated shots included.</summary>
        public long Accepted
        {
            get
            {
                lock (_lock)
                    return _accepted;
            }
        }

        /// <summary>How many were dropped for this reason.</summary>
        public long Dropped(RemoteDrop reason)
        {
            lock (_lock)
                return _drops[(int)reason];
        }

        /// <summary>The next shot in order of arrival.</summary>
        public bool TryTakeShot(out RemoteShot shot)
        {
            lock (_lock)
            {
                shot = default;
                if (_shotCount == 0)
                    return false;
                shot = _shots[_firstShot];
                _firstShot = (_firstShot + 1) % _shots.Length;
                _shotCount--;
                return true;
            }
        }

        /// <summary>The newest pose of any hand; it stays until a newer one comes, so look at its times.</summary>
        public bool TryGetPose(out RemotePose pose)
        {
            lock (_lock)
            {
                pose = _newestPose < 0 ? default : _poses[_newestPose];
                return _newestPose >= 0;
            }
        }

        /// <summary>The newest pose of every hand, in no particular order; returns how many there are.</summary>
        /// <param name="poses">Room for <see cref="PoseCapacity"/>, or fewer.</param>
        public int CopyPoses(Span<RemotePose> poses)
        {
            lock (_lock)
            {
                int count = Math.Min(_poseCount, poses.Length);
                new ReadOnlySpan<RemotePose>(_poses, 0, count).CopyTo(poses);
                return count;
            }
        }

        /// <summary>
        /// One message for the operator for each reason why packets were dropped, once; its value is how many there were until now.
        /// </summary>
        public bool TryTakeHealth(out HealthEvent health)
        {
            lock (_lock)
            {
                health = default;
                for (int i = 1; i < _drops.Length; i++)
                {
                    if (_drops[i] == 0 || _isTold[i])
                        continue;
                    _isTold[i] = true;
                    health.Kind = HealthKind.Remote;
                    health.TimeUs = _lastDropUs;
                    health.Value = _drops[i];
                    health.Text = RemoteDropText.Of((RemoteDrop)i);
                    return true;
                }

                return false;
            }
        }

        internal void CountAccepted()
        {
            lock (_lock)
                _accepted++;
        }

        internal void Count(RemoteDrop reason, long nowUs)
        {
            lock (_lock)
            {
                _drops[(int)reason]++;
                _lastDropUs = nowUs;
            }
        }

        /// <summary>False, and counted, when there is no room.</summary>
        internal bool TryAddShot(in RemoteShot shot)
        {
            lock (_lock)
            {
                if (_shotCount == _shots.Length)
                {
                    _drops[(int)RemoteDrop.QueueFull]++;
                    _lastDropUs = shot.ReceivedTimeUs;
                    return false;
                }

                _shots[(_firstShot + _shotCount) % _shots.Length] = shot;
                _shotCount++;
                return true;
            }
        }

        internal void SetPose(in RemotePose pose)
        {
            lock (_lock)
            {
                int at = 0, oldest = 0;
                while (at < _poseCount && (_poses[at].TrackId != pose.TrackId || _poses[at].Space != pose.Space))
                {
                    if (_poses[at].ReceivedTimeUs < _poses[oldest].ReceivedTimeUs)
                        oldest = at;
                    at++;
                }

                if (at == PoseCapacity)
                    at = oldest;
                else if (at == _poseCount)
                    _poseCount++;
                _poses[at] = pose;
                _newestPose = at;
            }
        }
    }
}
