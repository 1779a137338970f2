using System;
using System.Threading;
using LaserTracking.Session;

namespace LaserTracking.Remote
{
    /// <summary>
    /// Sends shots and poses through a file that a <see cref="RemoteFileReceiver"/> of this machine watches. Only the newest content
    /// is ever seen, so each shot stays in it for 200 ms, forty looks of the receiver; of poses the newest of each hand. A thread of its own
    /// replaces the file at most every 10 ms. One sender a file.
    /// </summary>
    public sealed class RemoteFileSender : IRemoteSender
    {
        private const int Capacity = 1024;
        private const int MostShots = 24; // with the poses below what a receiver takes in a second, and within its window of 64
        private const int MostHands = 8;
        private const int PosesPerSecond = 150;
        private const int WriteMs = 10;
        private const long StayUs = 200_000; // less than the age at which a message is stale
        private const long PatienceUs = 1_000_000;

        private readonly object _lock = new object();
        private readonly Message[] _waiting = new Message[Capacity];
        private readonly Line[] _shots = new Line[MostShots];
        private readonly Message[] _hands = new Message[MostHands];
        private readonly Line[] _handLines = new Line[MostHands];
        private readonly RateWindow _poses = new RateWindow(PosesPerSecond);
        private readonly MessageWriter _writer = new MessageWriter(null, true);
        private readonly byte[] _content = new byte[32768];
        private readonly string _path;
        private readonly IClock _clock;
        private readonly Thread _thread;
        private int _waitingCount;
        private int _shotCount;
        private int _handCount;
        private bool _stops;
        private long _lost;
        private long _failures;

        /// <param name="path">In a folder that exists; replaced.</param>
        /// <param name="clock">The wall clock.</param>
        /// <exception cref="InputException">It cannot be written.</exception>
        public RemoteFileSender(string path, IClock clock)
        {
            _path = path;
            _clock = clock;
            RemoteFile.Write(path, ReadOnlySpan<byte>.Empty);
            for (int i = 0; i < MostShots; i++)
                _shots[i].Bytes = new byte[1024];
            for (int i = 0; i < MostHands; i++)
                _handLines[i].Bytes = new byte[1024];
            _thread = new Thread(WriteAll) { IsBackground = true, Name = "remote file sender" };
            _thread.Start();
        }

        public long LostShots => Interlocked.Read(ref _lost);

        public long Failures => Interlocked.Read(ref _failures);

        public void SendShot(in ShotEvent shot) => Queue(new Message { Shot = shot });

        public void SendHand(in HandEvent hand) => SetPose(new Message { Hand = hand, Track = hand.TrackId, IsNew = true });

        public void SendPublished(in RemotePose pose, bool isShot)
        {
            var message = new Message { Published = pose, IsPublished = true, Track = -1, IsNew = true };
            if (isShot)
                Queue(message);
            else
                SetPose(message);
        }

        /// <summary>Writes what still waits, leaves it there for 200 ms, empties the file and ends. May be called again.</summary>
        public void Dispose()
        {
            lock (_lock)
            {
                _stops = true;
                Monitor.PulseAll(_lock);
            }

            _thread.Join();
            _writer.Dispose();
        }

        private void Queue(in Message message)
        {
            lock (_lock)
            {
                if (_waitingCount == Capacity)
                {
                    _lost++;
                    return;
                }

                _waiting[_waitingCount] = message;
                _waiting[_waitingCount++].QueuedUs = _clock.NowUs;
                Monitor.PulseAll(_lock);
            }
        }

        private void SetPose(in Message message)
        {
            lock (_lock)
            {
                long nowUs = _clock.NowUs;
                if (!_poses.TryTake(nowUs))
                    return;
                int at = 0, oldest = 0;
                for (; at < _handCount && _hands[at].Track != message.Track; at++)
                {
                    if (_hands[at].QueuedUs < _hands[oldest].QueuedUs)
                        oldest = at;
                }

                if (at == MostHands)
                    at = oldest;
                else if (at == _handCount)
                    _handCount++;
                _hands[at] = message;
                _hands[at].QueuedUs = nowUs;
                Monitor.PulseAll(_lock);
            }
        }

