using System;
using System.Collections.Generic;
using System.Linq;
using System.Net;
using System.Net.Sockets;
using System.Threading;
using LaserTracking.Session;
using NUnit.Framework;

namespace LaserTracking.Remote
{
    /// <summary>Sender and receiver over this machine's own network.</summary>
    public sealed class RemoteLoopbackTests
    {
        private const int PatienceMs = 5000;

        private static RemoteReceiver Listen(RemoteKey? key = null) => new RemoteReceiver(new RemoteSettings { Port = 0, Key = key }, new WallClock());

        private static List<int> TakeShots(RemoteInbox inbox, int count)
        {
            var ids = new List<int>();
            for (int waited = 0; ids.Count < count && waited < PatienceMs; waited++)
            {
                while (inbox.TryTakeShot(out RemoteShot shot))
                    ids.Add(shot.Event.Shot.Id);
                if (ids.Count < count)
                    Thread.Sleep(1);
            }

            return ids;
        }

        [TestCase(false)]
        [TestCase(true)]
        public void Sender_ShotsInABurst_AllArriveOnceInOrder(bool isSigned)
        {
            RemoteKey? key = isSigned ? RemoteExamples.Key : null;
            using (RemoteReceiver receiver = Listen(key))
            {
                using (var sender = new RemoteSender(receiver.EndPoint, key, new WallClock()))
                {
                    for (int id = 1; id <= 60; id++)
                        sender.SendShot(EventExamples.PlainShot(id, id));
                }

                Assert.That(TakeShots(receiver.Inbox, 60), Is.EqualTo(Enumerable.Range(1, 60)));
                for (int waited = 0; receiver.Inbox.Accepted < 180 && waited < PatienceMs; waited++)
                    Thread.Sleep(1);
                Assert.That(receiver.Inbox.Accepted, Is.EqualTo(180), "three copies each");
                Assert.That(receiver.Inbox.TryTakeShot(out _), Is.False);
                Assert.That(receiver.Inbox.TryTakeHealth(out HealthEvent health), Is.False, health.Text);
            }
        }

        [Test]
        public void Sink_HandsOfAPipeline_GiveTheNewestPose()
        {
            using (RemoteReceiver receiver = Listen())
            using (var sender = new RemoteSender(receiver.EndPoint, null, new WallClock()))
            {
                var sink = new RemoteEventSink(sender);
                sink.OnHand(EventExamples.Hand(1, 1000));
                sink.OnHand(EventExamples.Hand(2, 2000));
                RemotePose pose = default;
                for (int waited = 0; pose.TimeUs != 2000 && waited < PatienceMs; waited++)
                {
                    receiver.Inbox.TryGetPose(out pose);
                    Thread.Sleep(1);
                }

                Assert.That(pose.TimeUs, Is.EqualTo(2000));
            }
        }

        [Test]
        [Category("Long")]
        public void Receiver_HostileFlood_LosesNoShotAndKeepsThePoseFresh()
        {
            var clock = new WallClock();
            using (RemoteReceiver receiver = Listen(RemoteExamples.Key))
            using (var sender = new RemoteSender(receiver.EndPoint, RemoteExamples.Key, clock))
            {
                bool stops = false;
                var hostile = new Thread(() => Flood(receiver.EndPoint, ref stops));
                hostile.Start();
                var ids = new List<int>();
                var agesUs = new List<long>();
                for (int step = 1; step <= 100; step++)
                {
                    if (step % 10 == 0)
                        sender.SendShot(EventExamples.PlainShot(step / 10, step));
                    sender.SendHand(EventExamples.Hand(step, step));
                    Thread.Sleep(10);
                    while (receiver.Inbox.TryTakeShot(out RemoteShot shot))
                        ids.Add(shot.Event.Shot.Id);
                    if (receiver.Inbox.TryGetPose(out RemotePose pose))
                        agesUs.Add(clock.NowUs - pose.ReceivedTimeUs);
                }

                Volatile.Write(ref stops, true);
                hostile.Join();
                ids.AddRange(TakeShots(receiver.Inbox, 10 - ids.Count));
                Assert.That(ids, Is.EqualTo(Enumerable.Range(1, 10)));
                agesUs.Sort();
                Assert.That(agesUs[agesUs.Count / 2], Is.LessThan(250_000));
                Assert.That(receiver.Inbox.Dropped(RemoteDrop.Unsigned), Is.GreaterThan(1000));
            }
        }

        [Test]
        public void Receiver_Closed_FreesItsPortAtOnce()
        {
            IPEndPoint endPoint;
            using (RemoteReceiver receiver = Listen())
            {
                endPoint = receiver.EndPoint;
                Assert.That(endPoint.Address, Is.EqualTo(IPAddress.Loopback));
                InputException? problem = Assert.Throws<InputException>(() => new RemoteReceiver(new RemoteSettings { Port = endPoint.Port }, new WallClock()));
                Assert.That(problem!.Message, Does.Contain("port " + endPoint.Port));
            }

            new RemoteReceiver(new RemoteSettings { Port = endPoint.Port }, new WallClock()).Dispose();
        }

        [Test]
        public void Sender_NobodyListens_GoesOn()
        {
            IPEndPoint endPoint;
            using (RemoteReceiver receiver = Listen())
                endPoint = receiver.EndPoint;
            using (var sender = new RemoteSender(endPoint, null, new WallClock()))
            {
                for (int id = 1; id <= 5; id++)
                    sender.SendShot(EventExamples.PlainShot(id, id));
            }
        }

        private static void Flood(IPEndPoint to, ref bool stops)
        {
            byte[] packet = RemoteExamples.Bytes(RemoteExamples.Shot(1, 1, 1));
            using (var socket = new Socket(AddressFamily.InterNetwork, SocketType.Dgram, ProtocolType.Udp))
            {
                while (!Volatile.Read(ref stops))
                {
                    for (int i = 0; i < 10; i++)
                        socket.SendTo(packet, to);
                    Thread.Sleep(2);
                }
            }
        }
    }
}
