using System;
using System.Linq;
using System.Net;
using System.Security.Cryptography;
using System.Text;
using LaserTracking.Session;
using NUnit.Framework;

namespace LaserTracking.Remote
{
    public sealed class RemoteGateTests
    {
        private readonly TestClock _clock = new TestClock();
        private RemoteInbox _inbox = new RemoteInbox(4);

        private RemoteGate Gate(RemoteSettings? settings = null)
        {
            _inbox = new RemoteInbox(4);
            return new RemoteGate(settings ?? new RemoteSettings(), _inbox);
        }

        private RemoteGate KeyedGate() => Gate(new RemoteSettings { Key = RemoteExamples.Key });

        private RemoteDrop Accept(RemoteGate gate, string text) => gate.Accept(RemoteExamples.Bytes(text), RemoteExamples.Sender, _clock.NowUs);

        private RemoteDrop Accept(RemoteGate gate, byte[] packet) => gate.Accept(packet, RemoteExamples.Sender, _clock.NowUs);

        [Test]
        public void Signature_IsTheOneOfTheRuntime()
        {
            byte[] packet = RemoteExamples.Sign("{}", RemoteExamples.Key);
            using (var hash = new HMACSHA256(Enumerable.Range(0, 32).Select(i => (byte)i).ToArray()))
            {
                string expected = "{}\n" + BitConverter.ToString(hash.ComputeHash(Encoding.ASCII.GetBytes("{}"))).Replace("-", "").ToLowerInvariant();
                Assert.That(Encoding.ASCII.GetString(packet), Is.EqualTo(expected));
            }
        }

        [Test]
        public void Gate_SignedShot_IsTaken()
        {
            using (RemoteGate gate = KeyedGate())
                Assert.That(Accept(gate, RemoteExamples.Sign(RemoteExamples.Shot(1, 1, _clock.NowUs), RemoteExamples.Key)), Is.EqualTo(RemoteDrop.None));
            Assert.That(_inbox.TryTakeShot(out RemoteShot shot), Is.True);
            Assert.That((shot.Event.Shot.Id, shot.ReceivedTimeUs), Is.EqualTo((1, _clock.NowUs)));
            Assert.That(_inbox.TryTakeShot(out _), Is.False);
        }

        [Test]
        public void Gate_AnyBitOfASignedPacketChanged_IsRefused()
        {
            using (RemoteGate gate = KeyedGate())
            {
                byte[] packet = RemoteExamples.Sign(RemoteExamples.Shot(1, 1, _clock.NowUs), RemoteExamples.Key);
                for (int bit = 0; bit < 8 * packet.Length; bit++)
                {
                    var changed = (byte[])packet.Clone();
                    changed[bit / 8] ^= (byte)(1 << (bit % 8));
                    Assert.That(Accept(gate, changed), Is.EqualTo(RemoteDrop.Forged).Or.EqualTo(RemoteDrop.Unsigned));
                }

                Assert.That(_inbox.Accepted, Is.Zero);
            }
        }

        [Test]
        public void Gate_WithAKey_TakesNothingWithoutSignatureOrCounter()
        {
            using (RemoteGate gate = KeyedGate())
            {
                Assert.That(Accept(gate, RemoteExamples.Shot(1, 1, _clock.NowUs)), Is.EqualTo(RemoteDrop.Unsigned));
                Assert.That(Accept(gate, RemoteExamples.Sign(RemoteExamples.Shot(1, 1, _clock.NowUs), RemoteKey.Parse(new string('a', 64), "other"))), Is.EqualTo(RemoteDrop.Forged));
                Assert.That(Accept(gate, RemoteExamples.Sign(RemoteExamples.Published, RemoteExamples.Key)), Is.EqualTo(RemoteDrop.WrongField));
                string head = "{\"stream\":5,\"counter\":1,\"sent_us\":" + _clock.NowUs + ",";
                Assert.That(Accept(gate, RemoteExamples.Sign(head + RemoteExamples.Published.Substring(1), RemoteExamples.Key)), Is.EqualTo(RemoteDrop.None));
            }
        }

        [Test]
        public void Gate_WithoutAKey_SaysSoToSignedPackets()
        {
            using (RemoteGate gate = Gate())
                Assert.That(Accept(gate, RemoteExamples.Sign(RemoteExamples.Shot(1, 1, _clock.NowUs), RemoteExamples.Key)), Is.EqualTo(RemoteDrop.NoKey));
        }