        private void WriteAll()
        {
            while (true)
            {
                int length, taken;
                lock (_lock)
                {
                    while (!_stops && _waitingCount == 0 && !HasNewPose())
                        Monitor.Wait(_lock);
                    if (_waitingCount == 0 && !HasNewPose())
                        break;
                    length = Compose(_clock.NowUs, out taken);
                }

                bool isWritten = TryWrite(length);
                lock (_lock)
                    Settle(isWritten, taken, _clock.NowUs);
                Thread.Sleep(WriteMs);
            }

            // What stays behind would be stale for the next reader, and reported.
            Thread.Sleep((int)(StayUs / 1000));
            TryWrite(0);
        }

        private bool HasNewPose()
        {
            for (int i = 0; i < _handCount; i++)
            {
                if (_hands[i].IsNew)
                    return true;
            }

            return false;
        }

        /// <summary>The file's next content: shots that stay, shots that are new, the newest pose of each hand that was seen of late.</summary>
        private int Compose(long nowUs, out int taken)
        {
            DropOldShots(nowUs);
            taken = Math.Min(_waitingCount, MostShots - _shotCount);
            for (int i = 0; i < taken; i++)
            {
                ref Message message = ref _waiting[i];
                _shots[_shotCount + i].Set(message.IsPublished ? _writer.Published(message.Published, true, nowUs) : _writer.Shot(message.Shot, nowUs), nowUs);
            }

            int length = 0;
            for (int i = 0; i < _shotCount + taken; i++)
                Append(_shots[i], ref length);
            for (int i = 0; i < _handCount; i++)
            {
                ref Message hand = ref _hands[i];
                if (hand.IsNew)
                    _handLines[i].Set(hand.IsPublished ? _writer.Published(hand.Published, false, nowUs) : _writer.Hand(hand.Hand, nowUs), nowUs);
                if (nowUs - hand.QueuedUs <= StayUs)
                    Append(_handLines[i], ref length);
                hand.IsNew = false;
            }

            return length;
        }

        private void DropOldShots(long nowUs)
        {
            int kept = 0;
            for (int i = 0; i < _shotCount; i++)
            {
                // A clock that was set back must not keep shots for ever.
                if (Math.Abs(nowUs - _shots[i].WrittenUs) > StayUs)
                    continue;
                (_shots[kept], _shots[i]) = (_shots[i], _shots[kept]);
                kept++;
            }

            _shotCount = kept;
        }

        private bool TryWrite(int length)
        {
            try
            {
                RemoteFile.Write(_path, new ReadOnlySpan<byte>(_content, 0, length));
                return true;
            }
            catch (InputException)
            {
                return false;
            }
        }

        /// <summary>Shots that were written need not wait any more; others are tried again for a second.</summary>
        private void Settle(bool isWritten, int taken, long nowUs)
        {
            if (isWritten)
            {
                _shotCount += taken;
            }
            else
            {
                _failures++;
                int hopeless = 0;
                while (hopeless < _waitingCount && (_stops || Math.Abs(nowUs - _waiting[hopeless].QueuedUs) > PatienceUs))
                    hopeless++;
                _lost += hopeless;
                taken = hopeless;
            }

            Array.Copy(_waiting, taken, _waiting, 0, _waitingCount - taken);
            _waitingCount -= taken;
        }

        private void Append(in Line line, ref int length)
        {
            if (length + line.Length + 1 > _content.Length)
                return;
            new ReadOnlySpan<byte>(line.Bytes, 0, line.Length).CopyTo(new Span<byte>(_content, length, line.Length));
            length += line.Length;
            _content[length++] = (byte)'\n';
        }

        private struct Message
        {
            public ShotEvent Shot;
            public HandEvent Hand;
            public RemotePose Published;
            public bool IsPublished;
            public int Track;
            public bool IsNew;
            public long QueuedUs;
        }

        private struct Line
        {
            public byte[] Bytes;
            public int Length;
            public long WrittenUs;

            public void Set(ReadOnlySpan<byte> text, long nowUs)
            {
                if (text.Length > Bytes.Length)
                    Bytes = new byte[2 * text.Length];
                text.CopyTo(Bytes);
                Length = text.Length;
                WrittenUs = nowUs;
            }
        }
    }
}
