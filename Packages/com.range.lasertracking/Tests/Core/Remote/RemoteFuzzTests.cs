using System;
using System.Linq;
using LaserTracking.Session;
using NUnit.Framework;

namespace LaserTracking.Remote
{
    /// <summary>Mutated packets: whatever comes in is taken or counted, and never throws.</summary>
    public sealed class RemoteFuzzTests
    {
        [Test]
        public void Gate_MutatedPackets_NeverThrow() => Run(50_000);

        [Test]
        [Explicit("one million packets: four seconds a build and suite; 50,000 run in the test beside it")]
        public void Gate_MillionMutatedPackets_NeverThrow() => Run(1_000_000);

        private static void Run(int packets)
        {
            var clock = new TestClock();
            var random = new Random(5);
            var plain = new RemoteInbox(64);
            var keyed = new RemoteInbox(64);
            byte[][] seeds = Seeds(clock.NowUs);
            using (var plainGate = new RemoteGate(new RemoteSettings(), plain))
            using (var keyedGate = new RemoteGate(new RemoteSettings { Key = RemoteExamples.Key }, keyed))
            {
                var buffer = new byte[4096];
                for (int i = 0; i < packets; i++)
                {
                    int length = Mutate(seeds, random, buffer);
                    var packet = new ReadOnlySpan<byte>(buffer, 0, length);
                    plainGate.Accept(packet, RemoteExamples.Sender, clock.NowUs);
                    // Every other one correctly signed: what gets past the signature must be harmless too.
                    if (i % 2 == 0)
                        keyedGate.Accept(RemoteExamples.Sign(Latin1(packet), RemoteExamples.Key), RemoteExamples.Sender, clock.NowUs);
                    else
                        keyedGate.Accept(packet, RemoteExamples.Sender, clock.NowUs);
                    clock.NowUs += 100;
                    if (plain.TryTakeShot(out RemoteShot shot))
                        AssertSound(shot);
                    if (plain.TryGetPose(out RemotePose pose))
                        Assert.That(pose.Target.IsFinite || pose.Muzzle.IsFinite || pose.Palm.IsFinite, Is.True);
                    if (i % 1000 == 0)
                        seeds = Seeds(clock.NowUs);
                }
            }

            foreach (RemoteInbox inbox in new[] { plain, keyed })
            {
                long dropped = Enum.GetValues(typeof(RemoteDrop)).Cast<RemoteDrop>().Where(reason => reason != RemoteDrop.QueueFull).Sum(inbox.Dropped);
                Assert.That(inbox.Accepted + dropped, Is.EqualTo(packets), "each is taken or counted");
                Assert.That(inbox.Accepted, Is.GreaterThan(packets / 1000));
            }

            foreach (RemoteDrop reason in new[] { RemoteDrop.NotUtf8, RemoteDrop.NotJson, RemoteDrop.WrongField, RemoteDrop.OutOfRange, RemoteDrop.UnknownType, RemoteDrop.Stale, RemoteDrop.Replayed, RemoteDrop.Oversized })
                Assert.That(plain.Dropped(reason), Is.Positive, reason.ToString());
        }

        private static void AssertSound(in RemoteShot shot)
        {
            Assert.That(shot.Event.HasScreenPosition || shot.Event.Shot.Dot.PositionPx.IsFinite || shot.Aim.Target.IsFinite || shot.Aim.Direction.IsFinite, Is.True);
            Assert.That(shot.Event.Shot.Dot.Confidence, Is.InRange(0, 1));
            if (shot.Event.HasMuzzle)
                Assert.That(shot.Event.Direction.Length, Is.EqualTo(1).Within(1e-9));
        }

        private static byte[][] Seeds(long nowUs)
        {
            using (var writer = new MessageWriter(null))
            {
                return new[]
                {
                    writer.Shot(EventExamples.FullShot(), nowUs).ToArray(),
                    writer.Hand(EventExamples.Hand(3, 4000), nowUs).ToArray(),
                    RemoteExamples.Bytes(RemoteExamples.Published),
                    RemoteExamples.Bytes(RemoteExamples.Published.Replace("}", ",\"shot\":true}")),
                    RemoteExamples.Bytes(RemoteExamples.Shot(1, 1, nowUs)),
                    RemoteExamples.Sign(RemoteExamples.Shot(1, 1, nowUs), RemoteExamples.Key),
                };
            }
        }

        private static int Mutate(byte[][] seeds, Random random, byte[] buffer)
        {
            byte[] seed = seeds[random.Next(seeds.Length)];
            int length = seed.Length;
            seed.CopyTo(buffer, 0);
            for (int k = random.Next(4); k > 0 && length > 0; k--)
            {
                int at = random.Next(length);
                switch (random.Next(7))
                {
                    case 0:
                        buffer[at] ^= (byte)(1 << random.Next(8));
                        break;
                    case 1:
                        buffer[at] = (byte)"{}[]\",:0123456789-+eE.\\nutrfalse "[random.Next(33)];
                        break;
                    case 2:
                        length = at;
                        break;
                    case 3:
                        int more = Math.Min(random.Next(1, 64), buffer.Length - length);
                        Buffer.BlockCopy(buffer, at, buffer, at + more, length - at);
                        length += more;
                        break;
                    case 4:
                        int less = Math.Min(random.Next(1, 16), length - at);
                        Buffer.BlockCopy(buffer, at + less, buffer, at, length - at - less);
                        length -= less;
                        break;
                    case 5:
                        byte[] other = seeds[random.Next(seeds.Length)];
                        int part = Math.Min(random.Next(other.Length), length - at);
                        Buffer.BlockCopy(other, 0, buffer, at, part);
                        break;
                    default:
                        for (int digit = at; digit < length; digit++)
                        {
                            if (buffer[digit] >= '0' && buffer[digit] <= '9')
                            {
                                buffer[digit] = (byte)('0' + random.Next(10));
                                break;
                            }
                        }

                        break;
                }
            }

            if (random.Next(500) == 0)
                length = buffer.Length;
            return length;
        }

        // One char a byte: Sign encodes as UTF-8, so bytes above 127 change, which is as good a mutation as any.
        private static string Latin1(ReadOnlySpan<byte> bytes)
        {
            var chars = new char[bytes.Length];
            for (int i = 0; i < chars.Length; i++)
                chars[i] = (char)bytes[i];
            return new string(chars);
        }
    }
}