        [Test]
        public void Gate_ReplayedPacket_IsRefusedAlsoAmongOthers()
        {
            using (RemoteGate gate = KeyedGate())
            {
                byte[][] packets = Enumerable.Range(1, 30).Select(i => RemoteExamples.Sign(RemoteExamples.Hand(i, _clock.NowUs), RemoteExamples.Key)).ToArray();
                foreach (int i in new[] { 0, 2, 1, 5, 3, 29 })
                    Assert.That(Accept(gate, packets[i]), Is.EqualTo(RemoteDrop.None), "overtaken packets count");
                foreach (int i in new[] { 0, 1, 2, 3, 5, 29 })
                    Assert.That(Accept(gate, packets[i]), Is.EqualTo(RemoteDrop.Replayed));
                Assert.That(Accept(gate, packets[4]), Is.EqualTo(RemoteDrop.None));
            }
        }

        [Test]
        public void Gate_ReplayAfterTheSenderIsForgotten_IsStale()
        {
            using (RemoteGate gate = KeyedGate())
            {
                byte[] packet = RemoteExamples.Sign(RemoteExamples.Shot(1, 1, _clock.NowUs), RemoteExamples.Key);
                Accept(gate, packet);
                _clock.NowUs += 1_500_000;
                for (int stream = 1; stream <= 16; stream++)
                    Assert.That(Accept(gate, RemoteExamples.Sign(RemoteExamples.Hand(1, _clock.NowUs, stream), RemoteExamples.Key)), Is.EqualTo(RemoteDrop.None));
                Assert.That(Accept(gate, packet), Is.EqualTo(RemoteDrop.Stale));
            }
        }

        [TestCase(-250_001, RemoteDrop.Stale)]
        [TestCase(-250_000, RemoteDrop.None)]
        [TestCase(250_000, RemoteDrop.None)]
        [TestCase(250_001, RemoteDrop.Stale)]
        public void Gate_Age_HasItsLimits(long offsetUs, RemoteDrop expected)
        {
            using (RemoteGate gate = Gate())
                Assert.That(Accept(gate, RemoteExamples.Shot(1, 1, _clock.NowUs + offsetUs)), Is.EqualTo(expected));
        }

        [Test]
        public void Gate_ShotSentAgain_IsOneShot()
        {
            using (RemoteGate gate = Gate())
            {
                foreach (int id in new[] { 1, 1, 3, 2, 1, 2, 3, 4 })
                    Assert.That(Accept(gate, RemoteExamples.Shot(id, _inbox.Accepted + 1, _clock.NowUs)), Is.EqualTo(RemoteDrop.None));
                int[] ids = new int[4];
                for (int i = 0; i < 4; i++)
                {
                    _inbox.TryTakeShot(out RemoteShot shot);
                    ids[i] = shot.Event.Shot.Id;
                }

                Assert.That(ids, Is.EqualTo(new[] { 1, 3, 2, 4 }));
            }
        }

        [Test]
        public void Gate_FullQueue_IsCountedAndTheRepeatedShotStillComes()
        {
            using (RemoteGate gate = Gate())
            {
                for (int id = 1; id <= 5; id++)
                    Accept(gate, RemoteExamples.Shot(id, id, _clock.NowUs));
                Assert.That(_inbox.Dropped(RemoteDrop.QueueFull), Is.EqualTo(1));
                _inbox.TryTakeShot(out _);
                Accept(gate, RemoteExamples.Shot(5, 6, _clock.NowUs));
                int last = 0;
                while (_inbox.TryTakeShot(out RemoteShot shot))
                    last = shot.Event.Shot.Id;
                Assert.That(last, Is.EqualTo(5));
            }
        }

        [Test]
        public void Gate_Rate_IsTheSendersOwn()
        {
            using (RemoteGate gate = Gate())
            {
                long start = _clock.NowUs;
                int accepted = 0;
                for (int i = 1; i <= 2000; i++)
                {
                    _clock.NowUs = start + i * 1000;
                    accepted += Accept(gate, RemoteExamples.Hand(i, _clock.NowUs)) == RemoteDrop.None ? 1 : 0;
                }

                Assert.That(accepted, Is.EqualTo(1000), "500 in each of two seconds");
                Assert.That(_inbox.Dropped(RemoteDrop.TooFast), Is.EqualTo(1000));
                Assert.That(Accept(gate, RemoteExamples.Shot(1, 1, _clock.NowUs, 78)), Is.EqualTo(RemoteDrop.None), "another sender");
            }
        }

