using System;
using System.Net;
using System.Net.Sockets;
using System.Threading;
using LaserTracking.Session;

namespace LaserTracking.Remote
{
    /// <summary>
    /// Sends shots and poses to a <see cref="RemoteReceiver"/>. UDP loses packets, so each shot goes out three times within 60 ms (the
    /// receiver takes one); of poses the next one replaces what was lost. Keeps below the receiver's limit: poses are left out
    /// first, shots wait. Calls come from any thread and never wait for the network. No allocation once warm.
    /// </summary>
    public sealed class RemoteSender : IRemoteSender
    {
        private const int PacketsPerSecond = 450; // a little below what a receiver takes: packets bunch up on the way
        private const int PosesPerSecond = 200;
        private const int Capacity = 1024;
        private const int LongestWaitMs = 1000;

        private static readonly long[] CopyDelaysUs = { 0, 20_000, 60_000 };

        private readonly object _lock = new object();
        private readonly Waiting[] _waiting = new Waiting[Capacity];
        private readonly RateWindow _packets = new RateWindow(PacketsPerSecond);
        private readonly RateWindow _poses = new RateWindow(PosesPerSecond);
        private readonly MessageWriter _writer;
        private readonly IClock _clock;
        private readonly Socket _socket;
        private readonly byte[] _buffer = new byte[65536];
        private readonly Thread _thread;
        private int _count;
        private bool _stops;
        private long _lost;
        private long _failed;

        /// <param name="receiver">Where to.</param>
        /// <param name="key">The receiver's; null: the packets are not signed.</param>
        /// <param name="clock">The wall clock.</param>
        /// <exception cref="InputException">There is no way there.</exception>
        public RemoteSender(IPEndPoint receiver, RemoteKey? key, IClock clock)
        {
            _clock = clock;
            _socket = new Socket(receiver.AddressFamily, SocketType.Dgram, ProtocolType.Udp);
            try
            {
                _socket.Connect(receiver);
            }
            catch (SocketException)
            {
                _socket.Dispose();
                throw new InputException(receiver.ToString(), "cannot be reached", "check address, port and network");
            }

            _socket.Blocking = false;
            _writer = new MessageWriter(key);
            _thread = new Thread(SendShots) { IsBackground = true, Name = "remote sender" };
            _thread.Start();
        }

        public long LostShots => Interlocked.Read(ref _lost);

        public long Failures => Interlocked.Read(ref _failed);

        public void SendShot(in ShotEvent shot)
        {
            lock (_lock)
            {
                if (_count == Capacity)
                {
                    _lost++;
                    return;
                }

                _waiting[_count++] = new Waiting { Shot = shot, QueuedUs = _clock.NowUs };
                Monitor.PulseAll(_lock);
            }
        }

        /// <summary>Sends a hand now, or not at all when there were many in the last second.</summary>
        public void SendHand(in HandEvent hand)
        {
            lock (_lock)
            {
                long nowUs = _clock.NowUs;
                if (TakePose(nowUs))
                    Send(_writer.Hand(hand, nowUs));
            }
        }

        /// <summary>Sends the published message now; a pose may be left out, a shot is not repeated.</summary>
        public void SendPublished(in RemotePose pose, bool isShot)
        {
            lock (_lock)
            {
                long nowUs = _clock.NowUs;
                if (isShot ? _packets.TryTake(nowUs) : TakePose(nowUs))
                    Send(_writer.Published(pose, isShot, nowUs));
            }
        }

        /// <summary>Sends what still waits, which takes some 60 ms, and ends. May be called again.</summary>
        public void Dispose()
        {
            lock (_lock)
            {
                _stops = true;
                Monitor.PulseAll(_lock);
            }

            _thread.Join();
            _socket.Dispose();
            _writer.Dispose();
        }

        private bool TakePose(long nowUs) => _packets.IsOpen(nowUs) && _poses.TryTake(nowUs) && _packets.TryTake(nowUs);

        private void SendShots()
        {
            lock (_lock)
            {
                while (_count > 0 || !_stops)
                {
                    long waitUs = SendDue(_clock.NowUs);
                    if (_count > 0 || !_stops)
                        Monitor.Wait(_lock, (int)Math.Min(LongestWaitMs, 1 + waitUs / 1000));
                }
            }
        }

        /// <summary>Sends every copy whose time has come, as far as the limit allows; returns the time to the next one.</summary>
        private long SendDue(long nowUs)
        {
            long waitUs = long.MaxValue;
            int kept = 0;
            for (int i = 0; i < _count; i++)
            {
                ref Waiting waiting = ref _waiting[i];
                long dueUs = waiting.QueuedUs + CopyDelaysUs[waiting.Sent];
                // A clock that was set back must not hold shots up.
                bool isDue = dueUs <= nowUs || dueUs > nowUs + LongestWaitMs * 1000;
                if (isDue && _packets.TryTake(nowUs))
                {
                    Send(_writer.Shot(waiting.Shot, nowUs));
                    waiting.Sent++;
                }

                if (waiting.Sent == CopyDelaysUs.Length)
                    continue;
                waitUs = Math.Min(waitUs, Math.Max(1000, waiting.QueuedUs + CopyDelaysUs[waiting.Sent] - nowUs));
                if (kept != i)
                    _waiting[kept] = waiting;
                kept++;
            }

            _count = kept;
            return waitUs;
        }

        private void Send(ReadOnlySpan<byte> packet)
        {
            try
            {
                packet.CopyTo(_buffer);
                _socket.Send(_buffer, 0, packet.Length, SocketFlags.None);
            }
            catch (SocketException)
            {
                // Nobody listens, or the network's queue is full: the next packet may get through.
                _failed++;
            }
        }

        private struct Waiting
        {
            public ShotEvent Shot;
            public long QueuedUs;
            public int Sent;
        }
    }
}
