using System;
using System.Net;
using System.Net.Sockets;
using System.Threading;

namespace LaserTracking.Remote
{
    /// <summary>
    /// Listens for UDP packets of remote detectors on a thread of its own, from construction to <see cref="Dispose"/>. What it makes
    /// of them lies in <see cref="Inbox"/>. The packets' memory is used again; only the socket's own calls leave a little garbage.
    /// </summary>
    public sealed class RemoteReceiver : IDisposable
    {
        private const int LargestPacketBytes = 65536;
        private const int SocketBufferBytes = 4 << 20;
        private const int PollUs = 50_000;

        private readonly Socket _socket;
        private readonly RemoteGate _gate;
        private readonly IClock _clock;
        private readonly Thread _thread;
        private volatile bool _stops;

        /// <param name="settings">Not changed any more.</param>
        /// <param name="clock">The wall clock.</param>
        /// <exception cref="ArgumentException">A setting is outside its range.</exception>
        /// <exception cref="InputException">It may not or cannot listen there; the message says what to do.</exception>
        public RemoteReceiver(RemoteSettings settings, IClock clock)
        {
            settings.Validate();
            _clock = clock;
            Inbox = new RemoteInbox(settings.ShotCapacity);
            _gate = new RemoteGate(settings, Inbox);
            _socket = new Socket(settings.Address.AddressFamily, SocketType.Dgram, ProtocolType.Udp);
            try
            {
                _socket.ReceiveBufferSize = SocketBufferBytes;
                _socket.Bind(new IPEndPoint(settings.Address, settings.Port));
            }
            catch (SocketException)
            {
                _socket.Dispose();
                _gate.Dispose();
                throw new InputException("remote input on " + settings.Address + " port " + settings.Port, "cannot listen there",
                    "close the program that uses the port, or give another address or port");
            }

            EndPoint = (IPEndPoint)_socket.LocalEndPoint!;
            _thread = new Thread(Receive) { IsBackground = true, Name = "remote input", Priority = ThreadPriority.AboveNormal };
            _thread.Start();
        }

        /// <summary>Where it listens; with its real port where any was asked for.</summary>
        public IPEndPoint EndPoint { get; }

        public RemoteInbox Inbox { get; }

        /// <summary>Stops listening and waits for the thread; the inbox stays as it is.</summary>
        public void Dispose()
        {
            _stops = true;
            _thread.Join();
            _socket.Dispose();
            _gate.Dispose();
        }

        // Polls with a limit: closing a socket under a waiting thread hangs on some platforms.
        private void Receive()
        {
            var buffer = new byte[LargestPacketBytes];
            EndPoint sender = new IPEndPoint(_socket.AddressFamily == AddressFamily.InterNetworkV6 ? IPAddress.IPv6Any : IPAddress.Any, 0);
            while (!_stops)
            {
                try
                {
                    if (!_socket.Poll(PollUs, SelectMode.SelectRead))
                        continue;
                    int length = _socket.ReceiveFrom(buffer, 0, buffer.Length, SocketFlags.None, ref sender);
                    _gate.Accept(new ReadOnlySpan<byte>(buffer, 0, length), (IPEndPoint)sender, _clock.NowUs);
                }
                catch (SocketException)
                {
                    // Windows reports here what became of packets that others sent; the socket goes on.
                    Inbox.Count(RemoteDrop.Failed, _clock.NowUs);
                    Thread.Sleep(1);
                }
            }
        }
    }
}