        [Test]
        public void Gate_MoreSendersThanPlaces_KeepsThoseItKnows()
        {
            using (RemoteGate gate = Gate())
            {
                for (int stream = 1; stream <= 16; stream++)
                    Accept(gate, RemoteExamples.Hand(1, _clock.NowUs, stream));
                Assert.That(Accept(gate, RemoteExamples.Hand(1, _clock.NowUs, 17)), Is.EqualTo(RemoteDrop.TooManySenders));
                Assert.That(Accept(gate, RemoteExamples.Hand(2, _clock.NowUs, 16)), Is.EqualTo(RemoteDrop.None));
                _clock.NowUs += 1_000_000;
                Assert.That(Accept(gate, RemoteExamples.Hand(1, _clock.NowUs, 17)), Is.EqualTo(RemoteDrop.None), "idle ones make room");
            }
        }

        [Test]
        public void Gate_WhatIsNoMessage_IsCountedByReasonAndToldOnce()
        {
            var settings = new RemoteSettings { AllowedSenders = new[] { IPAddress.Loopback } };
            using (RemoteGate gate = Gate(settings))
            {
                for (int round = 0; round < 2; round++)
                {
                    Assert.That(Accept(gate, new byte[2049]), Is.EqualTo(RemoteDrop.Oversized));
                    Assert.That(Accept(gate, new byte[] { 0x7B, 0xFF, 0x7D }), Is.EqualTo(RemoteDrop.NotUtf8));
                    Assert.That(Accept(gate, "hello"), Is.EqualTo(RemoteDrop.NotJson));
                    Assert.That(Accept(gate, new byte[0]), Is.EqualTo(RemoteDrop.NotJson));
                    Assert.That(gate.Accept(RemoteExamples.Bytes("{}"), new IPEndPoint(IPAddress.Parse("127.0.0.2"), 1), _clock.NowUs), Is.EqualTo(RemoteDrop.NotAllowed));
                }

                Assert.That(_inbox.Dropped(RemoteDrop.NotJson), Is.EqualTo(4));
                var texts = new System.Collections.Generic.List<string>();
                while (_inbox.TryTakeHealth(out HealthEvent health))
                    texts.Add(health.Kind + " " + health.Value + " " + health.Text);
                Assert.That(texts, Has.Count.EqualTo(4));
                Assert.That(texts, Has.All.Match("^Remote [24] remote input: [^\\n]+: [^\\n]+$"));
                Assert.That(texts.Distinct().Count(), Is.EqualTo(4));
                Accept(gate, "hello");
                Assert.That(_inbox.TryTakeHealth(out _), Is.False);
            }
        }

        [Test]
        public void Inbox_Poses_KeepTheNewestOfEachHand()
        {
            using (RemoteGate gate = Gate())
            {
                Assert.That(_inbox.TryGetPose(out _), Is.False);
                for (int i = 1; i <= 20; i++)
                {
                    _clock.NowUs += 1000;
                    Accept(gate, RemoteExamples.Hand(i, _clock.NowUs, 77, i % 10, "[" + i + ",0,0]"));
                }

                var poses = new RemotePose[RemoteInbox.PoseCapacity];
                Assert.That(_inbox.CopyPoses(poses), Is.EqualTo(8));
                Assert.That(poses.Select(pose => (int)pose.Muzzle.X), Is.EquivalentTo(Enumerable.Range(13, 8)));
                _inbox.TryGetPose(out RemotePose newest);
                Assert.That(newest.Muzzle.X, Is.EqualTo(20));
            }
        }

        [Test]
        public void Settings_Network_NeedsKeyAndSenders()
        {
            Assert.Throws<InputException>(() => new RemoteSettings { Address = IPAddress.Any }.Validate());
            Assert.Throws<InputException>(() => new RemoteSettings { Address = IPAddress.Any, Key = RemoteExamples.Key }.Validate());
            new RemoteSettings { Address = IPAddress.Any, Key = RemoteExamples.Key, AllowedSenders = new[] { IPAddress.Loopback } }.Validate();
            new RemoteSettings().Validate();
            Assert.Throws<ArgumentException>(() => new RemoteSettings { MaximumAgeMs = double.NaN }.Validate());
        }

        [TestCase("")]
        [TestCase("0123")]
        [TestCase("000102030405060708090a0b0c0d0e0g")]
        public void Key_ThatIsNone_IsRefusedWithoutRepeatingIt(string text)
        {
            InputException? problem = Assert.Throws<InputException>(() => RemoteKey.Parse(text, "range.key"));
            Assert.That(problem!.Message, Does.StartWith("range.key: "));
            Assert.That(text.Length == 0 || !problem.Message.Contains(text), Is.True);
        }
    }
}
