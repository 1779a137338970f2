using System;
using System.Collections.Generic;
using System.Diagnostics;
using System.Linq;
using System.Net;
using System.Net.Sockets;
using System.Security.Cryptography;
using System.Text;
using System.Threading;
using LaserTracking.Host.Remote;
using LaserTracking.Remote;
using LaserTracking.Session;

namespace LaserTracking.Host.Studies
{
    /// <summary>
    /// A genuine sender (10 shots and 60 poses a second, signed) against a hostile one on the same port. A relay between them records
    /// the genuine packets, so that the hostile one can replay them. Runs over 127.0.0.1 in real time.
    /// </summary>
    internal sealed class RemoteFloodStudy : IStudy
    {
        private const int HostilePerSecond = 5000;
        private const int FloodS = 30;

        public string Name => "remote-flood";

        public string What => "remote input under 5,000 hostile packets a second for 30 s: shots lost, age of the pose, memory (real time, 127.0.0.1)";

        public StudyTable Run(StudyOptions options, CancellationToken interrupted)
        {
            var clock = new WallClock();
            RemoteKey key = RemoteKey.Parse(Convert.ToHexString(RandomNumberGenerator.GetBytes(32)), "key");
            using var receiver = new RemoteReceiver(new RemoteSettings { Port = 0, Key = key }, clock);
            using var tap = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
            tap.Bind(new IPEndPoint(IPAddress.Loopback, 0));
            using var sender = new RemoteSender((IPEndPoint)tap.LocalEndPoint!, key, clock);
            using var ended = new CancellationTokenSource();
            byte[] recorded = Encoding.UTF8.GetBytes("{}");
            var relay = new Thread(() => Relay(tap, receiver.EndPoint, ended.Token, packet => Volatile.Write(ref recorded, packet)));
            relay.Start();
            long hostilePackets = 0;
            var hostile = new Thread(() => hostilePackets = Flood(receiver.EndPoint, () => Volatile.Read(ref recorded), ended.Token));
            hostile.Start();

            var ids = new List<int>();
            var agesMs = new List<double>();
            var watch = Stopwatch.StartNew();
            long memoryFirst = 0, memoryLast = 0;
            int shots = 0;
            for (int frame = 1; watch.Elapsed.TotalSeconds < FloodS && !interrupted.IsCancellationRequested; frame++)
            {
                if (frame % 6 == 0)
                    sender.SendShot(Shot(++shots));
                sender.SendHand(new HandEvent { TimeUs = frame, PalmM = new Geometry.Vector3D(1, 1, -2), MuzzleM = new Geometry.Vector3D(1, 1, -2) });
                Thread.Sleep(16);
                Drain(receiver.Inbox, ids);
                if (frame > 10 && receiver.Inbox.TryGetPose(out RemotePose pose))
                    agesMs.Add((clock.NowUs - pose.ReceivedTimeUs) / 1000.0);
                // From the third second on everything is warm.
                if (memoryFirst == 0 && watch.Elapsed.TotalSeconds > 3)
                    memoryFirst = GC.GetTotalMemory(true);
                options.Progress.Show(FormattableString.Invariant($"{watch.Elapsed.TotalSeconds:F0} of {FloodS} s"));
            }

            memoryLast = GC.GetTotalMemory(true);
            double seconds = watch.Elapsed.TotalSeconds;
            Thread.Sleep(200);
            Drain(receiver.Inbox, ids);
            ended.Cancel();
            hostile.Join();
            relay.Join();
            return Table(receiver.Inbox, hostilePackets / seconds, shots, ids, agesMs, memoryLast - memoryFirst);
        }

        private static StudyTable Table(RemoteInbox inbox, double hostilePerSecond, int shots, List<int> ids, List<double> agesMs, long grownBytes)
        {
            agesMs.Sort();
            var table = new StudyTable("Remote input under a hostile flood, 127.0.0.1", "what", "value");
            table.Add("hostile packets a second", hostilePerSecond);
            table.Add("genuine shots sent", shots);
            table.Add("genuine shots lost", shots - ids.Distinct().Count());
            table.Add("shots that nobody genuine fired, or twice", ids.Count - ids.Distinct().Count(id => id >= 1 && id <= shots));
            table.Add("age of the pose, median ms", agesMs[agesMs.Count / 2]);
            table.Add("age of the pose, 99 % ms", agesMs[agesMs.Count * 99 / 100]);
            table.Add("age of the pose, largest ms", agesMs[^1]);
            table.Add("memory grown from second 3 on, kB", grownBytes / 1024.0);
            foreach (RemoteDrop reason in Enum.GetValues<RemoteDrop>().Where(reason => inbox.Dropped(reason) > 0))
                table.Add("dropped: " + reason, (double)inbox.Dropped(reason));
            while (inbox.TryTakeHealth(out HealthEvent health))
                table.Notes.Add(health.Text);
            return table;
        }

        private static ShotEvent Shot(int id)
        {
            ShotEvent shot = default;
            shot.Shot.Id = id;
            shot.Shot.Dot.Confidence = 1;
            shot.HasScreenPosition = true;
            shot.ScreenM = new Geometry.Vector2D(1, 1);
            return shot;
        }

        private static void Drain(RemoteInbox inbox, List<int> ids)
        {
            while (inbox.TryTakeShot(out RemoteShot shot))
                ids.Add(shot.Event.Shot.Id);
        }

        private static void Relay(Socket tap, IPEndPoint receiver, CancellationToken ended, Action<byte[]> record)
        {
            var buffer = new byte[4096];
            while (!ended.IsCancellationRequested)
            {
                if (!tap.Poll(20_000, SelectMode.SelectRead))
                    continue;
                int length = tap.Receive(buffer);
                tap.SendTo(buffer, 0, length, SocketFlags.None, receiver);
                record(buffer.AsSpan(0, length).ToArray());
            }
        }

        /// <summary>Seven kinds of packets in turn; returns how many were sent.</summary>
        private static long Flood(IPEndPoint receiver, Func<byte[]> recorded, CancellationToken ended)
        {
            byte[] shot = Encoding.UTF8.GetBytes("{\"v\":1,\"stream\":9,\"counter\":1,\"sent_us\":1,\"type\":\"shot\",\"id\":900001,\"time_us\":1,\"confidence\":1,\"screen_m\":[1,1]}");
            byte[] forged = Encoding.UTF8.GetBytes(Encoding.UTF8.GetString(shot) + "\n" + new string('0', 64));
            byte[] garbage = RandomNumberGenerator.GetBytes(700), huge = new byte[9000];
            byte[] old = recorded();
            using var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp);
            var watch = Stopwatch.StartNew();
            long sent = 0;
            while (!ended.IsCancellationRequested)
            {
                for (; sent < watch.Elapsed.TotalSeconds * HostilePerSecond; sent++)
                {
                    byte[] last = recorded();
                    if (sent % HostilePerSecond == 0)
                        old = last;
                    byte[] changed = (byte[])last.Clone();
                    changed[sent % changed.Length] ^= 1;
                    socket.SendTo((sent % 7) switch { 0 => shot, 1 => forged, 2 => garbage, 3 => huge, 4 => last, 5 => old, _ => changed }, receiver);
                }

                Thread.Sleep(1);
            }

            return sent;
        }
    }
}
