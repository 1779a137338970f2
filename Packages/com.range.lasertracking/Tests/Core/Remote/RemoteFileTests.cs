using System;
using System.IO;
using System.Threading;
using NUnit.Framework;

namespace LaserTracking.Remote
{
    public sealed class RemoteFileTests : RemoteFileFixture
    {
        [Test]
        public void File_ReplacedAgainAndAgain_GivesTheNewestPose()
        {
            using (RemoteFileReceiver receiver = Watch())
            {
                for (int i = 1; i <= 3; i++)
                {
                    RemoteFile.Write(FilePath, RemoteExamples.Bytes("{\n \"timestamp\": " + i + ",\n \"target\": [1, 2, " + i + "]\n}\n"));
                    int expected = i;
                    Assert.That(Wait(() => receiver.Inbox.TryGetPose(out RemotePose pose) && pose.Target.Z == expected), Is.True);
                }

                Assert.That(Directory.GetFiles(Folder), Has.Length.EqualTo(1));
                Assert.That(receiver.Inbox.TryTakeHealth(out _), Is.False);
            }
        }

        [Test]
        public void File_WithShotsSeenBefore_GivesTheNewOnes()
        {
            long nowUs = new WallClock().NowUs;
            using (RemoteFileReceiver receiver = Watch())
            {
                RemoteFile.Write(FilePath, RemoteExamples.Bytes(RemoteExamples.Shot(1, 1, nowUs) + "\n"));
                Assert.That(Wait(() => receiver.Inbox.TryTakeShot(out RemoteShot shot) && shot.Event.Shot.Id == 1), Is.True);
                nowUs = new WallClock().NowUs;
                RemoteFile.Write(FilePath, RemoteExamples.Bytes(RemoteExamples.Shot(1, 1, nowUs - 200_000) + "\n" + RemoteExamples.Shot(2, 2, nowUs) + "\n" + RemoteExamples.Shot(3, 3, nowUs)));
                Assert.That(Wait(() => receiver.Inbox.TryTakeShot(out RemoteShot shot) && shot.Event.Shot.Id == 2), Is.True);
                Assert.That(Wait(() => receiver.Inbox.TryTakeShot(out RemoteShot shot) && shot.Event.Shot.Id == 3), Is.True);
                Assert.That(receiver.Inbox.TryTakeShot(out _), Is.False);
            }
        }

        [Test]
        public void File_WithOneBrokenLine_CountsNotAtAllAndIsToldOnce()
        {
            using (RemoteFileReceiver receiver = Watch())
            {
                RemoteFile.Write(FilePath, RemoteExamples.Bytes(RemoteExamples.Published + "\n{\"timestamp\":2,\"tar"));
                Assert.That(Wait(() => receiver.Inbox.Dropped(RemoteDrop.NotJson) == 1), Is.True);
                Assert.That(receiver.Inbox.TryGetPose(out _), Is.False);
                RemoteFile.Write(FilePath, RemoteExamples.Bytes(RemoteExamples.Published));
                Assert.That(Wait(() => receiver.Inbox.TryGetPose(out _)), Is.True, "a good one comes through again");
                Assert.That(receiver.Inbox.Dropped(RemoteDrop.NotJson), Is.EqualTo(1));
            }
        }

        [Test]
        public void File_OfYesterday_IsStale()
        {
            File.WriteAllText(FilePath, RemoteExamples.Published);
            File.SetLastWriteTimeUtc(FilePath, DateTime.UtcNow.AddDays(-1));
            using (RemoteFileReceiver receiver = Watch())
            {
                Assert.That(Wait(() => receiver.Inbox.Dropped(RemoteDrop.Stale) == 1), Is.True);
                Assert.That(receiver.Inbox.TryGetPose(out _), Is.False);
            }
        }

        [Test]
        public void File_NameThatIsNone_IsRefused()
        {
            foreach (string name in new[] { "", Folder, "a\0b" })
                Assert.Throws<InputException>(() => new RemoteFileReceiver(name, new RemoteSettings(), new WallClock()));
        }

        [Test]
        public void File_InAFolderThatIsNotThere_CannotBeWritten()
        {
            Assert.Throws<InputException>(() => RemoteFile.Write(Path.Combine(Folder, "no", "a.json"), new byte[1]));
        }
    }
}
