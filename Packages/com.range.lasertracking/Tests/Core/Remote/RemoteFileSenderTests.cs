using System;
using System.Collections.Generic;
using System.IO;
using System.Linq;
using System.Threading;
using LaserTracking.Geometry;
using LaserTracking.Session;
using NUnit.Framework;

namespace LaserTracking.Remote
{
    public sealed class RemoteFileSenderTests : RemoteFileFixture
    {
        [Test]
        public void Sender_BurstsOfShots_ArriveOnceEachInOrder()
        {
            const int Count = 60;
            using (RemoteFileReceiver receiver = Watch())
            using (var sender = new RemoteFileSender(FilePath, new WallClock()))
            {
                var ids = new List<int>();
                for (int id = 1; id <= Count; id++)
                {
                    sender.SendShot(EventExamples.PlainShot(id, id));
                    sender.SendHand(new HandEvent { TimeUs = id, TrackId = id % 3, PalmM = new Vector3D(1, 1, -2), MuzzleM = new Vector3D(1, 1, -2) });
                    if (id % 20 == 0)
                        Thread.Sleep(30);
                }

                Wait(() =>
                {
                    while (receiver.Inbox.TryTakeShot(out RemoteShot shot))
                        ids.Add(shot.Event.Shot.Id);
                    return ids.Count >= Count;
                });
                Thread.Sleep(50);
                Assert.That(receiver.Inbox.TryTakeShot(out _), Is.False, "none comes twice");
                Assert.That(ids, Is.EqualTo(Enumerable.Range(1, Count)));
                Assert.That((sender.LostShots, sender.Failures), Is.EqualTo((0L, 0L)));
                Assert.That(receiver.Inbox.TryTakeHealth(out _), Is.False);
                Assert.That(receiver.Inbox.CopyPoses(new RemotePose[RemoteInbox.PoseCapacity]), Is.EqualTo(3));
            }
        }

        [Test]
        public void Sender_PublishedShots_AreNotTakenAgainWhenTheFileChanges()
        {
            using (RemoteFileReceiver receiver = Watch())
            using (var sender = new RemoteFileSender(FilePath, new WallClock()))
            {
                int shots = 0;
                for (int i = 0; i < 5; i++)
                {
                    sender.SendPublished(new RemotePose { TimeUs = i, Direction = new Vector3D(0, 0, 1), Target = new Vector3D(0, 0, 1000), Confidence = 1 }, i < 2);
                    Thread.Sleep(25);
                }

                Wait(() =>
                {
                    while (receiver.Inbox.TryTakeShot(out _))
                        shots++;
                    return shots >= 2;
                });
                Assert.That(receiver.Inbox.TryTakeShot(out _), Is.False);
                Assert.That((shots, receiver.Inbox.TryGetPose(out RemotePose pose), pose.TimeUs), Is.EqualTo((2, true, 4L)));
            }
        }

        [Test]
        public void Sender_FolderGone_GivesShotsUpAndSaysSo()
        {
            string folder = Path.Combine(Folder, "in");
            Directory.CreateDirectory(folder);
            var sender = new RemoteFileSender(Path.Combine(folder, "detector.json"), new WallClock());
            Directory.Delete(folder, true);
            sender.SendShot(EventExamples.PlainShot(1, 1));
            Assert.That(Wait(() => sender.Failures > 0), Is.True);
            sender.Dispose();
            Assert.That(sender.LostShots, Is.EqualTo(1));
        }

        [Test]
        public void Sender_FolderThatIsNotThere_IsRefusedAtOnce()
        {
            Assert.Throws<InputException>(() => new RemoteFileSender(Path.Combine(Folder, "no", "a.json"), new WallClock()));
        }
    }
}
